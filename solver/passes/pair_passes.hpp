// SPDX-License-Identifier: BSD-3-Clause
// The passes over pairs of particles, where the time goes: one table of functions per instruction set.
//
// A cluster of eight particles stays in registers while its common neighbours are loaded one by one and
// broadcast. Each particle sums over all its neighbours itself: a pair is computed from both sides, no two
// threads write the same memory, and the order of every sum is fixed by the list alone. Results are therefore
// the same bits for any number of threads.
#pragma once

#include <string>

#include "solver/core/execution.hpp"
#include "solver/passes/pass_input.hpp"
#include "solver/physics/density_bounds.hpp"

namespace wetdeck {

/// Update of the density of the particles [first, last), which are of one phase.
struct DensityUpdate {
    const double* rate = nullptr;  ///< [kg/(m^3 s)]
    const double* mass = nullptr;  ///< [kg/m]
    MixedFluid* mixed = nullptr;   ///< is kept up where there is one
    SharedClusters clusters;
    double dt = 0;  ///< [s]
    ClusterSweep sweep;
    struct Group {
        TaitEquationOfState eos;
        DensityBounds bounds;
    };
    std::array<Group, group_count> groups;
    bool graded = false;  ///< particles differ in their spacings
};

/// The passes of one model, compiled for one instruction set: the ingredients are chosen here, outside the
/// loops.
struct PairPasses {
    const char* instruction_set = "";
    Pass wall_means = nullptr;     ///< Eq. (19); writes new_wall_mean
    Pass density_rates = nullptr;  ///< Eq. (12), continuity
    Pass accelerations = nullptr;  ///< Eq. (12), momentum
    Pass body_forces = nullptr;    ///< Eq. (20); writes wall_force of bodies that have fluid near
    /// Density from its rate over dt, then volume and pressure, and the drift, in one sweep.
    void (*update_density)(FluidState*, const DensityUpdate&) = nullptr;
    NearFilter filter_near = nullptr;  ///< for the neighbour list
};

/// The passes for an instruction set ("sse2", "avx2", "avx512"; empty: the best of this processor). Throws
/// InputError if it is unknown or not supported here, or if the model has no passes in mixed precision or for
/// particles that differ in their spacings.
PairPasses pair_passes(const Model& model, const std::string& instruction_set = "",
                       Precision precision = Precision::double_precision, bool graded = false);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// What the passes over pairs read and write.
#pragma once

#include <array>
#include <vector>

#include "solver/neighbours/shared_clusters.hpp"
#include "solver/particles/mixed.hpp"
#include "solver/particles/walls.hpp"
#include "solver/passes/coefficients.hpp"
#include "solver/physics/wendland_c2.hpp"

namespace wetdeck {

/// Inputs and outputs of a pass. Pointers are valid for one pass.
struct PassInput {
    WendlandC2 kernel;
    Vec2 gravity = Vec2::Zero();  ///< [m/s^2]
    double particle_spacing = 0;  ///< [m]
    double wall_volume = 0;       ///< of each boundary particle of the finest spacing [m^2]
    double coarsest = 1;          ///< largest spacing over the finest; 1: all are equal
    bool wetting = false;         ///< dry walls do not compress the water
    std::array<double, phase_count> reference_density{};
    std::array<std::array<PairCoefficients, phase_count>, phase_count> pair;
    std::array<WallCoefficients, phase_count> wall_pair;
    std::array<bool, phase_count> wall_pressure_mean{};  ///< which phases take the Shepard pressure of walls
    double smallest_velocity = 0;                        ///< sum of two that a harmonic mean divides by [m/s]
    double smallest_pressure = 0;                        ///< the same of pressures [Pa]
    int threads = 1;

    const Model* model = nullptr;  ///< choices that are made at run time, outside the default scheme
    const FluidState* fluid = nullptr;
    const MixedFluid* mixed = nullptr;  ///< the same, for passes in mixed precision
    const WallState* wall = nullptr;
    const WallMean* wall_mean = nullptr;
    const double* wall_own_sum = nullptr;
    const double* wall_fineness = nullptr;    ///< read where spacings differ
    const NeighbourBlocks* blocks = nullptr;  ///< neighbours of all clusters
    SharedClusters clusters;
    const std::vector<Cluster>* wall_clusters = nullptr;

    /// Factor on the pairs of the slow fluid with itself and walls and on its weight; 0 leaves them out, in
    /// those steps of the fast fluid in which the slow one only drifts.
    double slow_weight = 1;
    /// Phase of each group: water and air, or water twice.
    std::array<std::size_t, group_count> phase_of = {0, 1};
    std::array<bool, group_count> loading = {true, true};  ///< groups whose forces on bodies count
    std::size_t fixed_walls = 0;  ///< boundary particles from here on belong to bodies

    double* density_rate = nullptr;
    double* kernel_sum = nullptr;  ///< of water; written by density_rates unless null
    double* acceleration_x = nullptr;
    double* acceleration_y = nullptr;
    WallMean* new_wall_mean = nullptr;
    double* wall_force_x = nullptr;
    double* wall_force_y = nullptr;
};

/// One pass over the pairs.
using Pass = void (*)(const PassInput&);

}  // namespace wetdeck

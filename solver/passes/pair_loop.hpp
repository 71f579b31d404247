// SPDX-License-Identifier: BSD-3-Clause
// The loops over pairs of particles, where the time goes, behind one table of functions per instruction set.
//
// Eight particles that are neighbours in space and of one phase form a cluster; they sit in registers while
// their common neighbours are loaded one by one and broadcast. Each particle sums over all its neighbours
// itself: a pair is computed from both sides, no two threads write the same place, and the order of every sum
// is fixed by the list alone. Results are therefore the same bits for any number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "solver/particles/particles.hpp"
#include "solver/physics/density_bounds.hpp"
#include "solver/physics/model.hpp"
#include "solver/physics/wendland_c2.hpp"

namespace wetdeck {

inline constexpr std::uint32_t cluster_width = 8;

/// Eight (or, at the end of a phase, fewer) adjacent particles of one phase and their common neighbours, by
/// kind.
struct Cluster {
    std::uint32_t first = 0;  ///< index of the first particle
    std::uint32_t count = 0;  ///< 1..8
    Phase phase = Phase::water;
    const std::uint32_t* neighbours = nullptr;  ///< water, then air, then wall indices
    std::array<std::uint32_t, phase_count> fluid_neighbours{};
    std::uint32_t wall_neighbours = 0;

    /// Index of the particle in a lane; the last one stands in for those that a smaller cluster lacks.
    std::uint32_t at(std::uint32_t lane) const { return first + std::min(lane, count - 1); }
};

/// Places of the particles of a cluster, by lane.
struct ClusterPoints {
    double x[cluster_width], y[cluster_width];
};

/// Coefficients of the formulas in physics/ for one ordered pair of phases.
struct PairCoefficients {
    double weight_right = 0.5;       ///< of u_R in the velocity mean
    double mobility = 0;             ///< pressure_diffusion / (2 mean(rho0 c)); the loop takes rho for rho0
    double hydrostatic_density = 0;  ///< of the hydrostatic part of the pressure jump
    double pressure_weight_left = 0.5, pressure_weight_right = 0.5;
    DissipationLimiter limiter;
    double viscosity = 0;            ///< lambda mu_ij / h [Pa s/m]
    double lowest_viscous_jump = 0;  ///< 0: only approaching pairs; very negative: both signs
    double half_density = 0;         ///< rho_ij / 2 of the switch dissipation
};

/// The same for pairs of a fluid particle with a boundary particle.
struct WallCoefficients {
    DissipationLimiter limiter;
    double viscosity = 0;  ///< lambda mu / h of a no-slip wall
    double lowest_viscous_jump = 0;
};

/// First clusters of as many consecutive shares of about the same number of neighbours as there are threads,
/// and an end mark. What is near walls, or in the middle of the fluid, costs more than what is at a surface.
/// Of steps of the air alone, in which water without air near costs next to nothing, with `only_air`.
std::vector<std::size_t> equal_shares(const std::vector<Cluster>& clusters, int threads,
                                      bool only_air = false);

/// What a pass reads and writes. Pointers stay valid for the pass only.
struct PassInput {
    WendlandC2 kernel;
    Vec2 gravity = Vec2::Zero();
    double wall_volume = 0;
    const FluidState* fluid = nullptr;
    const WallState* wall = nullptr;
    const WallMean* wall_mean = nullptr;
    WallMean* new_wall_mean = nullptr;                   ///< written by wall_means
    std::array<bool, phase_count> wall_pressure_mean{};  ///< which phases see the Shepard pressure of walls
    double particle_spacing = 0;
    std::array<double, phase_count> reference_density{};
    const std::vector<Cluster>* clusters = nullptr;
    const std::vector<std::size_t>* shares = nullptr;  ///< of the clusters, one a thread (equal_shares)
    const std::vector<Cluster>* wall_clusters = nullptr;
    std::array<std::array<PairCoefficients, phase_count>, phase_count> pair;
    std::array<WallCoefficients, phase_count> wall_pair;
    double velocity_guard = 0;  ///< of the harmonic velocity mean [m/s]
    double pressure_guard = 0;  ///< of the harmonic pressure mean [Pa]
    /// Factor on what water gets from water, walls and gravity, 0 to leave that out: the air may take steps
    /// of its own.
    double water_weight = 1;
    std::array<bool, phase_count> loading = {true, true};  ///< phases whose forces on bodies count
    double* density_rate = nullptr;
    double* cover = nullptr;  ///< of water, SUM_j V_j W_ij; written by density_rates unless null
    double* acceleration_x = nullptr;
    double* acceleration_y = nullptr;
    std::size_t fixed_walls = 0;  ///< boundary particles from here on belong to bodies
    double* wall_force_x = nullptr;
    double* wall_force_y = nullptr;
    int threads = 1;
};

using Pass = void (*)(const PassInput&);

/// The passes of one model compiled for one instruction set: ingredients are chosen here, outside the loops.
struct PairLoops {
    const char* instruction_set = "";
    Pass wall_means = nullptr;  ///< Eq. (19); writes wall_mean
    Pass density_rates = nullptr;
    Pass accelerations = nullptr;
    Pass body_forces = nullptr;  ///< Eq. (20); writes wall_force of bodies that have fluid near
    /// Sets density from its rate over dt, then volume and pressure, and moves on by half of dt, for
    /// particles [first, last): what a step does to each by itself once its rate is known, in one sweep.
    void (*advance_fluid)(FluidState*, const double* rate, const double* mass, std::size_t first,
                          std::size_t last, double dt, const TaitEquationOfState&, const DensityBounds&,
                          int threads) = nullptr;
    /// Writes to `out` which of the candidates [begin, end) are within `reach` of any of the points, and
    /// returns how many. It may write one entry beyond them.
    std::uint32_t (*filter_near)(const ClusterPoints& points, const double* candidate_x_y, std::size_t stride,
                                 std::uint32_t begin, std::uint32_t end, double reach,
                                 std::uint32_t* out) = nullptr;
};

/// The loops for the best instruction set of this processor, or for the one named ("sse2", "avx2", "avx512").
/// The environment variable WETDECK_SIMD names one too. Throws InputError if it is unknown or not supported
/// here.
PairLoops pair_loops(const Model& model, const char* instruction_set = nullptr);

/// Coefficients of an ordered pair of phases, or of a phase and a wall, under a model.
PairCoefficients pair_coefficients(const Model& model, Phase left, Phase right, double smoothing_length);
WallCoefficients wall_coefficients(const Model& model, Phase phase, double smoothing_length);

}  // namespace wetdeck

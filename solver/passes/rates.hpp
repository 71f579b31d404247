// SPDX-License-Identifier: BSD-3-Clause
// The model applied to a flow: neighbour list, means at walls, rates of density and velocity, loads on
// bodies.
//
// The substep weight says how often the pairs of the slow fluid with itself and walls count: the number of
// steps of the fast fluid in one of the slow, or 0 in those in which the slow one only drifts (see
// time/verlet.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <optional>

#include "solver/bodies/flow.hpp"
#include "solver/core/execution.hpp"
#include "solver/core/stage_timer.hpp"
#include "solver/core/team.hpp"
#include "solver/neighbours/neighbour_list.hpp"
#include "solver/neighbours/skin_choice.hpp"
#include "solver/passes/pair_passes.hpp"

namespace wetdeck {

/// The constants of a simulation that its rates depend on.
struct RatesSetup {
    Model model;                  ///< with both numbers of substeps resolved
    Execution execution;          ///< with threads resolved
    double particle_spacing = 0;  ///< [m]
    Box domain;                   ///< interior of the tank [m]
    double coarsest = 1;          ///< largest spacing over particle_spacing, the finest

    /// Whether particles differ in their spacings.
    bool graded() const { return coarsest > 1; }
    /// Whether the fast fluid is the fine water.
    bool fast_water() const { return model.coarse_substeps > 1; }
    /// Steps of the fast fluid in one of the slow.
    int substeps() const { return fast_water() ? model.coarse_substeps : model.air_substeps; }
};

/// What a thread meets in a sweep over the fluid, on cache lines of its own.
struct alignas(64) Met {
    static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
    std::array<double, phase_count> fastest2{}, densest{};  ///< by phase
    std::size_t first_bad = nobody;                         ///< particle

    /// Takes in what another thread has met.
    void join(const Met& other) {
        for (std::size_t k = 0; k < phase_count; ++k) {
            fastest2[k] = std::max(fastest2[k], other.fastest2[k]);
            densest[k] = std::max(densest[k], other.densest[k]);
        }
        first_bad = std::min(first_bad, other.first_bad);
    }
};

/// Evaluates rates. It owns the list of neighbours and no part of the flow.
class Rates {
  public:
    /// Sorts the tank's boundary particles along the grid of the list.
    Rates(const RatesSetup& setup, Flow& flow);

    /// Sorts the particles and lists their neighbours.
    void build_list(Flow& flow);
    /// Builds the list if particles that have moved by up to `farthest` [m] since the last call may have made
    /// it incomplete.
    void refresh_list(Flow& flow, double farthest);

    /// Whether a density pass with this weight reads the means at walls.
    bool means_in_density(double substep_weight) const;
    /// Pressure, velocity and kernel sum of the fluid around each boundary particle, where the model uses
    /// them.
    void wall_means(Flow& flow, double substep_weight);
    /// Density rates and, with a positive weight, kernel sums.
    void density(Flow& flow, double substep_weight);
    /// Accelerations of the fluid.
    void momentum(Flow& flow, double substep_weight);
    /// Loads on the bodies, Eqs. (20)-(21), and their accelerations. Those of the slow fluid are kept between
    /// its steps.
    /// @param remaining  time from the present velocities of the bodies to those at their poses [s]
    void body_loads(Flow& flow, double substep_weight, double remaining = 0);
    /// Marks the particles on which the dissipation switch is on, Eqs. (14)-(15).
    /// @param fastest  largest speed in the fluid [m/s]
    void mark_impacts(Flow& flow, double fastest);
    /// Densities from their rates over a step dt [s], volumes and pressures, and a drift. The kernel sum
    /// bounds the density of water in the steps that sum it.
    void update_density(Flow& flow, double dt, double substep_weight, const ClusterSweep& sweep);
    /// A sweep in which the fluid drifts for `drift` [s]. Clusters that rest are left out unless `all` are
    /// taken; the next sweep that takes them makes up for it, or a look at the list.
    ClusterSweep sweep(double drift, bool all);
    /// Moves the clusters that rest to where they are now.
    void bring_up(Flow& flow);
    /// The largest speed of a step of the slow fluid so far: that of this sweep [m/s], or of the first, which
    /// took all clusters.
    double fastest_of_step(double of_sweep, bool first) {
        fastest_at_first_ = first ? of_sweep : std::max(of_sweep, fastest_at_first_);
        return fastest_at_first_;
    }
    /// Room for what each thread meets, as new.
    std::vector<Met>& met() {
        std::fill(met_.begin(), met_.end(), Met{});
        return met_;
    }
    /// All clusters, for work on them.
    SharedClusters clusters() const { return shared(list_, list_.shares()); }

    /// All inputs of a pass over the present state; its outputs are not set.
    PassInput inputs(const Flow& flow) const;
    /// The fluid in single precision where the passes read it, to be kept up by who moves particles; else
    /// none.
    MixedFluid* mixed_fluid() const { return mixed_is_current_ ? &*mixed_ : nullptr; }
    /// Says that particles have been moved or sorted without it.
    void forget_mixed_fluid() { mixed_is_current_ = false; }
    /// See Simulation::momentum_error.
    double momentum_error(const Flow& flow) const;

    const RatesSetup& setup() const { return setup_; }
    WendlandC2 kernel() const { return constants_.kernel; }
    NeighbourList& list() { return list_; }
    const NeighbourList& list() const { return list_; }
    const char* instruction_set() const { return passes_.instruction_set; }
    /// Memory of the list and of the fluid in single precision [bytes].
    std::size_t bytes() const { return list_.bytes() + (mixed_ ? mixed_->bytes() : 0); }
    std::uint64_t list_builds() const { return list_builds_; }
    void set_list_builds(std::uint64_t count) { list_builds_ = count; }
    /// The skin of the list, where it is chosen.
    const SkinChoice& skin_choice() const { return skin_choice_; }
    /// For a list that is built again as it was at a checkpoint: call it before the build.
    void restore_skin(const SkinChoice& choice, const WallParticles& walls);
    /// The bodies as they were when the list was built.
    const std::vector<RigidBody>& listed_bodies() const { return listed_bodies_; }
    /// Particles that the steps of the fast fluid alone sum up: its own, and slow ones near it.
    std::uint64_t summed_in_each_step() const { return summed_in_each_step_; }
    StageTimes& stages() { return stages_; }
    const StageTimes& stages() const { return stages_; }

  private:
    PassInput pass_input(Flow& flow, double substep_weight) const;
    void sum_pairs(Pass pass, Flow& flow, double substep_weight);
    void set_state(PassInput& in, const Flow& flow, const NeighbourList& list) const;
    void refresh_mixed_fluid(const Flow& flow);
    void copy_mixed_fluid(const Flow& flow, const NeighbourList& list) const;
    double momentum_error(PassInput in, const Flow& flow) const;
    FrameForces frame_forces(const Flow& flow) const;
    bool chooses_skin() const { return setup_.execution.skin == 0; }
    void apply_skin(const WallParticles& walls);
    SharedClusters shared(const NeighbourList& list, const std::vector<std::size_t>& shares) const;
    /// Whether sweeps may leave clusters out: not where Shepard means of the air read the water.
    bool lets_rest() const { return setup_.model.wall_pressure != WallPressure::shepard; }
    DensityUpdate::Group density_update(const Flow& flow, std::size_t group, double dt,
                                        double substep_weight) const;
    void apply_sponge_layer(const FluidParticles& fluid,
                            std::initializer_list<std::vector<double>*> rates) const;

    RatesSetup setup_;
    PairPasses passes_;
    PassInput constants_;  ///< what stays the same over the run
    SkinChoice skin_choice_;
    NeighbourList list_;
    mutable std::optional<MixedFluid> mixed_;  ///< in mixed precision
    mutable bool mixed_is_current_ = false;    ///< whether it holds the fluid as it is now
    Team team_;
    std::vector<Met> met_;                   ///< of each thread
    mutable std::vector<NextCluster> next_;  ///< of the shares
    double left_out_ = 0;                    ///< time for which clusters that rest were left out [s]
    double fastest_at_first_ = 0;            ///< largest speed in the first sweep of a step [m/s]
    std::vector<RigidBody> listed_bodies_;
    std::uint64_t list_builds_ = 0, summed_in_each_step_ = 0;
    StageTimes stages_;
};

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The only time loop: particles, neighbour list, passes, velocity Verlet, time step, stage timers, stop
// reasons.
//
// One step (velocity Verlet as in Adami, Hu and Adams, 2012): half kick and half drift; density from the
// rates at the middle; half drift; accelerations at the end; half kick. Two passes over the pairs per step.
// Rigid bodies go through the same kicks and drifts. The air may take several such steps in one of the water:
// pairs of water with water and walls then count in the middle one (density) and the last (momentum) only,
// as many times as there are.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/bodies/rigid_body.hpp"
#include "solver/neighbours/neighbour_list.hpp"
#include "solver/particles/particles.hpp"
#include "solver/passes/pair_loop.hpp"
#include "solver/physics/model.hpp"
#include "solver/time/instability.hpp"
#include "solver/time/time_step.hpp"

namespace wetdeck {

/// Where the time of a run went.
struct StageTimes {
    double neighbours = 0;   ///< lists checked and built [wall seconds], as all here
    double density = 0;      ///< pass over the pairs for the density rates
    double momentum = 0;     ///< pass over the pairs for the accelerations
    double walls = 0;        ///< means at the walls
    double bodies = 0;       ///< loads on bodies
    double integration = 0;  ///< kicks, drifts, densities, places of bodies' particles
    double probes = 0;       ///< observer and watch
};

/// Fluid, walls and bodies under one model, and their march in time. The same arguments give the same bits on
/// any number of threads.
class Simulation {
  public:
    /// @param model   fluids and scheme; its threads are those that the loops use
    /// @param fluid   at rest or moving, with densities and masses set (set_initial_pressure)
    /// @param walls   of the tank, then of the bodies, whose particles are placed by the bodies' poses
    /// @param domain  interior of the tank [m]; particles that leave it by more than a support radius stop
    /// the run
    /// @param particle_spacing  of the lattice that the fluid was laid on [m]
    /// @param bodies  in the order of the numbers that their boundary particles carry
    ///
    /// Throws InputError where the model contradicts itself or a body that is free to move has no mass, and
    /// std::out_of_range where a boundary particle carries the number of no body.
    Simulation(const Model& model, FluidParticles fluid, WallParticles walls, double particle_spacing,
               Box domain, std::vector<RigidBody> bodies = {});

    /// Called after the first evaluation and after every step.
    using Observer = std::function<void(const Simulation&)>;

    /// Looks for what single steps do not notice; called every 64 steps and at the end, before the observer.
    using Watch = std::function<std::optional<Instability>(const Simulation&)>;

    /// Runs until `end` [s] or until the run becomes unstable, which is returned.
    std::optional<Instability> run(double end, const Observer& observe, const Watch& watch = {});

    /// One step of the water of the given size at most. Returns what went wrong, if anything.
    std::optional<Instability> step(double longest);

    const Model& model() const { return model_; }                     ///< as given, air_substeps as taken
    const FluidParticles& fluid() const { return fluid_; }            ///< sorted: `id` tells who is who
    const WallParticles& walls() const { return walls_; }             ///< of the tank, then of bodies
    const std::vector<RigidBody>& bodies() const { return bodies_; }  ///< in the order given
    Box domain() const { return domain_; }                            ///< interior of the tank [m]
    double particle_spacing() const { return particle_spacing_; }     ///< [m]
    WendlandC2 kernel() const { return kernel_; }                     ///< with its smoothing length
    double time() const { return time_; }                             ///< since the start [s]
    std::uint64_t steps() const { return steps_; }                    ///< done so far, of the water
    std::uint64_t particle_steps() const { return particle_steps_; }  ///< rates summed so far, of both phases
    TimeStep time_step() const { return time_step_; }                 ///< the stable one of the last step
    const StageTimes& stage_times() const { return stages_; }         ///< so far

    /// Steps whose size each criterion set, in the order of LimitingCriterion.
    const std::array<std::uint64_t, limiting_criterion_names.size()>& limiting_counts() const {
        return limits_;
    }
    std::uint64_t list_builds() const { return list_builds_; }              ///< so far
    const NeighbourList& neighbours() const { return list_; }               ///< as last built
    const char* instruction_set() const { return loops_.instruction_set; }  ///< "sse2", "avx2" or "avx512"
    int threads() const { return threads_; }                                ///< of the loops

    /// Memory of particles and lists over the number of fluid particles.
    double bytes_per_particle() const;

    /// Particles for a test to disturb; rates are those of the last evaluation.
    FluidParticles& disturb() { return fluid_; }
    /// Rates of the present state, without moving anything.
    void evaluate();
    /// What the fluid's momentum gains besides gravity and the reactions of walls and bodies, over the sum of
    /// the sizes of all forces: rounding, unless a pair of forces is not opposite. One momentum pass over the
    /// present state.
    double momentum_error() const;

    /// All that passes read of the present state, for who runs one by itself; its outputs are not set.
    PassInput inputs() const;

    /// Everything that decides the bits of what follows, with counters and timers.
    struct State {
        std::map<std::string, std::vector<double>> arrays;  ///< of particles and bodies, by name
        std::map<std::string, double> numbers;              ///< by name
    };
    /// For a checkpoint.
    State state() const;
    /// Takes up where a simulation of the same set-up stood: the steps to come have the same bits. Throws
    /// DataError for the state of another set-up.
    void restore(const State& state);

  private:
    PassInput pass_input();
    std::optional<Instability> substep(double dt, int number);
    double momentum_error(PassInput in, const FluidParticles& fluid, const WallParticles& walls) const;
    TimeStep stable_step() const;
    void build_list();
    double kick_and_drift(double half);
    void advance_and_drift(double dt);
    void refresh_list(double farthest);
    std::optional<Instability> last_kick(double dt);
    std::optional<Instability> body_trouble() const;
    void mark_impacts();
    void soak(std::initializer_list<std::vector<double>*> rates);
    void density_pass();
    void wall_pass();
    void momentum_pass();
    void advance_fluid(double dt);
    void attach_fluid();
    void load_bodies();
    void sum_body_loads(std::array<bool, phase_count> phases);
    void place_bodies();

    Model model_;
    FluidParticles fluid_;
    WallParticles walls_;
    std::vector<RigidBody> bodies_;
    std::vector<double> body_radii_;          ///< of the farthest boundary particle about the mass centre [m]
    std::vector<BodyLoad> body_loads_;        ///< scratch of load_bodies
    std::vector<Eigen::Matrix2d> body_axes_;  ///< scratch of place_bodies
    std::vector<RigidBody> built_bodies_;     ///< as they were when the list was built
    double particle_spacing_;
    Box domain_;
    WendlandC2 kernel_;
    int threads_;
    PairLoops loops_;
    mutable NeighbourList list_;  ///< periodic images are scratch of who reads the state
    PassInput coefficients_;      ///< what stays the same over the run
    double time_ = 0;
    std::uint64_t steps_ = 0;
    std::uint64_t particle_steps_ = 0;
    std::uint64_t water_near_air_ = 0;  ///< particles of water that the steps of the air look at
    double water_weight_ = 1;           ///< PassInput::water_weight of the present pass
    std::uint64_t list_builds_ = 0;
    std::array<double, phase_count> fastest_{};      ///< largest speed [m/s]
    std::array<double, phase_count> densest_{1, 1};  ///< largest density over the reference, at least 1
    TimeStep time_step_;
    std::array<std::uint64_t, limiting_criterion_names.size()> limits_{};
    StageTimes stages_;
};

}  // namespace wetdeck

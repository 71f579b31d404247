// SPDX-License-Identifier: BSD-3-Clause
// A simulation: a flow (fluid, walls, bodies), its rates, and its march in time. Build it, step it, read it,
// store its state. The only time loop is here; one step is in time/verlet.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/time/time_step.hpp"
#include "solver/time/verlet.hpp"

namespace wetdeck {

/// What a simulation is made of.
struct SimulationSetup {
    Model model;                  ///< fluids and scheme
    FluidParticles fluid;         ///< with densities and masses set (set_initial_pressure); where spacings
                                  ///< differ, with the fineness of each particle
    WallParticles walls;          ///< of the tank, then of the bodies
    double particle_spacing = 0;  ///< of the lattice that the fluid was laid on, the finest [m]
    Box domain;                   ///< interior of the tank [m]
    std::vector<RigidBody> bodies = {};  ///< in the order of the numbers that their boundary particles carry
    Execution execution = {};            ///< threads, neighbour list, instruction set
    MovingFrame tank_motion = {};        ///< of the tank; it cannot be periodic or have a sponge layer then
    double coarsest = 1;                 ///< largest spacing over the finest; 1: all are equal
};

/// Fluid, walls and bodies under one model, and their march in time. The same set-up gives the same bits on
/// any number of threads. A copy is a simulation of its own.
class Simulation {
  public:
    /// Boundary particles of bodies are placed by the bodies' poses. Particles that leave the domain by more
    /// than a support radius make the run unstable.
    ///
    /// Throws InputError where the model contradicts itself or a body that is free to move has no mass, and
    /// std::out_of_range where a boundary particle carries the number of no body.
    explicit Simulation(SimulationSetup setup);

    /// Called after the first evaluation and after every step.
    using Observer = std::function<void(const Simulation&)>;

    /// Looks for what single steps do not notice; called every 64 steps and at the end, before the observer.
    using StabilityMonitor = std::function<std::optional<Instability>(const Simulation&)>;

    /// Runs until `end` [s] or until the run becomes unstable, which is returned.
    /// @param each_step  looks after every step, before the observer
    std::optional<Instability> run(double end, const Observer& observe, const StabilityMonitor& monitor = {},
                                   const StabilityMonitor& each_step = {});

    /// One step of the water of the given size at most. Returns what has left its range, if anything.
    std::optional<Instability> step(double longest);

    /// Lets go of the free degrees of freedom of a body that is held, from the next step on.
    void release(std::size_t body) { flow_.bodies.at(body).guide.release_time = flow_.time; }

    const Model& model() const { return rates_.setup().model; }  ///< substeps, wall_wetting resolved
    int substeps() const { return rates_.setup().substeps(); }   ///< of the fast fluid in each step
    const Execution& execution() const { return rates_.setup().execution; }  ///< threads resolved
    const FluidParticles& fluid() const { return flow_.fluid; }  ///< sorted: `id` identifies a particle
    const WallParticles& walls() const { return flow_.walls; }   ///< of the tank, then of bodies
    const std::vector<RigidBody>& bodies() const { return flow_.bodies; }        ///< in the order given
    Box domain() const { return rates_.setup().domain; }                         ///< of the tank [m]
    double particle_spacing() const { return rates_.setup().particle_spacing; }  ///< the finest [m]
    double coarsest() const { return rates_.setup().coarsest; }  ///< largest spacing over the finest
    bool graded() const { return rates_.setup().graded(); }      ///< whether spacings differ

    /// Spacing that a fluid particle was laid at [m].
    double spacing_of(const FluidState& p) const {
        return graded() ? particle_spacing() / p.fineness : particle_spacing();
    }
    WendlandC2 kernel() const { return rates_.kernel(); }  ///< of the finest spacing, with its length h
    double time() const { return flow_.time; }             ///< since the start [s]
    std::uint64_t steps() const { return steps_; }         ///< of the water, so far
    std::uint64_t particle_steps() const { return particle_steps_; }        ///< rates summed so far
    TimeStep time_step() const { return time_step_; }                       ///< of the last step
    TimeStep next_step() const { return step_of(model(), stable_step()); }  ///< unless it is shortened
    const StageTimes& stage_times() const { return rates_.stages(); }       ///< so far

    /// Steps whose size each criterion set, in the order of LimitingCriterion.
    const std::array<std::uint64_t, limiting_criterion_names.size()>& limiting_counts() const {
        return limits_;
    }
    std::uint64_t list_builds() const { return rates_.list_builds(); }        ///< so far
    const NeighbourList& neighbours() const { return rates_.list(); }         ///< as last built
    const char* instruction_set() const { return rates_.instruction_set(); }  ///< "sse2", "avx2" or "avx512"
    int threads() const { return execution().threads; }                       ///< of the passes

    /// Memory of particles and lists over the number of fluid particles.
    double bytes_per_particle() const;

    /// Particles for a test to disturb; rates are those of the last evaluation.
    FluidParticles& disturb() { return flow_.fluid; }
    /// Rates of the present state, without moving anything.
    void evaluate();
    /// What the fluid's momentum gains besides gravity and the reactions of walls and bodies, over the sum of
    /// the sizes of all forces: rounding, unless a pair of forces is not opposite. One momentum pass over the
    /// present state.
    double momentum_error() const { return rates_.momentum_error(flow_); }

    /// All inputs of a pass over the present state; its outputs are not set.
    PassInput inputs() const { return rates_.inputs(flow_); }

    /// Everything that decides the bits of the steps to come, with counters and timers.
    struct State {
        std::map<std::string, std::vector<double>> arrays;  ///< of particles and bodies, by name
        std::map<std::string, double> numbers;              ///< by name
    };
    /// For a checkpoint.
    State state() const;
    /// Takes over the state of a simulation of the same set-up: the steps to come have the same bits. Throws
    /// DataError for the state of another set-up.
    void restore(const State& state);

  private:
    Simulation(const RatesSetup& setup, Flow flow);
    TimeStep stable_step() const;

    Flow flow_;
    Rates rates_;
    StabilityBounds bounds_;
    Extremes extremes_;
    std::uint64_t steps_ = 0, particle_steps_ = 0;
    TimeStep time_step_;
    std::array<std::uint64_t, limiting_criterion_names.size()> limits_{};
};

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Generated models and particle sets.
#pragma once

#include <array>
#include <cmath>
#include <ostream>
#include <vector>

#include "solver/setup/lattice.hpp"
#include "tests/property/generated.hpp"
#include "tests/support/samples.hpp"

namespace wetdeck::generated {

inline constexpr double spacing = 0.05;
inline constexpr int cells = 10;  ///< of the lattice that the particles are drawn on, along each axis

/// A particle somewhere in a cell of the lattice.
struct Particle {
    bool air = false, impact = false;
    int column = 0, row = 0;
    double x = 0, y = 0;  ///< place in the cell, from its middle [spacings]
    double vx = 0, vy = 0;
    double compression = 0;  ///< of [-1, 1], times the range of its phase
};

inline std::ostream& operator<<(std::ostream& out, const Particle& p) {
    return out << (p.air ? "air" : "water") << " at cell " << p.column << ", " << p.row << " + (" << p.x
               << ", " << p.y << "), v (" << p.vx << ", " << p.vy << "), compression " << p.compression
               << (p.impact ? ", impact" : "");
}

/// Particles in cells of their own, shaken by up to 0.35 spacings.
inline rc::Gen<std::vector<Particle>> particles(double speed = 2) {
    const auto one = rc::gen::build<Particle>(
        rc::gen::set(&Particle::air), rc::gen::set(&Particle::impact),
        rc::gen::set(&Particle::column, whole(0, cells - 1)),
        rc::gen::set(&Particle::row, whole(0, cells - 1)), rc::gen::set(&Particle::x, number(-0.35, 0.35)),
        rc::gen::set(&Particle::y, number(-0.35, 0.35)), rc::gen::set(&Particle::vx, number(-speed, speed)),
        rc::gen::set(&Particle::vy, number(-speed, speed)),
        rc::gen::set(&Particle::compression, number(-1, 1)));
    return rc::gen::uniqueBy<std::vector<Particle>>(
        one, [](const Particle& p) { return p.row * cells + p.column; });
}

/// At least `least` particles; sizes that rapidcheck grows over the inputs of a property.
inline std::vector<Particle> draw_particles(std::size_t least, double speed = 2) {
    return *rc::gen::suchThat(rc::gen::scale(0.7, particles(speed)), [least](const auto& drawn) {
                return drawn.size() >= least;
            }).as("particles");
}

/// The ingredients of the scheme in any combination.
inline Model draw_model() {
    Model model = samples::two_phase_model();
    model.water.viscosity = 20;  // large enough for the viscous part to show beside the others
    model.air.viscosity = 0.5;
    const auto means = {Mean::arithmetic, Mean::density_weighted, Mean::impedance_weighted, Mean::harmonic};
    model.velocity_mean = one_of("velocity mean", means);
    model.pressure_mean = one_of("pressure mean", means);
    model.dissipation =
        one_of("dissipation", {Dissipation::none, Dissipation::riemann, Dissipation::low_dissipation});
    model.viscosity = one_of("viscosity", {Viscosity::none, Viscosity::approaching, Viscosity::symmetric});
    model.dissipation_switch = one_of("dissipation switch", {false, true});
    model.hydrostatic_correction = one_of("hydrostatic correction", {false, true});
    model.wall_slip = one_of("wall slip", {WallSlip::free, WallSlip::no});
    model.wall_pressure = one_of(
        "wall pressure", {WallPressure::one_sided, WallPressure::shepard, WallPressure::shepard_water});
    model.wall_velocity = one_of("wall velocity", {WallVelocity::normal, WallVelocity::mirrored});
    model.pressure_diffusion = *number(0, 1).as("pressure diffusion");
    model.air_dissipation = *number(0, 0.5).as("air dissipation");
    model.wall_dissipation = *number(0, 3).as("wall dissipation");
    return model;
}

inline void add(samples::Setup& setup, const Particle& drawn) {
    const Phase phase = drawn.air ? Phase::air : Phase::water;
    const double reference = (drawn.air ? setup.model.air : setup.model.water).eos.reference_density;
    const Vec2 middle(drawn.column + 0.5, drawn.row + 0.5);
    setup.fluid.add(phase, spacing * (middle + Vec2(drawn.x, drawn.y)), reference * spacing * spacing,
                    reference * (1 + (drawn.air ? 0.1 : 0.01) * drawn.compression));
    FluidState& state = setup.fluid.state.back();
    state.vx = drawn.vx;
    state.vy = drawn.vy;
    state.impact = drawn.impact ? 1 : 0;
}

/// The particles in a tank of `cells` spacings a side, which has walls or not.
inline samples::Setup setup_of(const Model& model, const std::vector<Particle>& particles, bool with_walls) {
    samples::Setup setup{model, {}, {}, spacing, Box{{0, 0}, Vec2::Constant(cells * spacing)}};
    for (const bool air : {false, true}) {
        for (const Particle& particle : particles)
            if (particle.air == air) add(setup, particle);
    }
    if (with_walls) setup.walls = tank_walls(setup.domain, spacing, 2 * model.smoothing_ratio * spacing);
    return setup;
}

/// Rates of two evaluations, compared by phase and kind. A difference counts beside the largest rate of its
/// phase and kind and beside slow ones: a change by the whole density in a second, and 1 m/s^2.
class RateDifference {
  public:
    /// Density rate and acceleration of one particle.
    using Rates = std::array<double, 3>;

    void add(bool water, double reference_density, const Rates& expected, const Rates& found) {
        add(kinds_[water ? 0 : 1], std::abs(expected[0] - found[0]) / reference_density,
            std::abs(expected[0]) / reference_density);
        add(kinds_[water ? 2 : 3], std::hypot(expected[1] - found[1], expected[2] - found[2]),
            std::hypot(expected[1], expected[2]));
    }
    double largest() const {
        double worst = 0;
        for (const Kind& kind : kinds_) worst = std::max(worst, kind.difference / kind.scale);
        return worst;
    }

  private:
    struct Kind {
        double difference = 0, scale = 1;
    };
    static void add(Kind& kind, double difference, double size) {
        kind.difference = std::max(kind.difference, difference);
        kind.scale = std::max(kind.scale, size);
    }
    std::array<Kind, 4> kinds_;
};

}  // namespace wetdeck::generated

// SPDX-License-Identifier: BSD-3-Clause
// Equation of state, time step and neighbour list for any input in their range.
#include <cmath>

#include "solver/time/time_step.hpp"
#include "tests/property/generated_fluid.hpp"
#include "tests/support/reference_rates.hpp"

using namespace wetdeck;

namespace {

TaitEquationOfState draw_law() {
    TaitEquationOfState law;
    law.reference_density = *generated::number(0.5, 2000).as("reference density");
    law.sound_speed = *generated::number(5, 1500).as("sound speed");
    law.exponent = *generated::number(1, 8).as("exponent");
    law.background_pressure = *generated::number(0, 1e5).as("background pressure");
    return law;
}

bool close(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

Material draw_material(const char* name, double density) {
    Material material;
    material.eos = {density, *generated::number(5, 100).as(std::string("sound speed of ") + name), 7, 0};
    material.viscosity = *generated::number(0, 5).as(std::string("viscosity of ") + name);
    return material;
}

/// Between the rates of a simulation and those of all pairs without a list.
double difference_to_all_pairs(const Simulation& simulation) {
    const FluidParticles& fluid = simulation.fluid();
    const Model& model = simulation.model();
    const samples::Rates all = samples::reference_rates(fluid, simulation.walls(), model, generated::spacing);
    generated::RateDifference difference;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const bool water = fluid.phase(i) == Phase::water;
        difference.add(water, (water ? model.water : model.air).eos.reference_density,
                       {all.density[i], all.acceleration_x[i], all.acceleration_y[i]},
                       {fluid.density_rate[i], fluid.acceleration_x[i], fluid.acceleration_y[i]});
    }
    return difference.largest();
}

}  // namespace

TEST_CASE("The equation of state returns the density and the pressure that it was given",
          "[generated][state]") {
    generated::check(300, [] {
        const TaitEquationOfState law = draw_law();
        const double density = law.reference_density * *generated::number(0.3, 3).as("density ratio");
        RC_ASSERT(close(law.density(law.pressure(density)), density, 1e-11));
        const double excess =
            law.coefficient() * *generated::number(-0.9, 20).as("excess pressure over coefficient");
        const double pressure = law.background_pressure + excess;
        const double scale = law.coefficient() + std::abs(pressure);
        RC_ASSERT(std::abs(law.pressure(law.density(pressure)) - pressure) <= 1e-12 * scale);
    });
}

TEST_CASE("Pressure grows with density, and compression to either side takes energy", "[generated][state]") {
    generated::check(300, [] {
        const TaitEquationOfState law = draw_law();
        const double ratio = *generated::number(0.3, 3).as("density ratio");
        const double more = ratio * (1 + *generated::number(1e-6, 1).as("compression"));
        const auto pressure = [&](double r) { return law.pressure(r * law.reference_density); };
        RC_ASSERT(pressure(more) > pressure(ratio));
        const double energy = law.compression_energy(ratio * law.reference_density, pressure(ratio));
        RC_ASSERT(energy >= -1e-12 * law.sound_speed * law.sound_speed);
        if (std::abs(ratio - 1) > 1e-3) RC_ASSERT(energy > 0);
    });
}

TEST_CASE("The stable time step never grows with a sound speed, a speed, a viscosity or gravity",
          "[generated][time]") {
    generated::check(300, [] {
        Model model = samples::two_phase_model();
        model.water = draw_material("water", 1000);
        model.air = draw_material("air", 1);
        model.viscosity = generated::one_of("viscosity", {Viscosity::none, Viscosity::symmetric});
        model.gravity = {0, -*generated::number(0, 20).as("gravity")};
        const double h = *generated::number(1e-3, 0.1).as("smoothing length");
        std::array<double, phase_count> fastest = {*generated::number(0, 20).as("speed of water"),
                                                   *generated::number(0, 20).as("speed of air")};
        const bool has_water = generated::one_of("water", {true, false});
        const bool has_air = !has_water || generated::one_of("air", {true, false});
        const auto size = [&] { return stable_time_step(model, h, {fastest}, has_water, has_air).size; };
        const double before = size();
        RC_ASSERT(before > 0);
        RC_ASSERT(std::isfinite(before));
        if (has_water)
            RC_ASSERT(before <= model.courant_number * h / (model.water.eos.sound_speed + fastest[0]));
        if (has_air) RC_ASSERT(before <= model.courant_number * h / (model.air.eos.sound_speed + fastest[1]));
        RC_ASSERT(stable_time_step(model, 2 * h, {fastest}, has_water, has_air).size >= before);
        double* larger[] = {&model.water.eos.sound_speed,
                            &model.air.eos.sound_speed,
                            &model.water.viscosity,
                            &model.air.viscosity,
                            &model.gravity.y(),
                            &fastest[0],
                            &fastest[1]};
        *larger[*generated::whole(0, 6).as("which grows")] *= 1 + *generated::number(0, 10).as("by");
        RC_ASSERT(size() <= before);
    });
}

TEST_CASE("Twice the sound speed of still water halves the step that sound limits", "[generated][time]") {
    generated::check(200, [] {
        Model model = samples::two_phase_model();
        model.water = draw_material("water", 1000);
        model.viscosity = Viscosity::none;
        model.gravity = Vec2::Zero();
        const double h = *generated::number(1e-3, 0.1).as("smoothing length");
        const auto size = [&] { return stable_time_step(model, h, {}, true, false).size; };
        const double before = size();
        RC_ASSERT(close(before, model.courant_number * h / model.water.eos.sound_speed, 1e-14));
        model.water.eos.sound_speed *= 2;
        RC_ASSERT(close(size(), before / 2, 1e-14));
    });
}

TEST_CASE("The neighbour list holds every pair that matters, whatever the motion",
          "[generated][neighbours]") {
    generated::check(80, [] {
        const Model model = samples::two_phase_model();
        const bool chosen = generated::one_of("chosen skin", {true, false});
        const double skin = chosen ? 0 : *generated::number(0.02, 0.5).as("skin");
        std::vector<generated::Particle> particles = generated::draw_particles(2, 1);
        const double a = *generated::number(-15, 15).as("stretching"),
                     b = *generated::number(-15, 15).as("rotation"), c = *generated::number(-5, 5).as("wind");
        for (generated::Particle& p : particles) {
            const Vec2 place = generated::spacing * Vec2(p.column - 5, p.row - 5);
            p.vx += c + a * place.x() - b * place.y();
            p.vy += b * place.x() - a * place.y();
        }
        samples::Setup setup =
            generated::setup_of(model, particles, generated::one_of("walls", {true, false}));
        setup.execution.skin = skin;
        Simulation simulation = setup.simulate();
        RC_ASSERT(difference_to_all_pairs(simulation) < 1e-9);
        for (int n = 0; n < 12; ++n) {
            if (simulation.step(1)) break;  // single particles may leave the range of a fluid
            simulation.evaluate();
            RC_ASSERT(difference_to_all_pairs(simulation) < 1e-9);
        }
    });
}

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/setups.hpp"

#include "solver/setup/lattice.hpp"
#include "validation/store/environment.hpp"

namespace wetdeck::verification {

Model water_model(double sound_speed, double gravity) {
    Model model;
    model.water.eos = {water_density, sound_speed, 7, 0};
    model.air.eos = {air_density, sound_speed, 1.4, 0};
    model.gravity = {0, -gravity};
    model.coarse_substeps = 0;  // as in scenes
    return model;
}

Model two_phase_model(double water_sound_speed, double air_sound_speed, double background_pressure,
                      double gravity) {
    Model model = water_model(water_sound_speed, gravity);
    model.water.eos.background_pressure = background_pressure;
    model.air.eos = {air_density, air_sound_speed, 1.4, background_pressure};
    model.air_substeps = 0;  // as in scenes
    return model;
}

Setup::Setup(const Model& model_, Box domain_, double particle_spacing_, bool with_walls)
    : SimulationSetup{model_, {}, {}, particle_spacing_, domain_} {
    execution.threads = 1;
    execution.instruction_set = instruction_set_from_environment();
    if (with_walls)
        walls =
            tank_walls(domain, particle_spacing, 2 * model.smoothing_ratio * particle_spacing, model.ends());
}

void Setup::fill(Phase phase, Box box) {
    const Material& material = phase == Phase::water ? model.water : model.air;
    fill_box(fluid, phase, box, particle_spacing, material.eos.reference_density);
}

void Setup::fill_around(Phase phase, Box box) {
    fill(phase, {domain.low, {domain.high.x(), box.low.y()}});
    fill(phase, {{domain.low.x(), box.high.y()}, domain.high});
    fill(phase, {{domain.low.x(), box.low.y()}, {box.low.x(), box.high.y()}});
    fill(phase, {{box.high.x(), box.low.y()}, {domain.high.x(), box.high.y()}});
}

void Setup::fill_graded(double level, const Grading& grading) {
    const Box wet{domain.low, {domain.high.x(), level}}, dry{{domain.low.x(), level}, domain.high};
    std::vector<Box> cells = graded_cells(wet, grading);
    fill_cells(fluid, Phase::water, cells, grading.finest, model.water.eos.reference_density);
    if (dry.high.y() > dry.low.y()) {
        const std::vector<Box> above = graded_cells(dry, grading);
        cells.insert(cells.end(), above.begin(), above.end());
    }
    const int layers = boundary_layers(2 * model.smoothing_ratio * grading.finest, grading.finest);
    walls = graded_tank_walls(domain, cells, grading.finest, layers, model.ends());
    coarsest = coarsest_over_finest(fluid, walls);
}

void Setup::spin_water(double rotation) {
    for (std::size_t i = 0; i < fluid.water; ++i) {
        FluidState& p = fluid.state[i];
        p.vx = -rotation * p.y;
        p.vy = rotation * p.x;
    }
}

void Setup::put(const RigidBody& body, const Outline& outline) {
    Outline placed = outline;
    for (Vec2& corner : placed) corner = body.placed(corner);
    clear_fluid(fluid, placed, particle_spacing);
    add_body_particles(walls, static_cast<std::uint32_t>(bodies.size()), outline, Vec2::Zero(),
                       particle_spacing, 2 * model.smoothing_ratio * particle_spacing);
    bodies.push_back(body);
}

void shake(Setup& setup, double share, std::uint64_t seed) {
    Dice dice(seed);
    for (FluidState& p : setup.fluid.state) {
        p.x += dice.symmetric(share * setup.particle_spacing);
        p.y += dice.symmetric(share * setup.particle_spacing);
    }
}

}  // namespace wetdeck::verification

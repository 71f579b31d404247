// SPDX-License-Identifier: BSD-3-Clause
// A wedge of 30 degrees deadrise is driven into water at constant speed. A probe of its own, called after
// every step, follows the impulse; its ratio to the exact one of the similarity solution is printed. Lengths
// in m, times in s.
#include <cstdio>
#include <wetdeck/solver/setup/body_outline.hpp>
#include <wetdeck/solver/setup/initial_pressure.hpp>
#include <wetdeck/solver/setup/lattice.hpp>
#include <wetdeck/solver/simulation.hpp>

using namespace wetdeck;

int main() {
    const double dx = 0.01, speed = 6.15, depth = 0.6, rise = 0.57735, coefficient = 14.024;
    const Box tank{{0, 0}, {1.6, 1.0}};
    Model model;
    model.gravity = {0, -9.81};
    model.water.eos = {.reference_density = 1000, .sound_speed = 120};
    model.negative_pressure = false;  // no air in this tank

    RigidBody body;  // its frame has the keel as origin
    body.free = {false, false, false};
    body.position = {0.8, depth + dx};
    body.velocity = {0, -speed};
    Outline hull = {{0, 0}, {0.25, 0.25 * rise}, {-0.25, 0.25 * rise}};
    for (Vec2& corner : hull) corner += body.position;

    FluidParticles water;
    fill_box(water, Phase::water, {{0, 0}, {1.6, depth}}, dx, model.water.eos.reference_density);
    clear_fluid(water, hull, dx);
    set_initial_pressure(water, model, [&](Phase, Vec2 at) { return 9810 * (depth - at.y()); });
    const double support = 2 * model.smoothing_ratio * dx;
    WallParticles walls = tank_walls(tank, dx, support);
    add_body_particles(walls, 0, hull, body.position, dx, support);

    Simulation simulation({model, water, walls, dx, tank, {body}});
    double ratio = 0;
    const auto probe = [&](const Simulation& s) {
        const double wet = s.time() - dx / speed;  // since the keel met the water
        ratio = s.bodies()[0].impulse.y() / (0.5 * coefficient * 1000 * speed * speed * speed * wet * wet);
    };
    const std::optional<Instability> instability = simulation.run(0.012, probe);
    if (instability) std::fprintf(stderr, "%s\n", instability->describe().c_str());
    std::printf("impulse over that of the similarity solution: %.3f\n", ratio);
    return instability ? 1 : 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/assemble.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "solver/core/errors.hpp"
#include "solver/probes/energy.hpp"
#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "solver/settled_arrangement.hpp"
#include "solver/setup/cut_cells.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/setup/lattice.hpp"
#include "solver/setup/mirrored_body.hpp"
#include "solver/time/time_step.hpp"
#include "validation/run/recorders.hpp"
#include "validation/scene/resolution_section.hpp"
#include "validation/scene/symmetry_section.hpp"
#include "validation/scene/wet_bodies.hpp"
#include "validation/store/environment.hpp"

namespace wetdeck {
namespace {

/// The spacing nearest to this one, finer or coarser, that fits every box of the scene and divides one of
/// their sides; nothing within a factor of two.
std::optional<double> nearest_fitting(const std::vector<Box>& boxes, double particle_spacing, bool finer) {
    std::vector<double> sides;
    for (const Box& box : boxes)
        sides.insert(sides.end(), {(box.high - box.low).x(), (box.high - box.low).y()});
    std::optional<double> nearest;
    for (const double side : sides) {
        double count = std::floor(side / particle_spacing) + (finer ? 1 : 0);
        for (int tried = 0; tried < 10'000 && count >= 1; ++tried, count += finer ? 1 : -1) {
            const double spacing = side / count;
            if (spacing < 0.5 * particle_spacing || spacing > 2 * particle_spacing) break;
            const auto fits = [spacing](double length) { return spacing_fits(length, spacing); };
            if (!std::all_of(sides.begin(), sides.end(), fits)) continue;
            if (!nearest || std::abs(spacing - particle_spacing) < std::abs(*nearest - particle_spacing))
                nearest = spacing;
            break;
        }
    }
    return nearest;
}

/// "; the nearest that fit all boxes: 0.025 and 0.02 m", or what there is of it.
std::string fitting_text(const Scene& scene, double particle_spacing) {
    std::vector<Box> boxes = scene.water_boxes;
    if (scene.air) boxes.insert(boxes.end(), scene.air_boxes.begin(), scene.air_boxes.end());
    std::vector<std::string> found;
    for (const bool finer : {false, true}) {
        if (const auto spacing = nearest_fitting(boxes, particle_spacing, finer))
            found.push_back(fmt::format("{:.6g}", *spacing));
    }
    if (found.empty()) return "; none between half and twice that fits all boxes";
    return fmt::format("; the nearest that fit all boxes: {} m", fmt::join(found, " and "));
}

/// Only water is under a pressure at the start that a gap beside a body would relieve.
bool any_starts_in_water(const Scene& scene) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                       [&](const BodySpec& body) { return starts_in_water(scene, body); });
}

/// The fluid without room for the bodies.
FluidParticles fill_tank(const Scene& scene, double particle_spacing) {
    FluidParticles fluid;
    const Model& model = scene.model;
    if (scene.resolution) {
        const SceneCells cells = cells_of(scene, particle_spacing);
        fill_cells(fluid, Phase::water, cells.water, particle_spacing, model.water.eos.reference_density);
        if (scene.air)
            fill_cells(fluid, Phase::air, cells.above, particle_spacing, model.air.eos.reference_density);
        return fluid;
    }
    try {
        for (const Box& box : scene.water_boxes)
            fill_box(fluid, Phase::water, box, particle_spacing, model.water.eos.reference_density);
        if (scene.air) {
            for (const Box& box : scene.air_boxes)
                fill_box(fluid, Phase::air, box, particle_spacing, model.air.eos.reference_density);
        }
    } catch (const InputError& error) {
        throw InputError(error.what() + fitting_text(scene, particle_spacing));
    }
    return fluid;
}

FluidParticles fill(const Scene& scene, double particle_spacing) {
    FluidParticles fluid = fill_tank(scene, particle_spacing);
    std::vector<Outline> outlines;
    for (const BodySpec& body : scene.bodies) outlines.push_back(body.outline);
    if (any_starts_in_water(scene)) {
        cut_cells(fluid, outlines, particle_spacing);
    } else {
        for (const Outline& outline : outlines) clear_fluid(fluid, outline, particle_spacing);
    }
    return fluid;
}

WallParticles boundary(const Scene& scene, double particle_spacing) {
    constexpr double on_plane = 1e-3;  // of a spacing: what rounding leaves of a particle on the plane
    const double support = 2 * scene.model.smoothing_ratio * particle_spacing;
    const auto tank = [&] {
        if (!scene.resolution) return tank_walls(scene.tank, particle_spacing, support, scene.model.ends());
        SceneCells cells = cells_of(scene, particle_spacing);
        cells.water.insert(cells.water.end(), cells.above.begin(), cells.above.end());
        return graded_tank_walls(scene.tank, cells.water, particle_spacing,
                                 boundary_layers(support, particle_spacing), scene.model.ends());
    };
    WallParticles walls = tank();
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const BodySpec& spec = scene.bodies[b];
        try {
            const auto number = static_cast<std::uint32_t>(b);
            const std::size_t first = walls.size();
            if (spec.solid)
                add_solid_particles(walls, number, spec.outline, spec.body.position, particle_spacing,
                                    support, scene.tank);
            else
                add_body_particles(walls, number, spec.drawn, spec.drawn_centre, particle_spacing, support);
            if (scene.model.mirror_x) mirror_body_points(walls, first, on_plane * particle_spacing);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: {}", spec.name, error.what()));
        }
    }
    return walls;
}

/// Gauge pressure at the start: the air weighs on the water, and the water of each column on what is below.
double initial_gauge_pressure(const Scene& scene, Phase phase, Vec2 position) {
    const double g = -scene.model.gravity.y();
    const InitialPressure& initial = scene.initial;
    const double air_density = scene.air ? scene.model.air.eos.reference_density : 0;
    if (phase == Phase::air) return air_density * g * (scene.tank.high.y() - position.y());
    const double top = water_top(scene.water_boxes, position);
    const double on_surface = air_density * g * (scene.tank.high.y() - top);
    const double density = scene.model.water.eos.reference_density;
    if (initial.law == InitialPressure::Law::greco) {
        return on_surface +
               greco_pressure(density, g, top, std::abs(initial.released_face - position.x()), position.y());
    }
    return on_surface + density * g * (top - position.y());
}

/// The velocities that the boxes of water have at the start.
void set_velocities(const Scene& scene, FluidParticles& fluid) {
    for (std::size_t i = 0; !scene.water_velocities.empty() && i < fluid.water; ++i) {
        FluidState& p = fluid.state[i];
        for (std::size_t b = 0; b < scene.water_boxes.size(); ++b) {
            const Box& box = scene.water_boxes[b];
            const Vec2 low = p.position() - box.low, high = box.high - p.position();
            if (std::min(low.minCoeff(), high.minCoeff()) < 0) continue;
            p.vx = scene.water_velocities[b].x();
            p.vy = scene.water_velocities[b].y();
            break;
        }
    }
}

}  // namespace

Simulation assemble(const Scene& whole, double particle_spacing, int threads) {
    const Scene scene = whole.symmetry ? right_half(whole) : whole;
    const Model& model = scene.model;
    FluidParticles fluid = fill(scene, particle_spacing);
    set_initial_pressure(fluid, model, [&](Phase phase, Vec2 position) {
        return initial_gauge_pressure(scene, phase, position);
    });
    std::vector<RigidBody> bodies;
    for (const BodySpec& spec : scene.bodies) {
        bodies.push_back(spec.body);
        if (model.contact.on()) bodies.back().corners = spec.local_outline();
    }
    Execution execution = scene.execution;
    execution.threads = threads;
    execution.instruction_set = instruction_set_from_environment();
    SimulationSetup setup{
        model,     std::move(fluid), boundary(scene, particle_spacing), particle_spacing, scene.tank, bodies,
        execution, scene.tank_motion};
    if (scene.resolution) setup.coarsest = coarsest_over_finest(setup.fluid, setup.walls);
    if (scene.arrangement != 0) setup.fluid = settled_arrangement(setup, scene.arrangement);
    set_velocities(scene, setup.fluid);
    return Simulation(std::move(setup));
}

namespace {

/// Throws where a spring swings its body, or a dashpot stops it, faster than the time steps can follow.
void check_springs(const Scene& scene, double particle_spacing) {
    constexpr double largest_angle = 0.5;  // of an oscillation in one step [rad]: twelve steps a period
    const double h = scene.model.smoothing_ratio * particle_spacing;
    const TimeStep step = step_of(scene.model, stable_time_step(scene.model, h, {}, true, scene.air));
    for (const BodySpec& spec : scene.bodies) {
        double frequency2 = 0, decay = 0;
        for (Spring spring : spec.body.springs) {
            frequency2 += spring.frequency2(spec.body);
            spring.stiffness = spring.damping;  // what it does to a velocity
            spring.table = {};
            decay += spring.frequency2(spec.body);
        }
        const double angle = std::max(std::sqrt(frequency2), decay) * step.size;
        if (angle > largest_angle)
            throw InputError(fmt::format(
                "{}.springs are too stiff for {} m: the body would move in {:.2g} s, expected at "
                "least {:.2g} s, twelve time steps a period; give the body more mass, or a softer "
                "spring",
                spec.name, particle_spacing, 2 * std::numbers::pi * step.size / angle,
                2 * std::numbers::pi * step.size / largest_angle));
    }
}

}  // namespace

void check_spacing(const Scene& scene, double particle_spacing) {
    constexpr double most_particles = 5e7;
    if (!(particle_spacing > 0) || !std::isfinite(particle_spacing)) {
        throw InputError(fmt::format("--dx is {}, expected a positive spacing [m]", particle_spacing));
    }
    const double particles =
        scene.resolution ? estimate_cost(scene, particle_spacing).fluid_particles
                         : (scene.tank.high - scene.tank.low).prod() / (particle_spacing * particle_spacing);
    if (particles > most_particles) {
        throw InputError(
            fmt::format("particle spacing {} m would make {:.2g} particles, expected at most {:.2g}",
                        particle_spacing, particles, most_particles));
    }
    const Scene computed = scene.symmetry ? right_half(scene) : scene;
    fill(computed, particle_spacing);
    boundary(computed, particle_spacing);
    check_springs(scene, particle_spacing);
    Recorders(scene, particle_spacing);
}

void check_row(const Scene& scene, const std::string& tier, double particle_spacing) {
    try {
        check_spacing(scene, particle_spacing);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: key 'tiers.{}.{}': {} m: {}", scene.path, tier, scene.variant,
                                     particle_spacing, error.what()));
    }
}

}  // namespace wetdeck

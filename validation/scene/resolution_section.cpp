// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/resolution_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/physics/mixed_precision.hpp"
#include "validation/scene/expected_motion.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

constexpr double tolerance = 1e-9;  // of lengths [m]

/// Share of the longer side of the box around the bodies by which it is widened, for the water they push
/// aside.
constexpr double share_beside_bodies = 0.05;

void widen(Box& box, const Outline& outline) {
    for (const Vec2& corner : outline) extend(box, corner);
}

Outline moved(Outline outline, Vec2 by) {
    for (Vec2& corner : outline) corner += by;
    return outline;
}

/// The box around the bodies, from where they start to where they may be at the end, as far behind them,
/// where the fluid comes from that follows them, and some fluid beside them: no coarse fluid must get to a
/// body.
Box box_around_bodies(const Scene& scene) {
    Box box{scene.bodies.front().outline.front(), scene.bodies.front().outline.front()};
    for (const BodySpec& spec : scene.bodies) {
        widen(box, spec.outline);
        const std::vector<Outline> given = positions_given(scene, spec);
        for (const Outline& outline : given) {
            widen(box, outline);
            widen(box, moved(spec.outline, spec.outline.front() - outline.front()));
        }
        if (spec.solid || !given.empty()) continue;
        const double t = scene.end_time;
        Vec2 path = t * spec.body.velocity, acceleration = scene.model.gravity;
        if (spec.body.mass > 0) acceleration += spec.body.applied_force / spec.body.mass;
        for (int k = 0; k < 2; ++k)
            if (spec.body.free[static_cast<std::size_t>(k)]) path[k] += 0.5 * t * t * acceleration[k];
        widen(box, moved(spec.outline, path));
        widen(box, moved(spec.outline, -path));
    }
    const Vec2 margin = Vec2::Constant(share_beside_bodies * (box.high - box.low).maxCoeff());
    return {(box.low - margin).cwiseMax(scene.tank.low), (box.high + margin).cwiseMin(scene.tank.high)};
}

Box read_around(const TomlTable& table, const Scene& scene) {
    if (!table.holds_text("around")) {
        const std::vector<double> numbers = table.numbers("around");
        if (numbers.size() != 2 && numbers.size() != 4)
            table.fail("around", "expected \"body\", \"surface\", a point [x, y] or a box [x, y, x, y]");
        const std::size_t last = numbers.size() - 2;
        const Box box{{numbers[0], numbers[1]}, {numbers[last], numbers[last + 1]}};
        const Vec2 inside = (box.low - scene.tank.low).cwiseMin(scene.tank.high - box.high);
        if (inside.minCoeff() < -tolerance || (box.high - box.low).minCoeff() < 0)
            table.fail("around", "expected a point or a box, from its lower left corner, in the tank");
        return box;
    }
    if (table.choice("around", {"body", "surface"}, "") == "body") {
        if (scene.bodies.empty()) table.fail("around", "is \"body\", and the scene has none");
        return box_around_bodies(scene);
    }
    const double level = scene.water_boxes.front().high.y();
    return {{scene.tank.low.x(), level}, {scene.tank.high.x(), level}};
}

/// Why a scene has equal spacings only; empty where it may have others.
std::string needs_equal_spacings(const Scene& scene) {
    const Box& water = scene.water_boxes.front();
    const bool layer = scene.water_boxes.size() == 1 && (water.low - scene.tank.low).norm() < tolerance &&
                       std::abs(water.high.x() - scene.tank.high.x()) < tolerance;
    if (!layer) return "the water is not one layer from wall to wall";
    if (scene.air && scene.air_boxes.size() != 1) return "the air is not one layer";
    if (std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodySpec& b) { return b.solid; }))
        return "it has solids, or a tank with an outline";
    const std::string choice = without_mixed_pairs(scene.model);
    return choice.empty() ? "" : "model." + choice;
}

}  // namespace

void read_resolution(const TomlTable& root, Scene& scene) {
    const std::optional<TomlTable> table = root.optional_table("resolution");
    if (!table) return;
    if (const std::string reason = needs_equal_spacings(scene); !reason.empty())
        table->fail("around", "this scene needs equal spacings: " + reason);
    Resolution resolution;
    resolution.box = read_around(*table, scene);
    resolution.growth = table->number_or("growth", resolution.growth);
    resolution.coarsest = table->number_or("coarsest", resolution.coarsest);
    resolution.finest = table->optional_number("finest");
    if (!(resolution.growth > 0 && resolution.growth <= largest_growth))
        table->fail("growth", fmt::format("is {:.6g}, expected a share of the spacing above 0, at most {}",
                                          resolution.growth, largest_growth));
    if (!(resolution.coarsest >= 1 && resolution.coarsest <= largest_coarsest))
        table->fail(
            "coarsest",
            fmt::format(
                "is {:.6g}, expected the largest spacing over the finest, from 1 (equal spacings) to {}",
                resolution.coarsest, largest_coarsest));
    if (resolution.finest && !(*resolution.finest > 0))
        table->fail("finest", "expected a positive spacing [m]");
    for (const BodySpec& spec : scene.bodies)
        for (const Vec2& corner : spec.outline)
            if ((corner - resolution.box.low).minCoeff() < -tolerance ||
                (resolution.box.high - corner).minCoeff() < -tolerance)
                table->fail("around",
                            fmt::format("{} is not in it: the boundary particles of bodies have the "
                                        "finest spacing; use \"body\"",
                                        spec.name));
    const double level = scene.water_boxes.front().high.y();
    if (scene.air &&
        (resolution.box.low.y() > level + tolerance || resolution.box.high.y() < level - tolerance))
        table->fail("around",
                    fmt::format("does not reach the level at {:.6g} m, and water and air there need equal "
                                "spacings",
                                level));
    table->finish();
    if (resolution.coarsest > 1) scene.resolution = resolution;
}

Grading grading_of(const Resolution& resolution, double finest) {
    return {resolution.box, finest, resolution.growth, resolution.coarsest};
}

std::optional<std::string> doubtful_currents(const Scene& scene) {
    constexpr double share_of_gravity = 0.005, tolerated = 1.0 / 30;
    if (!scene.resolution) return std::nullopt;
    const double currents = share_of_gravity * scene.model.gravity.norm() * scene.end_time;
    const ExpectedSpeed fastest = fastest_expected_speed(scene);
    if (currents <= tolerated * fastest.speed) return std::nullopt;
    return fmt::format(
        "where spacings differ ([resolution]) gravity drives currents of about 0.005 g t, {:.2g} m/s by the "
        "end at "
        "{:.3g} s, more than a thirtieth of {:.3g} m/s, the fastest motion that is expected: equal spacings "
        "are for "
        "runs as long as this",
        currents, scene.end_time, fastest.speed);
}

double spacing_of(const Scene& scene, const Probe& probe, double finest) {
    if (!scene.resolution || !probe.place) return finest;
    const Grading grading = grading_of(*scene.resolution, finest);
    return std::max(grading.spacing_at(probe.place->begin), grading.spacing_at(probe.place->end));
}

SceneCells cells_of(const Scene& scene, double finest) {
    const Grading grading = grading_of(*scene.resolution, finest);
    const Box& water = scene.water_boxes.front();
    SceneCells cells{graded_cells(water, grading), {}};
    const Box above{{scene.tank.low.x(), water.high.y()}, scene.tank.high};
    if (above.high.y() > above.low.y() + tolerance) cells.above = graded_cells(above, grading);
    return cells;
}

}  // namespace wetdeck

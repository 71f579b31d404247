// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/plausibility.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "solver/setup/body_outline.hpp"
#include "solver/setup/initial_pressure.hpp"
#include "solver/time/time_step.hpp"
#include "validation/scene/asked_axes.hpp"
#include "validation/scene/expected_motion.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/resolution_section.hpp"
#include "validation/scene/slamming.hpp"
#include "validation/scene/trapped_air.hpp"
#include "validation/scene/unused_values.hpp"
#include "validation/scene/wet_bodies.hpp"

namespace wetdeck {
namespace {

using Doubts = std::vector<std::string>;

void doubt_fluids(const Scene& scene, Doubts& found) {
    const TaitEquationOfState& eos = scene.model.water.eos;
    const ExpectedSpeed fastest = fastest_expected_speed(scene);
    const double speed = fastest.speed;
    if (eos.sound_speed < 9.9 * speed) {
        found.push_back(fmt::format(
            "water.sound_speed is {:.4g} m/s, less than ten times the fastest speed to expect, {:.3g} m/s "
            "{}: "
            "the water would be compressed by about {:.2g} %",
            eos.sound_speed, speed, fastest.of, 100 * speed * speed / (eos.sound_speed * eos.sound_speed)));
    }
    const TaitEquationOfState& air = scene.model.air.eos;
    if (scene.air && air.background_pressure > 0.5 * air.coefficient()) {
        found.push_back(fmt::format(
            "model.background_pressure is {:.4g} Pa, more than half of the air's own stiffness rho "
            "c^2/gamma, {:.3g} Pa: it would tear light air apart",
            air.background_pressure, air.coefficient()));
    }
    if (scene.air && air.reference_density > eos.reference_density)
        found.push_back(fmt::format("air.density is {:.4g} kg/m3, more than water.density, {:.4g} kg/m3",
                                    air.reference_density, eos.reference_density));
}

/// Tonnes and metres, and a number typed for a sound speed that no water has.
void doubt_units(const Scene& scene, Doubts& found) {
    const TaitEquationOfState& eos = scene.model.water.eos;
    if (eos.reference_density < 20 && scene.model.gravity.norm() > 5)
        found.push_back(
            fmt::format("water.density is {:.4g} kg/m3 under a gravity of {:.4g} m/s2: is it in t/m3?",
                        eos.reference_density, scene.model.gravity.norm()));
    if (eos.sound_speed > 2000)
        found.push_back(
            fmt::format("water.sound_speed is {:.4g} m/s, more than that of real water: the steps are "
                        "shorter than any pressure needs",
                        eos.sound_speed));
}

/// A half section from the keel to the deck, which the program closes by a side from the deck to the keel.
void doubt_half_section(const BodySpec& body, Doubts& found) {
    const auto x = [&](const Vec2& corner) { return corner.x() - body.origin.x(); };
    constexpr double on_axis = 1e-9;
    Vec2 keel = body.outline.front(), deck = body.outline.back();
    if (x(keel) > on_axis) std::swap(keel, deck);
    if (std::abs(x(keel)) > on_axis || x(deck) < on_axis) return;
    for (const Vec2& corner : body.outline)
        if (corner != keel && (x(corner) < on_axis || corner.y() < keel.y())) return;
    found.push_back(
        fmt::format("{}.outline lies on one side of its axis, with one end at the keel: closed by a side "
                    "from deck to keel as it is; for a half section write mirrored = true",
                    body.name));
}

void doubt_ingredients(const Scene& scene, Doubts& found) {
    const double courant = scene.model.courant_number;
    if (courant > 0.8 && !(scene.model.fixed_step > 0))
        found.push_back(
            fmt::format("model.courant_number is {:.4g}: beyond 0.8 even still water has wrong pressures "
                        "(by 60 % at 0.9)",
                        courant));
    const double background = scene.model.water.eos.background_pressure;
    if (!scene.air && background > 0)
        found.push_back(
            fmt::format("model.background_pressure is {:.4g} Pa without air: no air balances it at "
                        "the free surface, and pressures are too low by up to as much",
                        background));
    if (!scene.air && scene.model.negative_pressure)
        found.push_back(
            "model.negative_pressure is true without air: water under tension clumps into lines, more the "
            "finer its particles; expected false, or air with a background pressure");
    const Vec2 size = scene.tank.high - scene.tank.low;
    const double sponge = scene.model.sponge_thickness;
    if (sponge > 0.25 * size.minCoeff())
        found.push_back(
            fmt::format("model.sponge_thickness is {:.4g} m in a tank of {:.4g} x {:.4g} m: it slows "
                        "down more than half of a side",
                        sponge, size.x(), size.y()));
}

void doubt_gravity(const Scene& scene, Doubts& found) {
    const Vec2& g = scene.model.gravity;
    if (g.x() != 0 && std::abs(g.x()) <= std::abs(g.y()))
        found.push_back(fmt::format("gravity is tilted by {:.3g} degrees: level water does not start at rest",
                                    std::atan(std::abs(g.x() / g.y())) * 180 / std::numbers::pi));
    if (g.y() > 0) found.push_back(fmt::format("gravity points up: [{:.4g}, {:.4g}] m/s2", g.x(), g.y()));
    if (std::abs(g.x()) > std::abs(g.y()))
        found.push_back(fmt::format("gravity points sideways: [{:.4g}, {:.4g}] m/s2", g.x(), g.y()));
    if (g.norm() > 20) found.push_back(fmt::format("gravity is {:.4g} m/s2: is it in m/s2?", g.norm()));
}

/// Tops of the water over all columns.
std::set<double> tops_of(const std::vector<Box>& boxes) {
    std::set<double> tops;
    for (const Box& box : boxes) {
        for (const Box& other : boxes) {
            const double x = std::max(box.low.x(), other.low.x());
            if (x < box.high.x()) tops.insert(water_top(boxes, {x + 1e-9, box.low.y() + 1e-9}));
        }
    }
    return tops;
}

void doubt_initial(const Scene& scene, Doubts& found) {
    const std::set<double> tops = tops_of(scene.water_boxes);
    const double surface = scene.initial.surface;
    const auto is_surface = [surface](double top) { return std::abs(top - surface) < 1e-6; };
    if (!tops.empty() && std::none_of(tops.begin(), tops.end(), is_surface)) {
        std::vector<std::string> texts;
        for (const double top : tops) texts.push_back(fmt::format("{:.6g}", top));
        found.push_back(fmt::format(
            "initial.surface is {:.6g} m, but the top of the water is at {} m: the pressure at the start is "
            "that of the water above each particle",
            surface, fmt::join(texts, " and ")));
    }
    if (scene.initial.law != InitialPressure::Law::greco) return;
    double width = 0;
    for (const Box& box : scene.water_boxes)
        width = std::max({width, std::abs(box.low.x() - scene.initial.released_face),
                          std::abs(box.high.x() - scene.initial.released_face)});
    if (width < surface)
        found.push_back(
            fmt::format("the column of water is {:.4g} m wide and {:.4g} m high: the pressure after "
                        "Greco is that of a long column",
                        width, surface));
}

/// Air of a scene with air fills what water and bodies leave of the tank, or rushes into the rest.
void doubt_empty_space(const Scene& scene, Doubts& found) {
    if (!scene.air) return;
    std::set<double> xs = {scene.tank.low.x(), scene.tank.high.x()};
    std::set<double> ys = {scene.tank.low.y(), scene.tank.high.y()};
    std::vector<Box> boxes = scene.water_boxes;
    boxes.insert(boxes.end(), scene.air_boxes.begin(), scene.air_boxes.end());
    for (const Box& box : boxes) {
        xs.insert({box.low.x(), box.high.x()});
        ys.insert({box.low.y(), box.high.y()});
    }
    double empty = 0;
    for (auto x = xs.begin(); std::next(x) != xs.end(); ++x) {
        for (auto y = ys.begin(); std::next(y) != ys.end(); ++y) {
            const Vec2 low(*x, *y), high(*std::next(x), *std::next(y)), middle = 0.5 * (low + high);
            const auto holds = [&](const Box& box) {
                return (middle - box.low).minCoeff() > 0 && (box.high - middle).minCoeff() > 0;
            };
            const auto covers = [&](const BodySpec& body) { return distance_to(body.outline, middle) < 0; };
            if (std::any_of(boxes.begin(), boxes.end(), holds)) continue;
            if (std::any_of(scene.bodies.begin(), scene.bodies.end(), covers)) continue;
            empty += (high - low).prod();
        }
    }
    const double share = empty / (scene.tank.high - scene.tank.low).prod();
    if (share > 0.001)
        found.push_back(
            fmt::format("the boxes of water and air leave {:.3g} % of the tank empty: air beside it "
                        "flows into a vacuum",
                        100 * share));
}

void doubt_mass(const Scene& scene, const BodySpec& spec, Doubts& found) {
    const RigidBody& body = spec.body;
    if (!body.yields()) return;
    if (body.mass > 0) {
        double area = 0;
        for (const Outline& outline : outlines_carried_by(scene, spec)) area += area_moments(outline).area;
        const double ratio = body.mass / (area * scene.model.water.eos.reference_density);
        if (ratio > 30 || ratio < 1.0 / 60)
            found.push_back(
                fmt::format("{} has {:.2g} times the mass of the water it would displace: is it "
                            "per metre of width?",
                            spec.name, ratio));
    }
    if (!body.free[2] || !(spec.even_inertia > 0)) return;
    const double ratio = body.inertia / spec.even_inertia;
    if (ratio > 10 || ratio < 0.1)
        found.push_back(
            fmt::format("{}.inertia is {:.4g} kg m, {:.2g} times that of even density, {:.4g} kg m: "
                        "is it about the mass centre and per metre of width?",
                        spec.name, body.inertia, ratio, spec.even_inertia));
}

void doubt_times(const Scene& scene, Doubts& found) {
    constexpr double fewest = 50;
    const double samples = scene.end_time / scene.sample_interval;
    if (samples < fewest)
        found.push_back(
            fmt::format("run.sample_interval is {:.4g} s: the run to {:.4g} s has {:.0f} samples, "
                        "fewer than {:.0f}",
                        scene.sample_interval, scene.end_time, std::floor(samples) + 1, fewest));
    if (scene.force_filter > 0.1 * scene.end_time)
        found.push_back(
            fmt::format("run.force_filter is {:.4g} s, more than a tenth of the run of {:.4g} s: "
                        "filtered peaks would be means",
                        scene.force_filter, scene.end_time));
    for (const double time : scene.picture_times) {
        if (time <= (1 + 1e-9) * scene.end_time) continue;
        found.push_back(
            fmt::format("run.frames asks for {:.4g} s, after the end at {:.4g} s: it is not written", time,
                        scene.end_time));
    }
}

std::optional<std::string> doubtful_step(const Scene& scene, double particle_spacing) {
    const double h = scene.model.smoothing_ratio * particle_spacing;
    const TimeStep stable = stable_time_step(scene.model, h, {}, true, scene.air);
    if (step_of(scene.model, stable).criterion != LimitingCriterion::fixed_beyond) return std::nullopt;
    return fmt::format(
        "model.fixed_step is {:.3g} s, {:.3g} times the stable step of {:.3g} s at the spacing {:.4g} m: the "
        "run may become unstable or be wrong without a sign",
        scene.model.fixed_step, scene.model.fixed_step / stable.size, stable.size, particle_spacing);
}

std::vector<std::string> narrow_gaps(const Scene& scene, double particle_spacing) {
    std::vector<std::string> found;
    const auto doubt = [&](const BodySpec& body, const std::string& what, double gap) {
        if (gap > 0.1 * particle_spacing && gap < 1.99 * particle_spacing)
            found.push_back(
                fmt::format("{} starts {:.4g} m from {}, {:.3g} spacings: the water between them carries a "
                            "part of its pressure only; expected at least two spacings, or less than a tenth "
                            "of one, which no water enters",
                            body.name, gap, what, gap / particle_spacing));
    };
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const BodySpec& body = scene.bodies[b];
        if (!starts_in_water(scene, body)) continue;
        const Box extent = extent_of(body.outline);
        doubt(body, "the floor", extent.low.y() - scene.tank.low.y());
        doubt(body, "the left wall", extent.low.x() - scene.tank.low.x());
        doubt(body, "the right wall", scene.tank.high.x() - extent.high.x());
        for (std::size_t o = 0; o < b; ++o) {
            const Outline& other = scene.bodies[o].outline;
            double gap = std::numeric_limits<double>::infinity();
            for (const Vec2& corner : body.outline) gap = std::min(gap, distance_to(other, corner));
            for (const Vec2& corner : other) gap = std::min(gap, distance_to(body.outline, corner));
            doubt(body, scene.bodies[o].name, gap);
        }
    }
    return found;
}

}  // namespace

std::vector<std::string> doubtful(const Scene& scene) {
    Doubts found;
    doubt_fluids(scene, found);
    for (std::string& text : doubtful_impacts(scene)) found.push_back(std::move(text));
    doubt_gravity(scene, found);
    doubt_ingredients(scene, found);
    doubt_initial(scene, found);
    doubt_empty_space(scene, found);
    if (auto text = doubtful_trapped_air(scene)) found.push_back(std::move(*text));
    for (const BodySpec& spec : scene.bodies) doubt_mass(scene, spec, found);
    for (const BodySpec& spec : scene.bodies) doubt_half_section(spec, found);
    doubt_units(scene, found);
    for (std::string& text : motions_out_of_tank(scene)) found.push_back(std::move(text));
    doubt_times(scene, found);
    if (auto text = doubtful_currents(scene)) found.push_back(std::move(*text));
    for (const Probe& probe : scene.probes)
        found.insert(found.end(), probe.doubts.begin(), probe.doubts.end());
    for (std::string& text : unreached_times(scene)) found.push_back(std::move(text));
    for (std::string& text : doubtful_scales(scene)) found.push_back(std::move(text));
    for (std::string& text : unused_values(scene)) found.push_back(std::move(text));
    return found;
}

std::vector<std::string> remarks(const Scene& scene) {
    std::vector<std::string> all;
    for (const BodySpec& spec : scene.bodies) {
        if (starts_in_water(scene, spec)) all.push_back(fmt::format("{} starts in the water", spec.name));
    }
    for (std::string& text : impact_remarks(scene)) all.push_back(std::move(text));
    return all;
}

std::vector<std::string> doubts_at_spacing(const Scene& scene, double particle_spacing) {
    std::vector<std::string> found = narrow_gaps(scene, particle_spacing);
    if (auto step = doubtful_step(scene, particle_spacing)) found.push_back(std::move(*step));
    return found;
}

std::vector<std::string> doubts_of_run(const Scene& scene, double particle_spacing,
                                       std::optional<double> until) {
    Scene asked = scene;
    asked.end_time = std::max(scene.end_time, until.value_or(0));  // who ends a run early knows it
    std::vector<std::string> doubts = doubtful(asked);
    for (std::string& text : doubts_at_spacing(scene, particle_spacing)) doubts.push_back(std::move(text));
    return doubts;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/body_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "validation/scene/expected_motion.hpp"
#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

/// Breadth of an outline at a height: the sum over its parts there [m].
double breadth_at(const Outline& outline, double height) {
    std::vector<double> crossings;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
        if ((a.y() > height) == (b.y() > height)) continue;
        crossings.push_back(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    double sum = 0;
    for (std::size_t k = 1; k < crossings.size(); k += 2) sum += crossings[k] - crossings[k - 1];
    return sum;
}

/// The sum of a measure over outlines.
template <class Measure>
double sum_over(const std::vector<Outline>& outlines, Measure measure) {
    double sum = 0;
    for (const Outline& outline : outlines) sum += measure(outline);
    return sum;
}

/// Height up to which the outlines hold an area; nothing where they are smaller.
std::optional<double> level_for(const std::vector<Outline>& outlines, const Box& extent, double area) {
    const double whole = sum_over(outlines, [](const Outline& o) { return area_moments(o).area; });
    if (!(area > 0) || area >= whole) return std::nullopt;
    double low = extent.low.y(), high = extent.high.y();
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        const Outline below = corners_of({extent.low - Vec2(1, 1), {extent.high.x() + 1, middle}});
        const double held = sum_over(outlines, [&](const Outline& o) { return shared_area(o, below); });
        (held < area ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

BodyFigures body_figures(const Scene& scene, const BodySpec& spec) {
    BodyFigures figures;
    const RigidBody& body = spec.body;
    const std::vector<Outline> outlines = outlines_carried_by(scene, spec);
    Box extent = extent_of(spec.outline);
    for (const Outline& outline : outlines)
        extent = {extent.low.cwiseMin(extent_of(outline).low), extent.high.cwiseMax(extent_of(outline).high)};
    const double density = scene.model.water.eos.reference_density, g = scene.model.gravity.norm();
    figures.area = sum_over(outlines, [](const Outline& o) { return area_moments(o).area; });
    figures.beam = extent.high.x() - extent.low.x();
    if (body.mass > 0 && g > 0) {
        if (const auto level = level_for(outlines, extent, body.mass / density)) {
            figures.draught = *level - extent.low.y();
            const double b = sum_over(outlines, [&](const Outline& o) { return breadth_at(o, *level); });
            const double added = density * std::numbers::pi * b * b / 8;
            if (b > 0)
                figures.heave_period =
                    2 * std::numbers::pi * std::sqrt((body.mass + added) / (density * g * b));
        }
    }
    if (const std::optional<WaterEntry> entry = water_entry(scene, spec)) {
        figures.speed = entry->speed;
        figures.first_contact = entry->time;
    } else if (const double given = largest_given_speed(scene, body); given > 0) {
        figures.speed = given;
    }
    if (!figures.speed) return figures;
    if (g > 0) figures.froude = *figures.speed / std::sqrt(g * figures.beam);
    figures.mach = *figures.speed / scene.model.water.eos.sound_speed;
    if (scene.model.water.viscosity > 0 && scene.model.viscosity != Viscosity::none)
        figures.reynolds = density * *figures.speed * figures.beam / scene.model.water.viscosity;
    return figures;
}

}  // namespace wetdeck

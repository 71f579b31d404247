// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "validation/scene/expected_motion.hpp"

namespace wetdeck {
namespace {

constexpr double line_height = 17;

constexpr Stroke probe_line{"#c0392b", 3}, probe_column{"#c0392b", 1, true}, body_edge{"#5b4a26", 1.4},
    path_edge{"#5b4a26", 1, true}, tank_edge{"#333333", 2}, plane_edge{"#7d3c98", 1.4, true},
    finest_edge{"#1e7b4f", 1.4, true}, coarser_edge{"#1e7b4f", 0.7, true};

/// The finest spacing that a tier runs the variant at.
std::optional<double> finest_of_tiers(const Scene& scene) {
    std::optional<double> finest;
    for (const auto& [name, tier] : scene.tiers)
        if (const auto found = tier.find(scene.variant); found != tier.end())
            for (const double spacing : found->second) finest = std::min(finest.value_or(spacing), spacing);
    return finest;
}

void draw_fluids(Drawing& drawing, const Scene& scene) {
    if (scene.air) {
        for (const Box& box : scene.air_boxes) drawing.polygon(corners_of(box), "#eef3f8");
    }
    for (const Box& box : scene.water_boxes) {
        drawing.polygon(corners_of(box), "#5b9bd5");
        const Vec2 size = box.high - box.low;
        drawing.label(drawing.x(0.5 * (box.low.x() + box.high.x())), drawing.y(box.low.y() + 0.25 * size.y()),
                      fmt::format("water {:.4g} m × {:.4g} m", size.x(), size.y()),
                      {Anchor::middle, 13, "#ffffff"});
    }
}

/// Entry of the key: mass, inertia and initial velocity of a body.
std::string description_of(const BodySpec& body) {
    const RigidBody& b = body.body;
    return fmt::format("{}: mass {:.4g} kg/m, inertia {:.4g} kg m, starts at ({:.4g}, {:.4g}) m/s", body.name,
                       b.mass, b.inertia, b.velocity.x(), b.velocity.y());
}

void draw_bodies(Drawing& drawing, const Scene& scene) {
    for (const BodySpec& body : scene.bodies) {
        drawing.polygon(body.outline, body.solid ? "#b9b4aa" : "#d9c9a8", body_edge);
        if (body.solid) continue;
        for (const Outline& later : positions_given(scene, body)) drawing.polygon(later, "", path_edge);
        const Vec2 centre = body.body.position;
        if (body.body.velocity.norm() > 0)
            drawing.arrow(centre, body.body.velocity.normalized(), 42, "#5b4a26");
        drawing.label(drawing.x(centre.x()), drawing.y(centre.y()) + 4, "⊕", {Anchor::middle, 12, "#5b4a26"});
        for (const Spring& spring : body.body.springs)
            if (spring.direction == Spring::Direction::line)
                drawing.line(body.body.placed(spring.on_body), spring.on_earth, path_edge);
    }
}

using Key = std::vector<std::string>;

/// Draws the probes with their numbers and adds their names to the key.
void draw_probes(Drawing& drawing, const Scene& scene, Key& key) {
    double last_y = -100, last_x = -100;  // a number that would cover the last one moves aside
    std::size_t number = 0;
    for (const Probe& probe : scene.probes) {
        ++number;
        key.push_back(
            fmt::format("{} {}{}", number, probe.series.name, probe.note.empty() ? "" : ": " + probe.note));
        if (!probe.place) continue;
        const auto& [begin, end, through_fluid] = *probe.place;
        if (begin != end) drawing.line(begin, end, through_fluid ? probe_column : probe_line);
        const Vec2 label = through_fluid ? end : Vec2(0.5 * (begin + end));
        double px = drawing.x(label.x()) + (through_fluid ? 0 : 14);
        const double py = drawing.y(label.y()) - (through_fluid ? 12 : 0);
        if (std::abs(py - last_y) < 17 && std::abs(px - last_x) < 17) px = last_x + 18;
        drawing.mark(px, py, number);
        last_x = px;
        last_y = py;
    }
}

/// The box of the finest particles, and where they are twice, four times, ... as coarse.
void draw_resolution(Drawing& drawing, const Scene& scene, Key& key) {
    if (!scene.resolution) return;
    const Resolution& r = *scene.resolution;
    drawing.polygon(corners_of(r.box), "", finest_edge);
    std::string entry =
        fmt::format("finest particles in the dotted box, growing by {:.3g} % each, up to {:.3g} times",
                    100 * r.growth, r.coarsest);
    if (const std::optional<double> finest = r.finest ? r.finest : finest_of_tiers(scene)) {
        entry += fmt::format("; thin: 2, 4, ... times at {:.3g} m", *finest);
        for (double ratio = 2; ratio <= r.coarsest; ratio *= 2) {
            const Vec2 margin = Vec2::Constant((ratio - 1) * *finest / r.growth);
            drawing.polygon(corners_of({(r.box.low - margin).cwiseMax(scene.tank.low),
                                        (r.box.high + margin).cwiseMin(scene.tank.high)}),
                            "", coarser_edge);
        }
    }
    key.push_back(entry);
}

void draw_tank(Drawing& drawing, const Scene& scene) {
    drawing.polygon(corners_of(scene.tank), "", tank_edge);
    if (scene.symmetry)
        drawing.line({*scene.symmetry, scene.tank.low.y()}, {*scene.symmetry, scene.tank.high.y()},
                     plane_edge);
    const Vec2 size = scene.tank.high - scene.tank.low;
    drawing.label(0.5 * drawing.width(), drawing.height() + 20, fmt::format("{:.4g} m", size.x()),
                  {Anchor::middle});
    drawing.label(-8, 0.5 * drawing.height(), fmt::format("{:.4g} m", size.y()), {Anchor::end});
    if (scene.model.gravity.norm() == 0) return;
    const Vec2 corner = scene.tank.high - 0.06 * Vec2(size.x(), size.x());
    drawing.arrow(corner, scene.model.gravity.normalized(), 30, "#333333");
    drawing.label(drawing.x(corner.x()) - 8, drawing.y(corner.y()) + 18, "g", {Anchor::end});
}

/// Writes the key below the drawing and returns where it ends [px].
double draw_key(Drawing& drawing, const Key& key) {
    double row = drawing.height() + 44;
    for (const std::string& entry : key) {
        const std::string shown = entry.size() > 100 ? entry.substr(0, 97) + "..." : entry;
        drawing.label(0, row, shown, {Anchor::start, 11, "#444444"});
        row += line_height;
    }
    return row;
}

}  // namespace

Drawing sketch(const Scene& scene) {
    Drawing drawing(scene.tank, "set-up of the scene", {560, 460});
    Key key;
    for (const BodySpec& body : scene.bodies)
        if (!body.solid) key.push_back("⊕ " + description_of(body));
    draw_fluids(drawing, scene);
    draw_bodies(drawing, scene);
    draw_resolution(drawing, scene, key);
    draw_tank(drawing, scene);
    draw_probes(drawing, scene, key);
    drawing.end_at(draw_key(drawing, key));
    return drawing;
}

}  // namespace wetdeck

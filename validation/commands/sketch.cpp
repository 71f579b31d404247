// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/page/html.hpp"

namespace wetdeck {
namespace {

constexpr double largest_width = 560, largest_height = 460;  // of the tank [px]
constexpr double line_height = 17;

/// Scene coordinates to pixels; y points down in SVG.
class Drawing {
  public:
    explicit Drawing(const Box& tank) : tank_(tank) {
        const Vec2 size = tank.high - tank.low;
        scale_ = std::min(largest_width / size.x(), largest_height / size.y());
    }

    double x(double metres) const { return (metres - tank_.low.x()) * scale_; }
    double y(double metres) const { return (tank_.high.y() - metres) * scale_; }
    double width() const { return x(tank_.high.x()); }
    double height() const { return y(tank_.low.y()); }

    void rectangle(const Box& box, const char* style) {
        body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n",
                             x(box.low.x()), y(box.high.y()), x(box.high.x()) - x(box.low.x()),
                             y(box.low.y()) - y(box.high.y()), style);
    }
    void line(Vec2 a, Vec2 b, const char* style) {
        body_ += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x(a.x()),
                             y(a.y()), x(b.x()), y(b.y()), style);
    }
    void polygon(const Outline& corners, const char* style) {
        std::string points;
        for (const Vec2& corner : corners)
            points += fmt::format("{:.2f},{:.2f} ", x(corner.x()), y(corner.y()));
        body_ += fmt::format("<polygon points=\"{}\" {}/>\n", points, style);
    }
    /// An arrow of a given length in pixels from a point of the scene.
    void arrow(Vec2 from, Vec2 direction, double length, const char* colour) {
        const Vec2 tip(x(from.x()) + length * direction.x(), y(from.y()) - length * direction.y());
        const Vec2 across(direction.y(), direction.x());  // in pixels, y down
        const Vec2 along(direction.x(), -direction.y());
        const Vec2 left = tip - 8 * along + 4 * across, right = tip - 8 * along - 4 * across;
        body_ += fmt::format(
            "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}\" "
            "fill=\"none\" "
            "stroke=\"{}\" stroke-width=\"1.6\"/>\n",
            x(from.x()), y(from.y()), tip.x(), tip.y(), left.x(), left.y(), tip.x(), tip.y(), right.x(),
            right.y(), colour);
    }
    void label(double px, double py, const std::string& text, const std::string& style = "") {
        body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", px, py, style,
                             report::escape(text));
    }
    /// A numbered mark at a place in pixels.
    void mark(double px, double py, std::size_t number) {
        body_ += fmt::format(
            "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"8\" fill=\"white\" stroke=\"#c0392b\"/><text "
            "x=\"{0:.1f}\" "
            "y=\"{2:.1f}\" text-anchor=\"middle\" font-size=\"10\" fill=\"#c0392b\">{3}</text>\n",
            px, py, py + 3.5, number);
    }
    const std::string& body() const { return body_; }

  private:
    Box tank_;
    double scale_;
    std::string body_;
};

constexpr const char* probe_line = "stroke=\"#c0392b\" stroke-width=\"3\"";
constexpr const char* probe_column = "stroke=\"#c0392b\" stroke-width=\"1\" stroke-dasharray=\"3 4\"";

void draw_fluids(Drawing& drawing, const Scene& scene) {
    if (scene.air) {
        for (const Box& box : scene.air_boxes) drawing.rectangle(box, "fill=\"#eef3f8\"");
    }
    for (const Box& box : scene.water_boxes) {
        drawing.rectangle(box, "fill=\"#5b9bd5\"");
        const Vec2 size = box.high - box.low;
        drawing.label(drawing.x(0.5 * (box.low.x() + box.high.x())), drawing.y(box.low.y() + 0.25 * size.y()),
                      fmt::format("water {:.4g} m × {:.4g} m", size.x(), size.y()),
                      "text-anchor=\"middle\" fill=\"white\"");
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
        drawing.polygon(body.outline, "fill=\"#d9c9a8\" stroke=\"#5b4a26\" stroke-width=\"1.4\"");
        const Vec2 centre = body.body.position;
        if (body.body.velocity.norm() > 0)
            drawing.arrow(centre, body.body.velocity.normalized(), 42, "#5b4a26");
        drawing.label(drawing.x(centre.x()), drawing.y(centre.y()) + 4, "⊕",
                      "text-anchor=\"middle\" font-size=\"12\" fill=\"#5b4a26\"");
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

void draw_tank(Drawing& drawing, const Scene& scene) {
    drawing.rectangle(scene.tank, "fill=\"none\" stroke=\"#333\" stroke-width=\"2\"");
    const Vec2 size = scene.tank.high - scene.tank.low;
    drawing.label(0.5 * drawing.width(), drawing.height() + 20, fmt::format("{:.4g} m", size.x()),
                  "text-anchor=\"middle\"");
    drawing.label(-8, 0.5 * drawing.height(), fmt::format("{:.4g} m", size.y()), "text-anchor=\"end\"");
    if (scene.model.gravity.norm() == 0) return;
    const Vec2 corner = scene.tank.high - 0.06 * Vec2(size.x(), size.x());
    drawing.arrow(corner, scene.model.gravity.normalized(), 30, "#333333");
    drawing.label(drawing.x(corner.x()) - 8, drawing.y(corner.y()) + 18, "g", "text-anchor=\"end\"");
}

/// Writes the key below the drawing and returns where it ends [px].
double draw_key(Drawing& drawing, const Key& key) {
    double row = drawing.height() + 44;
    for (const std::string& entry : key) {
        const std::string shown = entry.size() > 100 ? entry.substr(0, 97) + "..." : entry;
        drawing.label(0, row, shown, "font-size=\"11\" fill=\"#444\"");
        row += line_height;
    }
    return row;
}

}  // namespace

std::string sketch_svg(const Scene& scene) {
    Drawing drawing(scene.tank);
    Key key;
    for (const BodySpec& body : scene.bodies) key.push_back("⊕ " + description_of(body));
    draw_fluids(drawing, scene);
    draw_bodies(drawing, scene);
    draw_tank(drawing, scene);
    draw_probes(drawing, scene, key);
    const double end = draw_key(drawing, key);
    constexpr double left = 62, right = 80, top = 26;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.1f} {:.1f} {:.1f} {:.1f}\" "
        "font-family=\"sans-serif\" font-size=\"13\" role=\"img\" aria-label=\"set-up of the "
        "scene\">{}</svg>",
        -left, -top, std::max(drawing.width(), 520.0) + left + right, end + top, drawing.body());
}

}  // namespace wetdeck

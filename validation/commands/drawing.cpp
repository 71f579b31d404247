// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reports/page/html.hpp"
#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/child_process.hpp"

namespace wetdeck {
namespace {

constexpr double left = 62, right = 80, top = 26, least_width = 520;

std::string gnuplot_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

std::string dash_of(const Stroke& stroke, const char* svg_or_gnuplot) {
    return stroke.dashed ? svg_or_gnuplot : "";
}

}  // namespace

Drawing::Drawing(const Box& area, std::string name, Vec2 largest) : area_(area), name_(std::move(name)) {
    const Vec2 size = area.high - area.low;
    scale_ = std::min(largest.x() / size.x(), largest.y() / size.y());
}

void Drawing::polygon(const Outline& corners, const char* fill, const Stroke& edge) {
    std::string points, corners_of_object;
    for (std::size_t k = 0; k <= corners.size(); ++k) {
        const Vec2 corner = corners[k % corners.size()];
        if (k < corners.size()) points += fmt::format("{:.2f},{:.2f} ", x(corner.x()), y(corner.y()));
        corners_of_object +=
            fmt::format("{} {:.2f},{:.2f} ", k == 0 ? "from" : "to", x(corner.x()), y(corner.y()));
    }
    const bool filled = *fill != 0, drawn = *edge.colour != 0;
    svg_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"", points, filled ? fill : "none");
    if (drawn)
        svg_ += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"{}", edge.colour, edge.width,
                            dash_of(edge, " stroke-dasharray=\"3 4\""));
    svg_ += "/>\n";
    if (filled)
        gnuplot_ += fmt::format("set object {} polygon {} fs solid noborder fc rgb '{}'\n", ++objects_,
                                corners_of_object, fill);
    if (drawn)
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 a = corners[k], b = corners[(k + 1) % corners.size()];
            gnuplot_ += fmt::format(
                "set arrow from {:.2f},{:.2f} to {:.2f},{:.2f} nohead front lc rgb '{}' lw {}{}\n", x(a.x()),
                y(a.y()), x(b.x()), y(b.y()), edge.colour, edge.width, dash_of(edge, " dt 3"));
        }
}

void Drawing::line_px(Vec2 a, Vec2 b, const Stroke& stroke) {
    svg_ += fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
        "stroke-width=\"{}\"{}/>\n",
        a.x(), a.y(), b.x(), b.y(), stroke.colour, stroke.width,
        dash_of(stroke, " stroke-dasharray=\"3 4\""));
    gnuplot_ +=
        fmt::format("set arrow from {:.2f},{:.2f} to {:.2f},{:.2f} nohead front lc rgb '{}' lw {}{}\n", a.x(),
                    a.y(), b.x(), b.y(), stroke.colour, stroke.width, dash_of(stroke, " dt 3"));
}

void Drawing::line(Vec2 a, Vec2 b, const Stroke& stroke) {
    line_px({x(a.x()), y(a.y())}, {x(b.x()), y(b.y())}, stroke);
}

void Drawing::arrow(Vec2 from, Vec2 direction, double length, const char* colour) {
    const Vec2 along(direction.x(), -direction.y()), across(direction.y(), direction.x());  // in pixels
    const Vec2 begin(x(from.x()), y(from.y())), tip = begin + length * along;
    const Stroke stroke{colour, 1.6};
    line_px(begin, tip, stroke);
    line_px(tip, tip - 8 * along + 4 * across, stroke);
    line_px(tip, tip - 8 * along - 4 * across, stroke);
}

void Drawing::label(double px, double py, const std::string& text, const TextStyle& style) {
    static const char* const svg_anchors[] = {"start", "middle", "end"};
    static const char* const gnuplot_anchors[] = {"left", "center", "right"};
    const auto anchor = static_cast<std::size_t>(style.anchor);
    svg_ += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n", px, py,
        svg_anchors[anchor], style.size, style.colour, report::escape(text));
    gnuplot_ +=
        fmt::format("set label {} at {:.1f},{:.1f} {} front noenhanced font ',{}' textcolor rgb '{}'\n",
                    gnuplot_text(text), px, py - 0.35 * style.size, gnuplot_anchors[anchor],
                    0.75 * style.size, style.colour);
}

void Drawing::mark(double px, double py, std::size_t number) {
    svg_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"8\" fill=\"white\" stroke=\"#c0392b\"/>\n",
                        px, py);
    gnuplot_ += fmt::format(
        "set object {} circle at {:.1f},{:.1f} size 8 front fs solid border lc rgb '#c0392b' fc rgb "
        "'white'\n",
        ++objects_, px, py);
    label(px, py + 3.5, std::to_string(number), {Anchor::middle, 10, "#c0392b"});
}

std::string Drawing::svg() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.1f} {:.1f} {:.1f} {:.1f}\" "
        "font-family=\"sans-serif\" font-size=\"13\" role=\"img\" aria-label=\"{}\">{}</svg>",
        -left, -top, std::max(width(), least_width) + left + right, end_ + top, report::escape(name_), svg_);
}

void Drawing::write(const std::filesystem::path& file) const {
    const std::string ending = file.extension();
    if (ending == ".svg") return atomic_write(file, svg() + "\n");
    if (ending != ".png")
        throw InputError(fmt::format("{}: expected a file name that ends in .png or .svg", file.string()));
    constexpr double pixels = 2;  // of the picture in one of the drawing
    const double wide = std::max(width(), least_width) + left + right, high = end_ + top + 10;
    const std::filesystem::path drawn = temporary_name(file);
    const std::filesystem::path script = drawn.string() + ".gnuplot";
    atomic_write(
        script,
        fmt::format(
            "set terminal pngcairo size {:.0f},{:.0f} fontscale {} linewidth {} font 'DejaVu Sans,10'\n"
            "set encoding utf8\nset output {}\nunset border\nunset tics\nunset key\n"
            "set margins 0,0,0,0\nset xrange [{:.1f}:{:.1f}]\nset yrange [{:.1f}:{:.1f}]\n{}"
            "plot NaN notitle\n",
            pixels * wide, pixels * high, pixels, pixels, gnuplot_text(drawn.string()), -left, wide - left,
            high - top, -top, gnuplot_));
    const ShellResult result = run_in_shell("gnuplot " + shell_quoted(script.string()));
    std::error_code error;
    std::filesystem::remove(script, error);
    if (!result.succeeded() || !std::filesystem::exists(drawn))
        throw EnvironmentError(
            fmt::format("{}: gnuplot failed (status {}): {}", file.string(), result.status, result.output));
    std::filesystem::rename(drawn, file, error);
    if (error) throw EnvironmentError(fmt::format("{}: {}", file.string(), error.message()));
}

}  // namespace wetdeck

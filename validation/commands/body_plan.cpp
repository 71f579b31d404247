// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/body_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "reports/page/html.hpp"
#include "validation/sections/section_figures.hpp"
#include "validation/store/png.hpp"

namespace wetdeck {
namespace {

enum class Shown { all, left, right };

/// Adds what lies on the side that is shown; pieces on the centre line are left out.
void add_clipped(Vec2 a, Vec2 b, Shown shown, std::size_t row, std::vector<PlanLine>& lines) {
    if (shown != Shown::all) {
        const double side = shown == Shown::right ? 1 : -1;
        if (side * a.x() <= 0 && side * b.x() <= 0) return;
        const auto on_axis = [](Vec2 p, Vec2 q) {
            return Vec2(0, p.y() + (q.y() - p.y()) * p.x() / (p.x() - q.x()));
        };
        if (side * a.x() < 0)
            a = on_axis(a, b);
        else if (side * b.x() < 0)
            b = on_axis(a, b);
    }
    lines.push_back({a, b, row});
}

Box box_of(const std::vector<PlanLine>& lines) {
    Box box;  // the centre line is part of it
    if (lines.empty()) return box;
    box.low.y() = box.high.y() = lines.front().begin.y();
    for (const PlanLine& line : lines)
        for (const Vec2& point : {line.begin, line.end}) {
            box.low = box.low.cwiseMin(point);
            box.high = box.high.cwiseMax(point);
        }
    return box;
}

/// Metres to pixels.
struct Scale {
    Box box;
    double factor, margin;
    Scale(const std::vector<PlanLine>& lines, double width, double border)
        : box(box_of(lines)), margin(border) {
        const Vec2 size = (box.high - box.low).cwiseMax(Vec2::Constant(1e-9));
        factor = (width - 2 * border) / std::max(size.x(), 0.7 * size.y());
    }
    Vec2 operator()(Vec2 p) const {
        return {margin + factor * (p.x() - box.low.x()), margin + factor * (box.high.y() - p.y())};
    }
    double width() const { return 2 * margin + factor * (box.high.x() - box.low.x()); }
    double height() const { return 2 * margin + factor * (box.high.y() - box.low.y()); }
};

/// Where each row is labelled [pixels]: beside its point furthest out and up, further down where another
/// label stands there already.
std::map<std::size_t, Vec2> label_places(const std::vector<PlanLine>& lines, const Scale& scale) {
    constexpr double line_height = 12, width = 20;
    std::map<std::size_t, Vec2> places;
    for (const PlanLine& line : lines)
        for (const Vec2& point : {line.begin, line.end}) {
            Vec2& best = places.try_emplace(line.row, point).first->second;
            if (point.y() + std::abs(point.x()) > best.y() + std::abs(best.x())) best = point;
        }
    for (auto each = places.begin(); each != places.end(); ++each) {
        each->second = scale(each->second) + Vec2(each->second.x() < 0 ? -width : 4, -3);
        const auto covered = [&](const auto& other) {
            const Vec2 apart = (each->second - other.second).cwiseAbs();
            return apart.x() < width && apart.y() < line_height - 1e-6;
        };
        for (auto other = places.begin(); (other = std::find_if(places.begin(), each, covered)) != each;)
            each->second.y() = other->second.y() + line_height;
    }
    return places;
}

/// Round steps of a grid, about six over a length.
double grid_step(double length) {
    const double rough = std::max(length, 1e-9) / 6, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= rough) return step * power;
    return 10 * power;
}

/// Grey levels, drawn at three times the size and averaged down.
class Canvas {
  public:
    Canvas(int width, int height)
        : width_(width),
          height_(height),
          dark_(static_cast<std::size_t>(fine * width) * static_cast<std::size_t>(fine * height)) {}

    void line(Vec2 a, Vec2 b, double darkness) {
        const Vec2 from = fine * a, way = fine * (b - a);
        const int steps = std::max(1, static_cast<int>(std::ceil(2 * way.norm())));
        for (int k = 0; k <= steps; ++k) {
            const Vec2 at = from + way * k / steps;
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    put(static_cast<int>(at.x()) + dx, static_cast<int>(at.y()) + dy, darkness);
        }
    }

    /// Digits of three times five dots.
    void number(Vec2 at, std::size_t value) {
        static constexpr std::array<std::uint16_t, 10> digits = {075557, 026227, 071747, 071717, 055711,
                                                                 074717, 074757, 071111, 075757, 075717};
        for (const char digit : std::to_string(value)) {
            const unsigned dots = digits[static_cast<std::size_t>(digit - '0')];
            for (int dot = 0; dot < 15; ++dot)
                if ((dots >> (14 - dot) & 1U) != 0) block(at + Vec2(2.0 * (dot % 3), 2.0 * (dot / 3)));
            at.x() += 8;
        }
    }

    std::vector<unsigned char> png() const {
        constexpr int levels = 16;
        std::vector<Rgb> palette, pixels;
        for (int k = 0; k < levels; ++k) {
            const auto grey = static_cast<std::uint8_t>(255 - 255 * k / (levels - 1));
            palette.push_back({grey, grey, grey});
        }
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                double sum = 0;
                for (int dy = 0; dy < fine; ++dy)
                    for (int dx = 0; dx < fine; ++dx) sum += dark_[index(fine * x + dx, fine * y + dy)];
                const auto grey = static_cast<std::uint8_t>(255 * (1 - sum / (fine * fine)));
                pixels.push_back({grey, grey, grey});
            }
        return encode_png(pixels, width_, height_, palette);
    }

  private:
    static constexpr int fine = 3;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(fine * width_) +
               static_cast<std::size_t>(x);
    }
    void put(int x, int y, double darkness) {
        if (x < 0 || y < 0 || x >= fine * width_ || y >= fine * height_) return;
        double& dark = dark_[index(x, y)];
        dark = std::max(dark, darkness);
    }
    void block(Vec2 at) {
        for (int dx = 0; dx < 2 * fine; ++dx)
            for (int dy = 0; dy < 2 * fine; ++dy)
                put(static_cast<int>(fine * at.x()) + dx, static_cast<int>(fine * at.y()) + dy, 0.8);
    }
    int width_, height_;
    std::vector<double> dark_;
};

}  // namespace

std::vector<PlanLine> body_plan(const SectionFile& file) {
    std::vector<PlanLine> lines;
    std::size_t row = 0;
    for (std::size_t k = 0; k < file.stations.size(); ++k) {
        const bool forward = file.bow_first == (2 * k < file.stations.size());
        const Shown shown = file.drawn_as_body_plan ? Shown::all : forward ? Shown::right : Shown::left;
        const auto& outlines = file.stations[k].outlines;
        if (outlines.empty()) ++row;
        for (const SectionOutline& outline : outlines) {
            ++row;
            const bool whole = outline.closed || !file.drawn_as_body_plan;
            const Outline corners = whole ? whole_outline(outline) : outline.corners;
            for (std::size_t i = 0; i + (whole ? 0 : 1) < corners.size(); ++i)
                add_clipped(corners[i], corners[(i + 1) % corners.size()], shown, row, lines);
        }
    }
    return lines;
}

std::string body_plan_svg(const SectionFile& file) {
    const std::vector<PlanLine> lines = body_plan(file);
    const Scale scale(lines, 900, 50);
    std::string body;
    const auto stroke = [&](Vec2 a, Vec2 b, const char* style) {
        body += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n",
                            scale(a).x(), scale(a).y(), scale(b).x(), scale(b).y(), style);
    };
    const auto label = [&](Vec2 at, const std::string& text, const char* anchor) {
        body += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", at.x(), at.y(),
                            anchor, report::escape(text));
    };
    const Box& box = scale.box;
    const double step = grid_step((box.high - box.low).maxCoeff());
    for (double y = std::ceil(box.low.y() / step - 1e-9) * step; y <= box.high.y() + 1e-9; y += step) {
        stroke({box.low.x(), y}, {box.high.x(), y}, "stroke=\"#ddd\"");
        label({2, scale({0, y}).y() + 4}, fmt::format("{:.4g}", y + 0.0), "start");
    }
    for (double x = std::ceil(box.low.x() / step - 1e-9) * step; x <= box.high.x() + 1e-9; x += step) {
        stroke({x, box.low.y()}, {x, box.high.y()}, "stroke=\"#ddd\"");
        label(scale({x, box.low.y()}) + Vec2(0, 16), fmt::format("{:.4g}", std::abs(x)), "middle");
    }
    stroke({0, box.low.y()}, {0, box.high.y()}, "stroke=\"#888\" stroke-dasharray=\"8 3 2 3\"");
    for (const PlanLine& line : lines)
        stroke(line.begin, line.end, "stroke=\"#16324f\" stroke-width=\"1.2\" stroke-linecap=\"round\"");
    for (const auto& [row, place] : label_places(lines, scale)) label(place, std::to_string(row), "start");
    const std::string title = file.drawn_as_body_plan
                                  ? "sections as drawn; metres"
                                  : "left: aft, right: forward; numbers: rows of the list; metres";
    label({scale.width() / 2, scale.height() - 8}, title, "middle");
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
        "{0:.0f} "
        "{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\" role=\"img\" aria-label=\"body plan\">\n<rect "
        "width=\"100%\" height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
        scale.width(), scale.height(), body);
}

std::vector<unsigned char> body_plan_png(const SectionFile& file) {
    const std::vector<PlanLine> lines = body_plan(file);
    const Scale scale(lines, 1200, 40);
    Canvas canvas(static_cast<int>(std::ceil(scale.width())), static_cast<int>(std::ceil(scale.height())));
    const Box& box = scale.box;
    const double step = grid_step((box.high - box.low).maxCoeff());
    for (double y = std::ceil(box.low.y() / step - 1e-9) * step; y <= box.high.y() + 1e-9; y += step)
        canvas.line(scale({box.low.x(), y}), scale({box.high.x(), y}), 0.12);
    canvas.line(scale({0, box.low.y()}), scale({0, box.high.y()}), 0.4);
    for (const PlanLine& line : lines) canvas.line(scale(line.begin), scale(line.end), 1);
    for (const auto& [row, place] : label_places(lines, scale)) canvas.number(place - Vec2(0, 8), row);
    return canvas.png();
}

}  // namespace wetdeck

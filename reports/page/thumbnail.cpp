// SPDX-License-Identifier: BSD-3-Clause
#include "reports/page/thumbnail.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

constexpr double width = 150, height = 48, margin = 3;  // [px]
constexpr std::size_t columns = 150;                    ///< finer detail is not drawn

/// From the data to pixels.
struct Scale {
    Window x, y;

    std::string place(double at_x, double at_y) const {
        const double across = (at_x - x.begin) / (x.end - x.begin);
        const double up = (at_y - y.begin) / (y.end - y.begin);
        return fmt::format("{:.1f},{:.1f}", margin + across * (width - 2 * margin),
                           height - margin - up * (height - 2 * margin));
    }
    bool shows(double at_x, double at_y) const {
        return at_x >= x.begin && at_x <= x.end && at_y >= y.begin && at_y <= y.end;
    }
};

std::string drawn(const Figure& figure, const PlotSeries& series, const Scale& scale) {
    const bool points = series.style == Style::points;
    std::string line, dots;
    for (const std::size_t i : drawn_samples(figure, series, columns)) {
        const double x = series.data.x[i], y = series.data.y[i];
        if (!scale.shows(x, y)) continue;
        const std::string place = scale.place(x, y);
        line += (line.empty() ? "" : " ") + place;
        dots += fmt::format("M{}h0", place);
    }
    if (line.empty()) return "";
    if (points)
        return fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\"/>", dots,
                           escape(series.colour));
    return fmt::format("<polyline points=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"{}/>", line,
                       escape(series.colour),
                       series.style == Style::dashed ? " stroke-dasharray=\"4 3\"" : "");
}

}  // namespace

std::string thumbnail(const Figure& figure) {
    const Scale scale{data_range(figure, true), data_range(figure, false)};
    std::string curves;
    for (const PlotSeries& series : figure.series) curves += drawn(figure, series, scale);
    if (curves.empty()) return "";
    return fmt::format(
        "<svg class=\"thumbnail\" viewBox=\"0 0 {} {}\" role=\"img\" fill=\"none\"><title>{}</title>{}</svg>",
        width, height, escape(figure.title), curves);
}

}  // namespace wetdeck::report

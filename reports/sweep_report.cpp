// SPDX-License-Identifier: BSD-3-Clause
#include "reports/sweep_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/page/page.hpp"

namespace wetdeck::report {
namespace {

constexpr double two_sided = 1.96;  // half of a 95 % interval over the standard uncertainty

/// Points that differ by the first key alone.
using Row = std::vector<const SweepPoint*>;

/// The rows of the grid, in its order.
std::vector<Row> rows_of(const SweepResult& result) {
    std::vector<Row> rows;
    const auto length = static_cast<std::size_t>(result.axes.front().count);
    for (std::size_t k = 0; k < result.points.size(); ++k) {
        if (k % length == 0) rows.emplace_back();
        rows.back().push_back(&result.points[k]);
    }
    return rows;
}

/// "deadrise 30 deg, heel 5 deg": the values of the axes from one on.
std::string values_of(const SweepResult& result, const SweepPoint& point, std::size_t from) {
    std::vector<std::string> values;
    for (std::size_t k = from; k < result.axes.size(); ++k) {
        const SweepAxis& axis = result.axes[k];
        const std::string title = axis.title();
        const std::string name = title.substr(0, title.find(" ["));
        values.push_back(
            fmt::format("{} {}{}", name, number(point.at[k], 4), axis.unit.empty() ? "" : " " + axis.unit));
    }
    return fmt::format("{}", fmt::join(values, ", "));
}

/// The expected values, or those of another method, over the first key.
void add_line(Figure& figure, const Row& row, const std::string& label, const std::string& colour,
              const std::function<std::optional<double>(const SweepPoint&)>& value) {
    PlotSeries drawn = line(label, {}, colour);
    drawn.style = Style::dashed;
    for (const SweepPoint* point : row) {
        if (const auto y = value(*point)) {
            drawn.data.x.push_back(point->at.front());
            drawn.data.y.push_back(*y);
        }
    }
    if (!drawn.data.x.empty()) figure.series.push_back(drawn);
}

/// One quantity over the first key, a curve for each row.
Figure curves_of(const SweepResult& result, std::size_t quantity) {
    const SweepQuantity& first = result.points.front().quantities[quantity];
    Figure figure;
    figure.name = "sweep-" + slug(first.name);
    figure.identifier = first.name;
    figure.title = spaced(first.name);
    figure.x = {result.axes.front().title(), "", false, {}};
    figure.y = {spaced(first.name), first.unit, false, {}};
    std::size_t place = 0;
    for (const Row& row : rows_of(result)) {
        const std::string others = values_of(result, *row.front(), 1);
        const std::string colour = variant_colour(place);
        PlotSeries points;
        points.label = others.empty() ? "computed" : others;
        points.style = Style::points;
        points.colour = colour;
        for (const SweepPoint* point : row) {
            const SweepQuantity& q = point->quantities[quantity];
            if (!q.value) continue;
            points.data.x.push_back(point->at.front());
            points.data.y.push_back(*q.value);
            const double half = two_sided * q.u_num.value_or(0);
            points.low.push_back(*q.value - half);
            points.high.push_back(*q.value + half);
        }
        if (!points.data.x.empty()) figure.series.push_back(points);
        add_line(figure, row, place == 0 ? "expected" : "", colour,
                 [&](const SweepPoint& point) { return point.quantities[quantity].expected; });
        for (std::size_t k = 0; k < first.lines.size(); ++k)
            add_line(figure, row, place == 0 ? first.lines[k].first : "",
                     others.empty() ? variant_colour(k + 2) : "#888888",
                     [&](const SweepPoint& point) { return point.quantities[quantity].lines[k].second; });
        ++place;
    }
    figure.caption = "Bars: 95 % interval of the spacing's error; none where u_num is unknown.";
    return figure;
}

/// Value, its interval, and how far it is from what is expected.
std::string map_cell(const SweepQuantity& q) {
    if (!q.value) return escape(q.note.empty() ? "—" : q.note);
    std::string text = number(*q.value, 4);
    if (q.u_num) text += " ± " + number(two_sided * *q.u_num, 2);
    if (q.expected && *q.expected != 0)
        text += fmt::format(" ({} %)", signed_number(100 * (*q.value / *q.expected - 1), 2));
    return escape(text);
}

/// "inside" and "outside" the tolerance, for the colour.
std::string class_of(const SweepQuantity& q) {
    if (!q.value || !q.expected || !q.tolerance) return "";
    return std::abs(*q.value - *q.expected) <= *q.tolerance ? "within" : "outside";
}

/// The first key across, the others down.
std::string map_of(const SweepResult& result, std::size_t quantity) {
    const SweepAxis& across = result.axes.front();
    std::vector<std::string> headers = {result.axes.size() > 1 ? "" : across.title()};
    for (int k = 0; k < across.count; ++k)
        headers.push_back(
            fmt::format("{}{}", number(across.value(k), 4), across.unit.empty() ? "" : " " + across.unit));
    Table table(headers, "compact");
    for (const Row& row : rows_of(result)) {
        std::vector<Cell> cells = {text(values_of(result, *row.front(), 1))};
        for (const SweepPoint* point : row)
            cells.push_back(
                markup(map_cell(point->quantities[quantity]), class_of(point->quantities[quantity])));
        table.add(cells);
    }
    return table.html();
}

/// The curves that several quantities make up, one curve a point.
std::vector<Figure> design_curves(const SweepResult& result) {
    std::vector<Figure> figures;
    std::map<std::string, std::size_t> by_title;
    for (const SweepQuantity& q : result.points.front().quantities) {
        if (!q.curve || by_title.contains(q.curve->title)) continue;
        by_title[q.curve->title] = figures.size();
        Figure figure;
        figure.name = "sweep-" + slug(q.curve->title);
        figure.title = q.curve->title;
        figure.x = {q.curve->label, "", false, {}};
        figure.y = {spaced(q.name.substr(0, q.name.find_last_of('_'))), q.unit, false, {}};
        figures.push_back(figure);
    }
    constexpr std::size_t most_curves = 12;
    for (std::size_t p = 0; p < std::min(most_curves, result.points.size()); ++p) {
        const SweepPoint& point = result.points[p];
        for (const auto& [title, place] : by_title) {
            std::map<double, double> values;
            for (const SweepQuantity& q : point.quantities)
                if (q.curve && q.curve->title == title && q.value) values[q.curve->x] = *q.value;
            PlotSeries curve = line(values_of(result, point, 0), {}, variant_colour(p));
            curve.style = Style::line_and_points;
            for (const auto& [x, y] : values) {
                curve.data.x.push_back(x);
                curve.data.y.push_back(y);
            }
            if (!values.empty()) figures[place].series.push_back(curve);
        }
    }
    for (Figure& figure : figures)
        if (result.points.size() > most_curves)
            figure.caption = fmt::format("The first {} of {} points; sweep.csv has all.", most_curves,
                                         result.points.size());
    return figures;
}

std::string points_table(const SweepResult& result) {
    std::vector<std::string> headers;
    for (const SweepAxis& axis : result.axes) headers.push_back(axis.title());
    for (const char* title : {"state", "spacings [m]", "core-seconds"}) headers.emplace_back(title);
    Table table(headers, "compact");
    for (const SweepPoint& point : result.points) {
        std::vector<Cell> cells;
        for (const double at : point.at) cells.push_back(value(at, "-", 4));
        cells.push_back(text(point.status));
        cells.push_back(text(joined(point.dx, 4)));
        cells.push_back(value(point.core_seconds));
        table.add(cells);
    }
    return table.html();
}

std::string stamp_of(const SweepResult& result) {
    std::vector<std::string> texts;
    for (const auto& [name, value] : result.provenance) texts.push_back(name + " " + value);
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result,
                        const ReportInputs& inputs) {
    Pages pages(directory, inputs.plotly, stamp_of(result), inputs.single_file);
    Page& page = pages.add(
        "index", fmt::format("wetdeck sweep, {}", result.title.empty() ? result.scene : result.title),
        "sweep");
    page.add(paragraph(result.purpose));
    double core_seconds = 0;
    for (const SweepPoint& point : result.points) core_seconds += point.core_seconds;
    page.add(paragraph(fmt::format("{} points of the variant {}, {} core-seconds in all; every number is in "
                                   "sweep.csv.",
                                   result.points.size(), result.variant, number(core_seconds, 4)),
                       "soft"));
    if (!result.expected_source.empty())
        page.add(paragraph("Expected: " + result.expected_source + ".", "soft"));
    const std::vector<Figure> curves = design_curves(result);
    for (std::size_t k = 0; k < result.points.front().quantities.size(); ++k) {
        page.section(2, spaced(result.points.front().quantities[k].name));
        page.add(page.figure(curves_of(result, k)));
        page.add(map_of(result, k));
        if (k == 0)
            page.add(
                paragraph("Each cell: the value at the finest spacing, ± half of its 95 % interval where "
                          "three spacings are there, and its difference to what is expected.",
                          "soft"));
    }
    if (!curves.empty()) {
        page.section(2, "Design curves");
        page.add_figures(curves);
    }
    page.section(2, "Points");
    page.add(points_table(result));
    pages.write();
}

}  // namespace wetdeck::report

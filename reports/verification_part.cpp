// SPDX-License-Identifier: BSD-3-Clause
// Problems with exact solutions: what was claimed before the run, what came out, and the curves.
#include <fmt/format.h>

#include <algorithm>

#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

std::string joined(const std::vector<double>& values) {
    std::string out;
    for (const double value : values) out += (out.empty() ? "" : " → ") + number(value);
    return out;
}

Cell order_cell(const VerificationRow& row) {
    if (!row.claim.order) return text("none");
    const std::string range =
        fmt::format("{} to {}", number(row.claim.order->begin), number(row.claim.order->end));
    return markup(fmt::format("{}<br><span class=\"soft\">{}</span>",
                              row.order ? fmt::format("{:.2f}", *row.order) : "—", range),
                  "number");
}

std::string held(const VerificationRow& row) {
    if (row.within) return "<span class=\"badge good\">holds</span>";
    return row.claim.known_miss.empty() ? "<span class=\"badge bad\">does not hold</span>"
                                        : "<span class=\"badge bad\">does not hold, known</span>";
}

std::string claims_table(const VerificationProblem& problem) {
    Table table({"claim", "error, coarse to fine", "bound", "order, expected", "why this bound and order"},
                "compact");
    for (const VerificationRow& row : problem.rows) {
        std::string errors = joined(row.error);
        if (row.claim.resolution != "none")
            errors += "<br><span class=\"soft\">" + escape(row.claim.resolution) + " " +
                      joined(row.resolution) + "</span>";
        table.add({markup(fmt::format("<b>{}</b> {}<br>{}", escape(row.claim.quantity), held(row),
                                      escape(row.claim.meaning))),
                   markup(errors, "wide"), value(row.claim.bound), order_cell(row),
                   markup(escape(row.claim.reason), "wide")});
    }
    return table.html();
}

/// Errors over resolution, with the slope in the legend; a dotted bound would hide the points.
std::optional<Figure> error_figure(const VerificationProblem& problem) {
    Figure figure;
    figure.name = "verification-" + problem.name + "-errors";
    figure.title = problem.title + ": errors";
    figure.caption = "Errors over resolution, with the slope of the line through them.";
    figure.x = {"resolution", "-", true, {}};
    figure.y = {"error", "-", true, {}};
    for (const VerificationRow& row : problem.rows) {
        if (row.resolution.size() < 2 || !row.order) continue;
        PlotSeries series;
        series.style = Style::line_and_points;
        series.label = fmt::format("{}, slope {}", row.claim.quantity, number(*row.order, 2));
        series.data = {row.resolution, row.error};
        std::reverse(series.data.x.begin(), series.data.x.end());
        std::reverse(series.data.y.begin(), series.data.y.end());
        series.colour = variant_colour(figure.series.size());
        figure.series.push_back(std::move(series));
    }
    if (figure.series.empty()) return std::nullopt;
    return figure;
}

Figure curve_figure(const VerificationProblem& problem, const VerificationFigure& curves) {
    Figure figure;
    figure.name = "verification-" + problem.name + "-" + curves.title;
    figure.title = curves.title;
    figure.caption = "Dashed: exact.";
    figure.x = {curves.x_label, curves.x_unit, false, {}};
    figure.y = {curves.y_label, curves.y_unit, false, {}};
    for (const auto& [label, curve] : curves.computed) {
        PlotSeries series;
        series.label = label;
        series.data = curve;
        series.colour = run_colour(0, figure.series.size(), curves.computed.size());
        figure.series.push_back(std::move(series));
    }
    if (!curves.exact.x.empty()) {
        PlotSeries exact;
        exact.style = Style::dashed;
        exact.label = "exact";
        exact.colour = "#000000";
        exact.data = curves.exact;
        figure.series.push_back(std::move(exact));
    }
    return figure;
}

/// What does not hold comes first.
std::string misses(const std::vector<VerificationProblem>& problems) {
    Table table({"claim", "error, coarse to fine", "order, expected", "why"});
    for (const VerificationProblem& problem : problems) {
        if (!problem.unstable.empty())
            table.add({text(problem.name), text("a run died"), text("—"), text(problem.unstable)});
        for (const VerificationRow& row : problem.rows) {
            if (row.within) continue;
            const std::string why = row.claim.known_miss.empty() ? "not known" : row.claim.known_miss;
            table.add(
                {markup(fmt::format("<b>{}</b><br>{}", escape(row.claim.quantity), escape(problem.title))),
                 text(joined(row.error)), order_cell(row), markup(escape(why), "wide")});
        }
    }
    return table.empty() ? paragraph("Every claim holds.")
                         : "<h4>Claims that do not hold</h4>\n" + table.html();
}

}  // namespace

void add_verification_part(Page& page, const Summary& summary) {
    if (summary.verification.empty()) return;
    page.section(2, "Problems with exact solutions");
    page.add(
        paragraph("Every problem says what it claims before it is run: a bound of each error at the coarsest "
                  "resolution, which finer ones "
                  "must undercut by the lowest order claimed, and a range of orders where one is expected. "
                  "Exact solutions are computed "
                  "here, by quadrature, root finding and integration, not read from tables."));
    page.add(misses(summary.verification));
    for (const VerificationProblem& problem : summary.verification) {
        page.section(3, problem.title);
        page.add(paragraph("Exact: " + problem.exact));
        for (const std::string& note : problem.notes) page.add(paragraph(note, "notice"));
        page.add(claims_table(problem));
        std::vector<Figure> figures;
        for (const VerificationFigure& curves : problem.figures)
            figures.push_back(curve_figure(problem, curves));
        if (auto errors = error_figure(problem)) figures.push_back(std::move(*errors));
        page.add_figures(figures);
    }
}

}  // namespace wetdeck::report

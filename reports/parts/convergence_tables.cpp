// SPDX-License-Identifier: BSD-3-Clause
// Convergence of quantities and of whole curves with the particle spacing.
#include <fmt/format.h>

#include <algorithm>

#include "reports/figures/words.hpp"
#include "reports/parts/by_variant.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/curve_convergence.hpp"

namespace wetdeck::report {
namespace {

/// Numerical uncertainty of the finest value (95 %): of the index and of least squares, or the range of the
/// values where both are undefined.
std::string numerical_uncertainty(const ConvergenceRow& row) {
    const std::string fitted =
        row.least_squares ? fmt::format("least squares {}", number(*row.least_squares)) : "";
    if (row.gci_fine)
        return fmt::format("GCI {}{}{}", number(*row.gci_fine), fitted.empty() ? "" : ", ", fitted);
    if (!fitted.empty()) return fitted;
    if (row.value.size() < 2) return "—";
    const auto [low, high] = std::minmax_element(row.value.begin(), row.value.end());
    return fmt::format("range {} to {}", number(*low), number(*high));
}

std::string convergence_verdict(const ConvergenceRow& row) {
    if (!row.asymptotic_ratio) return row.verdict;
    return row.verdict + ", asymptotic ratio " + number(*row.asymptotic_ratio);
}

/// Of a row that converges; the order of values that drift apart says nothing.
Cell order_cell(std::optional<double> order, const std::string& verdict) {
    return order && *order > 0 && verdict != "divergent" ? value(order) : text("—");
}

std::string quantities_of(const Summary& summary, const std::string& scene, const std::string& variant) {
    Table table(
        {"quantity", "dx [m]", "value", "order", "extrapolated", "uncertainty at finest dx", "verdict"},
        "compact");
    for (const ConvergenceRow& row : summary.convergence) {
        if (row.scene != scene || row.variant != variant) continue;
        table.add({named(quantity_words(summary, scene, row.qoi), row.qoi), markup(joined(row.dx, 4)),
                   markup(joined(row.value, 4)), order_cell(row.order, row.verdict),
                   value(row.extrapolated, "-", 4), markup(numerical_uncertainty(row)),
                   text(convergence_verdict(row))});
    }
    return table.empty() ? "" : table.html();
}

std::string in_percent(std::vector<double> values) {
    for (double& each : values) each *= 100;
    return joined(values);
}

Cell percent(std::optional<double> share) {
    return value(share ? std::optional(100 * *share) : std::nullopt);
}

std::string curves_of(const Summary& summary, const std::string& scene, const std::string& variant) {
    Table table({"curve", "dx [m]", "rms difference to the next finer spacing, % of range", "order",
                 "GCI, % of range", "instants with monotonic convergence", "verdict"},
                "compact");
    for (const CurveConvergenceRow& row : summary.curve_convergence) {
        if (row.scene != scene || row.variant != variant) continue;
        const bool judged = row.dx.size() > 2;
        table.add({named(series_words(row.series), row.series), markup(joined(row.dx)),
                   markup(in_percent(relative_differences(row))), order_cell(row.order, row.verdict),
                   percent(relative_gci(row)), text(judged ? number(100 * row.monotone_share) + " %" : "—"),
                   text(row.verdict)});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace

std::string convergence_overview(const Summary& summary) {
    std::string out;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        if (runs.empty()) continue;
        const std::string& variant = runs.front()->record.variant;
        const std::string table = quantities_of(summary, scene.scene, variant);
        if (!table.empty()) out += details(fmt::format("{}, {}", scene.title, variant), table, out.empty());
    }
    return out.empty() ? paragraph("There are too few spacings to judge convergence.", "soft") : out;
}

std::string convergence_table(const Summary& summary, const AnalysisSpec& scene) {
    const std::string out = by_variant(variants_of(runs_of(summary, scene)), [&](const std::string& variant) {
        return quantities_of(summary, scene.scene, variant);
    });
    if (out.empty()) return paragraph("There are too few spacings to judge convergence.", "soft");
    return out +
           paragraph(
               "GCI: grid convergence index at the finest spacing, in the unit of the quantity. Without "
               "monotonic convergence the index is undefined, and the range of the values is given "
               "instead.",
               "soft");
}

std::string curve_convergence_table(const Summary& summary, const AnalysisSpec& scene) {
    std::string out;
    for (const std::string& variant : variants_of(runs_of(summary, scene))) {
        const std::string table = curves_of(summary, scene.scene, variant);
        if (!table.empty()) out += details("Variant " + variant, table, variant == scene.default_variant);
    }
    if (out.empty()) return "";
    return "<h4>Whole curves</h4>\n" + out +
           paragraph(
               "Each series is evaluated over the interval of its first comparison. The order follows from "
               "the two finest differences. Without monotonic convergence the index is undefined, and the "
               "last difference is the only estimate.",
               "soft");
}

void add_convergence_part(Page& page, const Summary& summary) {
    page.section(2, "Convergence");
    page.add(paragraph(
        "Quantities of the default variant of each scene; the page of a scene has all variants, whole "
        "curves and figures."));
    page.add(convergence_overview(summary));
}

}  // namespace wetdeck::report

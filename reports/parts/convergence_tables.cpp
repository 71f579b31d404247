// SPDX-License-Identifier: BSD-3-Clause
// Convergence of quantities and of whole curves with the particle spacing.
#include <fmt/format.h>

#include <algorithm>

#include "reports/parts/by_variant.hpp"
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

std::string quantities_of(const Summary& summary, const std::string& scene, const std::string& variant) {
    Table table(
        {"quantity", "dx [m]", "value", "order", "extrapolated", "uncertainty at finest dx", "verdict"},
        "compact");
    for (const ConvergenceRow& row : summary.convergence) {
        if (row.scene != scene || row.variant != variant) continue;
        table.add({markup(escape(row.qoi), "name"), markup(joined(row.dx, 4), "number"),
                   markup(joined(row.value, 4), "number"), value(row.order), value(row.extrapolated, "-", 4),
                   markup(numerical_uncertainty(row), "number"), text(convergence_verdict(row))});
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
        table.add({markup(escape(row.series), "name"), markup(joined(row.dx), "number"),
                   markup(in_percent(relative_differences(row)), "number"), value(row.order),
                   percent(relative_gci(row)), text(judged ? number(100 * row.monotone_share) + " %" : "—"),
                   text(row.verdict)});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace

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

}  // namespace wetdeck::report

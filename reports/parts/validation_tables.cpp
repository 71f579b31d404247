// SPDX-License-Identifier: BSD-3-Clause
// Comparison error with its uncertainty, and differences of curves separated into amplitude, timing and
// shape.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/figures/words.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

/// An uncertainty, and whether it rests on a judgement.
Cell with_basis(const ValidationRow& row, const char* name, std::optional<double> uncertainty) {
    if (!uncertainty) return text("unknown");
    const bool assumed = std::find(row.assumed.begin(), row.assumed.end(), name) != row.assumed.end();
    if (!assumed) return value(uncertainty);
    const bool of_data = std::string_view(name) == "u_data" && !row.assumed_reason.empty();
    return markup(fmt::format("{}<br><span class=\"soft\">assumed{}</span>", number(*uncertainty),
                              of_data ? ": " + escape(row.assumed_reason) : ""));
}

/// u_num with its two parts and where it comes from.
Cell numerical_cell(const ValidationRow& row) {
    if (!row.u_num) return text(row.u_num_source);
    const std::string parts = row.u_scatter ? fmt::format("u_grid {}, u_scatter {}<br>", number(*row.u_grid),
                                                          number(*row.u_scatter))
                                            : "";
    return markup(fmt::format("{}<br><span class=\"soft\">{}{}</span>", number(*row.u_num), parts,
                              escape(row.u_num_source)));
}

std::string error_text(const ValidationRow& row) {
    const std::string spread = row.u_val         ? " ± " + number(*row.u_val)
                               : row.u_known > 0 ? ", u_val at least " + number(row.u_known)
                                                 : ", u_val unknown";
    return signed_number(row.error) + spread;
}

/// "0.54 / 0.57", simulated over reference.
std::string both(const ComparisonResult& c, const char* name) {
    for (const CurveFeature& feature : c.features) {
        if (feature.name != name || (!feature.simulated && !feature.reference)) continue;
        return number_with_unit(feature.simulated, "-") + " / " + number_with_unit(feature.reference, "-");
    }
    return "—";
}

}  // namespace

namespace {

/// One table a variant; empty without rows.
std::string tables_of(const std::vector<ValidationRow>& rows, const Summary& summary,
                      const AnalysisSpec& scene) {
    std::string out;
    for (const std::string& variant : variants_of(runs_of(summary, scene))) {
        Table table({"quantity", "dx [m]", "simulation S", "reference D", "E = S − D ± u_val", "u_num",
                     "u_input", "u_data", "verdict"},
                    "compact");
        for (const ValidationRow& row : rows) {
            if (row.scene != scene.scene || row.variant != variant) continue;
            const std::string kind = row.kind ? "" : ", kind not stated";
            table.add({markup(fmt::format("<b>{}</b><br><span class=\"soft\">{}{}</span>",
                                          named_words(quantity_words(scene, row.quantity), row.quantity),
                                          escape(row.against), kind),
                              "wide"),
                       value(row.dx, "-", 4), value(row.simulated, unit_words(scene, row)),
                       value(row.reference, unit_words(scene, row)),
                       markup(escape(error_text(row)), "number"), numerical_cell(row),
                       with_basis(row, "u_input", row.u_input), with_basis(row, "u_data", row.u_data),
                       markup(fmt::format("<b>{}</b><br><span class=\"soft\">{}</span>",
                                          escape(verdict_words(scene, row)), escape(row.sentence)),
                              "wide")});
        }
        if (table.empty()) continue;
        out += details("Variant " + variant, table.html(), variant == scene.default_variant);
    }
    return out;
}

}  // namespace

std::string verification_table(const Summary& summary, const AnalysisSpec& scene) {
    const std::string out = tables_of(summary.agreement, summary, scene);
    if (out.empty()) return "";
    return out + paragraph(
                     "The same inputs on both sides, so that u_input is zero; an exact solution has no "
                     "uncertainty. Agreement verifies, and validates nothing.",
                     "soft");
}

std::string validation_table(const Summary& summary, const AnalysisSpec& scene) {
    const std::string out = tables_of(summary.validation, summary, scene);
    if (out.empty()) return paragraph("There is no measured value to compare with.", "soft");
    return out +
           paragraph(
               "After ASME V&V 20: E is the comparison error and u_val² = u_num² + u_input² + u_data², all "
               "standard uncertainties (k = 1). u_num² = u_grid² + u_scatter². u_grid, of the spacing: half "
               "the 95 % uncertainty of a least-squares fit to four or more spacings (Eça and Hoekstra), "
               "half the grid convergence index of three, or the range of the values at the three finest "
               "spacings if these do not converge monotonically. u_scatter, of the arrangement of the "
               "particles: the standard deviation of the replicates; where the spacings oscillate, or "
               "differ by no more than replicates do, u_grid is what their spread exceeds that of the "
               "replicates by. An uncertainty that is neither stated nor assumed by judgement is unknown and "
               "is not taken as zero; u_val "
               "then has only a lower bound. The error of the model lies within E ± 1.96 u_val with a "
               "confidence of 95 %. Where that includes zero, a model error of this size cannot be resolved. "
               "Variants with fewer than three spacings are not judged.",
               "soft");
}

std::string sensitivity_table(const Summary& summary, const AnalysisSpec& scene) {
    std::map<std::pair<std::string, std::string>, double> squares;  // of u_input, by variant and quantity
    for (const SensitivityRow& row : summary.sensitivity)
        if (row.scene == scene.scene) squares[{row.variant, row.quantity}] += row.u_input * row.u_input;
    Table table({"input", "varied", "standard uncertainty", "quantity", "at low", "at high", "u_input",
                 "share of u_input²"},
                "compact");
    for (const SensitivityRow& row : summary.sensitivity) {
        if (row.scene != scene.scene) continue;
        const double sum = squares.at({row.variant, row.quantity});
        table.add({markup(escape(row.key), "name"), text(number(row.low, 4) + " to " + number(row.high, 4)),
                   value(row.uncertainty), named(quantity_words(scene, row.quantity), row.quantity),
                   value(row.value_low, row.unit), value(row.value_high, row.unit),
                   value(row.u_input, row.unit),
                   text(sum > 0 ? number(100 * row.u_input * row.u_input / sum) + " %" : "—")});
    }
    if (table.empty()) {
        return scene.sensitivities.empty()
                   ? paragraph(
                         "Input uncertainty: the scene defines no input to vary, so u_input is unknown.",
                         "soft")
                   : paragraph(
                         "Input uncertainty: the scene defines inputs to vary, but this directory does not "
                         "hold the runs, so u_input is unknown.",
                         "soft");
    }
    std::string sources;
    for (const SensitivitySpec& spec : scene.sensitivities)
        sources += fmt::format("{}{}: {}{}", sources.empty() ? "" : "; ", spec.key,
                               spec.assumed ? "assumed, " : "", spec.source);
    return details(
        "Inputs varied for u_input",
        table.html() +
            paragraph("One input at a time is varied at the coarsest spacing of the default variant; other "
                      "variants take its u_input. "
                      "u_input = |difference of the quantity / difference of the input| × standard "
                      "uncertainty of the input. Sources: " +
                          sources + ".",
                      "soft"));
}

std::string agreement_table(const Runs& runs) {
    std::string out;
    for (const RunSummary* run : finest_of_each(runs)) {
        Table table({"comparison", "peak", "time of peak", "rise time", "integral", "mean", "magnitude",
                     "phase", "combined", "amplitude factor", "time shift", "shape"},
                    "compact");
        for (const ComparisonResult& c : run->comparisons) {
            if (c.features.empty()) continue;
            std::vector<Cell> row{markup(fmt::format("{}<br><span class=\"soft\">{}</span>", escape(c.title),
                                                     escape(kind_name(c.kind))),
                                         "wide")};
            for (const char* name : {"peak", "time of peak", "rise time", "impulse", "mean"})
                row.push_back(markup(escape(both(c, name)), "number"));
            const CurveAgreement& a = c.agreement;
            for (const auto& number_or_nothing :
                 {a.magnitude, a.phase, a.combined, a.amplitude_factor, a.time_shift, a.shape_error})
                row.push_back(value(number_or_nothing));
            table.add(row);
        }
        if (!table.empty())
            out += details(run_name(*run), table.html(), run->record.variant == runs.front()->record.variant);
    }
    if (out.empty()) return "";
    return "<h4>Amplitude, timing and shape at the finest spacings</h4>\n" + out +
           paragraph(
               "Features are given as simulation / reference, scaled, within the interval of the comparison. "
               "A peak at an end of the interval does not count; rise time: from 10 % to 90 % of the peak. "
               "Magnitude, phase, combined: error measures of Sprague and Geers. Amplitude factor and time "
               "shift are those that bring the simulation closest to the reference (a positive shift means "
               "that the simulation is late; at most a tenth of the interval); shape: rms difference that "
               "remains after both, divided by the range of the reference.",
               "soft");
}

}  // namespace wetdeck::report

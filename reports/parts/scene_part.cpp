// SPDX-License-Identifier: BSD-3-Clause
// The chapter of a scene.
#include <fmt/format.h>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/player.hpp"
#include "reports/parts/outcomes.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/flow_flags.hpp"

namespace wetdeck::report {
namespace {

void add_pictures(Page& page, const Runs& runs, const ReportInputs& inputs) {
    bool first = true;
    for (const RunSummary* run : runs) {
        const auto pictures = inputs.pictures.find(run->directory);
        if (pictures == inputs.pictures.end() || pictures->second.empty()) continue;
        if (first) page.section(2, "Fields", run->record.scene);
        page.add(details(run_name(*run), picture_player(pictures->second), first));
        first = false;
    }
}

/// One block per variant: the first is open, the others open on a click.
template <typename Figures>
void add_by_variant(Page& page, const Runs& runs, Figures&& figures_of) {
    const std::vector<std::string> variants = variants_of(runs);
    for (std::size_t v = 0; v < variants.size(); ++v) {
        const std::vector<Figure> figures = figures_of(with_variant(runs, variants[v]), v);
        if (figures.empty()) continue;
        if (v > 0) page.add("<details><summary>Variant " + escape(variants[v]) + "</summary>\n");
        page.add_figures(figures);
        if (v > 0) page.add("</details>\n");
    }
}

/// What a reader must know before the first number: one list, one line each.
std::string notice_list(const Summary& summary, const AnalysisSpec& scene) {
    std::string out;
    for (const RunDoubt& doubt : summary.doubts) {
        if (doubt.scene != scene.scene || doubt.about != RunDoubt::About::time_origin) continue;
        const std::string with = doubt.overrides.empty() ? "" : fmt::format(" with {}", doubt.overrides);
        out += "<li>" +
               escape(fmt::format("Doubt about {} {} dx {}{}: {}", doubt.scene, doubt.variant,
                                  number(doubt.dx), with, doubt.sentence)) +
               "</li>\n";
    }
    const Runs runs = runs_of(summary, scene);
    const RunSummary* finest = runs.empty() ? nullptr : finest_of_each(runs).front();
    if (finest != nullptr) {
        if (const auto note = compression_note(finest->record))
            out += "<li>" + escape(run_name(*finest) + ": " + *note) + "</li>\n";
    }
    return out.empty() ? "" : "<ul class=\"notice\">\n" + out + "</ul>\n";
}

void add_set_up(Page& page, const AnalysisSpec& scene, const ReportInputs& inputs) {
    if (!scene.purpose.empty()) page.add(paragraph(scene.purpose, "lead"));
    if (!scene.source.empty()) page.add(paragraph("Source: " + scene.source, "soft"));
    page.anchor("set-up-" + scene.scene, "Set-up of " + scene.scene);
    const auto sketch = inputs.sketches.find(scene.scene);
    if (sketch != inputs.sketches.end()) {
        page.add(fmt::format("<img class=\"sketch\" alt=\"Set-up of the scene\" src=\"{}\">\n",
                             data_address("image/svg+xml", sketch->second)));
    }
}

/// How the set-up and the schemes differ from those of the source.
void add_differences(Page& page, const AnalysisSpec& scene, const ReportInputs& inputs) {
    const auto schemes = inputs.schemes.find(scene.scene);
    if (schemes != inputs.schemes.end() && !schemes->second.empty()) {
        page.section(2, "Schemes against that of the source", scene.scene);
        page.add(
            paragraph("Made from the models themselves: every key in which a variant differs from the scheme "
                      "of the source as printed. A variant without a column does not differ."));
        page.add(schemes_table(schemes->second));
    }
    page.section(2, "Deviations from the source", scene.scene);
    page.add(scene.deviations.empty() ? paragraph("None stated.", "soft") : deviations_table(scene));
}

/// The main quantity of the scene in one sentence.
std::string outcome_sentence(const Summary& summary, const AnalysisSpec& scene) {
    const Outcome o = outcome_of(summary, scene);
    if (o.run == nullptr) return "";
    std::string html =
        fmt::format("<p class=\"lead\">{} {}", badge(o.verdict, o.tone), named_words(o.words, o.quantity));
    if (o.reached) html += ": " + escape(number_with_unit(o.reached, o.unit));
    if (o.expected)
        html += escape(fmt::format(" against {} ({})", number_with_unit(o.expected, o.unit), o.kind));
    const RunRecord& record = o.run->record;
    return html +
           escape(fmt::format("; {}, {}, {} core-seconds.", record.variant,
                              spacing_text(record.particle_spacing), number(record.cost.core_s))) +
           "</p>\n";
}

void add_comparisons(Page& page, const AnalysisSpec& scene, const Runs& runs) {
    page.section(2, "Curves against references", scene.scene);
    page.add(paragraph(
        "Simulations: solid lines, the finest spacing is the darkest. Exact solutions: dashed black "
        "lines. Measurements: black points, with bars or a band of one standard uncertainty where "
        "it is known. Other simulations: thin grey lines; agreement with them is no validation. "
        "Errors are evaluated over the shaded interval. Where a comparison is aligned on the peaks, each "
        "curve "
        "is shifted until its largest value is at zero; its note says by how much."));
    add_by_variant(page, runs,
                   [&](const Runs& some, std::size_t v) { return comparison_figures(scene, some, v); });
    page.add_figures(variant_figures(scene, runs));
    if (scene.comparisons.empty()) page.add(paragraph("The scene defines no curve to compare with.", "soft"));
    page.section(2, "Errors against references", scene.scene);
    page.add(comparison_tables(runs));
    page.add(paragraph(
        "NRMSE: root mean square difference divided by the range of the reference, both within the interval. "
        "Peak error: difference of the largest simulated and reference values, divided by the latter. Peak "
        "time error: time of the largest simulated value minus that of the reference, in the units of the "
        "axis. Reference uncertainty: relative standard uncertainty; where it is unknown, the difference "
        "cannot be attributed to the model.",
        "soft"));
    page.add(agreement_table(runs));
    page.add(peer_table(runs));
}

void add_provenance(Page& page, const AnalysisSpec& scene, const Runs& runs) {
    page.section(2, "Provenance", scene.scene);
    page.add(references_table(runs));
    page.add(unused_references_table(scene));
    page.add("<h4>Runs</h4>\n" + provenance_table(runs));
    const RunRecord& record = finest_of_each(runs).front()->record;
    if (!record.parameters.empty()) {
        Table table({"key", "value (SI)"});
        for (const auto& [key, content] : record.parameters) table.add({text(key), value(content, "-", 4)});
        page.add(details("Resolved parameters of " + run_name(*finest_of_each(runs).front()), table.html()));
    }
    if (!record.scene_text.empty()) {
        page.add(source_text("Scene file as read by the run", record.scene_text));
    }
}

}  // namespace

void add_scene_part(Page& page, const Summary& summary, const AnalysisSpec& scene,
                    const ReportInputs& inputs) {
    const Runs runs = runs_of(summary, scene);
    page.add(outcome_sentence(summary, scene) + notice_list(summary, scene));
    add_set_up(page, scene, inputs);
    if (runs.empty()) {
        page.add(paragraph("This directory holds no run of this scene.", "notice"));
        add_differences(page, scene, inputs);
        return;
    }
    add_failures(page, scene, runs);
    page.section(2, "Quantities of interest", scene.scene);
    page.add(quantities_table(scene, runs));
    if (const std::string statements = statements_table(summary, scene); !statements.empty()) {
        page.section(2, "Statements of the source", scene.scene);
        page.add(
            paragraph("What the text of the source says, against runs of the variants: at the finest "
                      "spacing that the runs compared have in common. Meeting a statement reproduces "
                      "the source and validates nothing."));
        page.add(statements);
    }
    add_comparisons(page, scene, runs);
    std::vector<Figure> uncompared = history_figures(scene, runs);
    for (Figure& profile : profile_figures(runs)) uncompared.push_back(std::move(profile));
    if (!uncompared.empty()) page.section(2, "Probes, loads and motion", scene.scene);
    page.add_figures(uncompared);

    page.section(2, "Convergence", scene.scene);
    page.add(convergence_table(summary, scene));
    page.add_figures(convergence_figures(summary, scene));
    page.add(curve_convergence_table(summary, scene));
    page.add_figures(curve_convergence_figures(summary, scene));

    if (const std::string replicates = replicates_table(summary, scene); !replicates.empty()) {
        page.section(2, "Replicates", scene.scene);
        page.add(replicates);
        page.add_figures(replicate_figures(summary, scene));
    }
    page.section(2, "Error and its uncertainty", scene.scene);
    page.add(validation_table(summary, scene));
    if (const std::string table = verification_table(summary, scene); !table.empty()) {
        page.section(2, "Beside exact solutions and other computations", scene.scene);
        page.add(table);
    }
    page.add(sensitivity_table(summary, scene));
    if (const std::string sound = sound_speed_table(summary, scene); !sound.empty()) {
        page.section(2, "Sound speed and spacing", scene.scene);
        page.add(sound);
    }

    page.section(2, "Ablation", scene.scene);
    page.add(ablation_table(summary, scene));

    page.section(2, "Conservation", scene.scene);
    page.add(conservation_table(runs));
    add_by_variant(page, runs, energy_figures);
    if (const std::string defects = phase_defects_table(runs); !defects.empty()) {
        page.section(2, "Voids, mixing and penetration", scene.scene);
        page.add(defects);
    }

    page.section(2, "Cost", scene.scene);
    page.add(cost_table(runs, scene));
    add_pictures(page, runs, inputs);
    add_side_by_side_part(page, scene, runs, inputs);

    add_differences(page, scene, inputs);
    page.section(2, "Limits of validity", scene.scene);
    std::string limits;
    for (const std::string& limit : scene.limits) limits += "<li>" + escape(limit) + "</li>\n";
    page.add(limits.empty() ? paragraph("None stated.", "soft") : "<ul>\n" + limits + "</ul>\n");
    add_provenance(page, scene, runs);
}

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// The worst results and what would improve most.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/words.hpp"
#include "reports/parts/outcomes.hpp"
#include "reports/parts/parts.hpp"
#include "reports/parts/tables.hpp"
#include "validation/metrics/energy_budget.hpp"
#include "validation/metrics/flow_flags.hpp"
#include "validation/metrics/verdict.hpp"

namespace wetdeck::report {
namespace {

using Addresses = std::map<std::string, std::string>;
constexpr std::size_t most_steps = 4;  ///< of one kind

/// How far the value is off with a confidence of 95 %, over the reference.
double least_error(const ValidationRow& row) {
    const double outside = std::abs(row.error) - confidence * row.u_known;
    return row.reference == 0 ? 0 : outside / std::abs(row.reference);
}

/// Rows of the variants that a scene runs by default.
std::vector<const ValidationRow*> default_rows(const Summary& summary) {
    std::vector<const ValidationRow*> rows;
    for (const AnalysisSpec& scene : scenes_of(summary)) {
        const Runs runs = runs_of(summary, scene);
        if (runs.empty()) continue;
        for (const auto* table : {&summary.validation, &summary.agreement})
            for (const ValidationRow& row : *table)
                if (row.scene == scene.scene && row.variant == runs.front()->record.variant)
                    rows.push_back(&row);
    }
    return rows;
}

std::string link(const Addresses& pages, const Summary& summary, const std::string& scene) {
    const std::string title = escape(scene_words(summary, scene));
    const auto found = pages.find(scene);
    return found == pages.end() ? title : fmt::format("<a href=\"{}\">{}</a>", found->second, title);
}

std::string item(const std::string& html) {
    return "<li>" + html + "</li>\n";
}

std::string described(const Summary& summary, const ValidationRow& row, const Addresses& pages) {
    const AnalysisSpec scene = scene_named(summary, row.scene);
    const std::string unit = unit_words(scene, row);
    std::string out =
        fmt::format("<b>{}</b>: {} is {}, {} against {} ({})", link(pages, summary, row.scene),
                    named_words(quantity_words(scene, row.quantity), row.quantity),
                    escape(verdict_words(scene, row)), escape(number(row.simulated)),
                    escape(number_with_unit(row.reference, unit)), escape(kind_words(row.kind)));
    if (row.reference != 0)
        out += escape(fmt::format(": {} % off, at least {} % with 95 % confidence",
                                  number(100 * std::abs(row.error / row.reference), 2),
                                  number(100 * least_error(row), 2)));
    return out + ".";
}

/// The largest error that is shown, of each scene.
std::string worst(const Summary& summary, const Addresses& pages) {
    std::vector<const ValidationRow*> shown;
    for (const ValidationRow* row : default_rows(summary))
        if (tone_of(*row) == Tone::bad) shown.push_back(row);
    std::stable_sort(shown.begin(), shown.end(),
                     [](const auto* a, const auto* b) { return least_error(*a) > least_error(*b); });
    std::string out;
    std::vector<std::string> seen;
    for (const ValidationRow* row : shown) {
        if (seen.size() == most_steps || std::find(seen.begin(), seen.end(), row->scene) != seen.end())
            continue;
        seen.push_back(row->scene);
        out += item(described(summary, *row, pages));
    }
    return out;
}

/// What would make most of the open verdicts: "finer spacing, for 7 values".
std::string help_wanted(const Summary& summary, const Addresses& pages) {
    std::map<std::string, std::map<std::string, int>> scenes;  // of each kind of help
    std::map<std::string, int> total;
    for (const ValidationRow* row : default_rows(summary)) {
        const std::string help = what_would_help(*row);
        if (error_is_shown(*row) || help == "—") continue;
        ++scenes[help][row->scene];
        ++total[help];
    }
    std::vector<std::pair<int, std::string>> sorted;
    for (const auto& [help, values] : total) sorted.emplace_back(-values, help);
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() > most_steps) sorted.resize(most_steps);
    std::string out;
    for (const auto& [values, help] : sorted) {
        std::string where;
        for (const auto& [scene, count] : scenes[help])
            where += fmt::format("{}{} {}", where.empty() ? "" : ", ", link(pages, summary, scene), count);
        out += item(fmt::format("{} {} <b>{}</b> would help most ({}).", -values,
                                values == -1 ? "value has no decision yet;" : "values have no decision yet;",
                                escape(help), where));
    }
    return out;
}

/// Flows that are doubtful at the finest spacing of a default variant, and scenes whose water is compressed.
std::string doubts(const Summary& summary, const Addresses& pages) {
    std::string out, compressed;
    for (const Outcome& outcome : outcomes_of(summary)) {
        if (outcome.run == nullptr || outcome.run->record.status != RunStatus::ok) continue;
        const RunRecord& record = outcome.run->record;
        std::vector<std::string> flags = flow_flags(record);
        if (compression_note(record)) {
            std::erase_if(flags,
                          [](const std::string& flag) { return flag.rfind("the water's density", 0) == 0; });
            compressed +=
                fmt::format("{}{} {} %", compressed.empty() ? "" : ", ", link(pages, summary, outcome.scene),
                            number(100 * *largest_value(record, "density_error_max"), 2));
        }
        if (!flags.empty())
            out += item(fmt::format("<b>{}</b>: {}.", link(pages, summary, outcome.scene),
                                    escape(fmt::format("{}", fmt::join(flags, "; ")))));
    }
    if (!compressed.empty())
        out += item(
            "<b>Compressed water</b>: the density changes by more than 1 %, so that peaks depend on the "
            "sound "
            "speed (" +
            compressed + "). The page of a scene says which speed would keep it below.");
    return out;
}

}  // namespace

std::string next_steps(const Summary& summary, const Addresses& pages) {
    const std::string items = worst(summary, pages) + doubts(summary, pages) + help_wanted(summary, pages);
    if (!items.empty()) return "<ul class=\"steps\">\n" + items + "</ul>\n";
    return summary.validation.empty() && summary.agreement.empty()
               ? ""
               : paragraph("No error is shown, and nothing is left open.");
}

}  // namespace wetdeck::report

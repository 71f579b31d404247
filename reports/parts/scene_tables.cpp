// SPDX-License-Identifier: BSD-3-Clause
// Quantities and comparisons of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/figures/words.hpp"
#include "reports/parts/by_variant.hpp"
#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

Cell quantity_cell(const QuantityResult& q) {
    if (!q.value) return text(q.note.empty() ? "—" : fmt::format("— {}", q.note));
    const std::string content = escape(number_with_unit(q.value, q.unit));
    if (!q.within) return markup(content, "number");
    return *q.within ? markup(content + " ✓", "inside") : markup(content + " ✗", "outside");
}

const QuantityResult* find_quantity(const RunSummary& run, const std::string& name) {
    const auto found = std::find_if(run.quantities.begin(), run.quantities.end(),
                                    [&](const QuantityResult& q) { return q.name == name; });
    return found == run.quantities.end() ? nullptr : &*found;
}

std::vector<std::string> quantity_names(const Runs& runs) {
    std::vector<std::string> names;
    for (const RunSummary* run : runs) {
        for (const QuantityResult& q : run->quantities) {
            if (std::find(names.begin(), names.end(), q.name) == names.end()) names.push_back(q.name);
        }
    }
    return names;
}

std::string expectation(const QuantityResult& q) {
    if (!q.expected) return "—";
    std::string out = number_with_unit(q.expected, q.unit);
    if (q.tolerance) out += " ± " + number_with_unit(q.tolerance, q.unit);
    return out;
}

std::string quantities_of_variant(const AnalysisSpec& scene, const Runs& runs) {
    std::vector<std::string> headers{"quantity"};
    for (const RunSummary* run : runs) headers.push_back("dx " + spacing_text(run->record.particle_spacing));
    headers.insert(headers.end(), {"expected", "at the finest spacing", "source"});
    Table table(headers);
    for (const std::string& name : quantity_names(runs)) {
        std::vector<Cell> row{named(quantity_words(scene, name), name)};
        const QuantityResult* last = nullptr;
        for (const RunSummary* run : runs) {
            const QuantityResult* q = find_quantity(*run, name);
            if (q != nullptr) last = q;
            row.push_back(q != nullptr ? quantity_cell(*q) : text("—"));
        }
        const QuantityResult* finest = find_quantity(*runs.back(), name);
        row.push_back(markup(escape(expectation(*last)), "number"));
        row.push_back(verdict(finest != nullptr ? finest->within : std::nullopt));
        row.push_back(text(last->expected_source.empty() ? "—" : last->expected_source));
        table.add(row);
    }
    return table.empty() ? paragraph("None.", "soft") : table.html();
}

/// The cell that the rows of one comparison share.
Cell comparison_cell(const ComparisonResult& c, std::size_t rows) {
    return {fmt::format("<b>{}</b><br>{}<br><span class=\"soft\">reference uncertainty: {}</span>",
                        named_words(c.title, c.quantity), escape(c.reference), uncertainty_text(c)),
            "", rows};
}

Cell comparison_verdict(const ComparisonResult& c) {
    Cell cell = verdict(verdict_of(c));
    if (c.available && c.judged && !c.nrmse) cell = markup("<span class=\"badge warn\">not computed</span>");
    if (!c.note.empty()) cell.html += fmt::format(" {}", escape(c.note));
    return cell;
}

std::string comparisons_of_kind(const Runs& runs, std::optional<ReferenceKind> kind) {
    Table table({"comparison", "dx", "NRMSE", "tolerance", "verdict", "peak error", "peak time error"});
    std::size_t largest = 0;  // an unstable run may have fewer comparisons
    for (const RunSummary* run : runs) largest = std::max(largest, run->comparisons.size());
    for (std::size_t k = 0; k < largest; ++k) {
        Runs rows;
        std::copy_if(runs.begin(), runs.end(), std::back_inserter(rows), [&](const RunSummary* run) {
            return k < run->comparisons.size() && run->comparisons[k].kind == kind;
        });
        for (const RunSummary* run : rows) {
            const ComparisonResult& c = run->comparisons[k];
            std::vector<Cell> cells{value(run->record.particle_spacing, "m", 4),
                                    value(c.nrmse),
                                    value(c.tolerance),
                                    comparison_verdict(c),
                                    value(c.peak_error),
                                    value(c.time_error)};
            if (run == rows.front()) cells.insert(cells.begin(), comparison_cell(c, rows.size()));
            table.add(cells);
        }
    }
    if (table.empty()) return "";
    return "<h4>" + escape("Compared with " + kind_name(kind)) + "</h4>\n" + table.html();
}

std::string comparisons_of_variant(const Runs& runs) {
    std::set<std::optional<ReferenceKind>> kinds;
    for (const RunSummary* run : runs) {
        for (const ComparisonResult& c : run->comparisons) kinds.insert(c.kind);
    }
    // Measurements first; peer simulations never share a table with them.
    std::string out;
    for (const ReferenceKind kind : {ReferenceKind::experiment, ReferenceKind::analytic,
                                     ReferenceKind::stated, ReferenceKind::peer_simulation}) {
        if (kinds.contains(kind)) out += comparisons_of_kind(runs, kind);
    }
    if (kinds.contains(std::nullopt)) out += comparisons_of_kind(runs, std::nullopt);
    return out.empty() ? paragraph("No comparisons.", "soft") : out;
}

}  // namespace

Cell status_cell(const RunRecord& record) {
    const bool ok = record.status == RunStatus::ok;
    return markup(
        fmt::format("<span class=\"badge {}\">{}</span>", ok ? "good" : "bad", to_string(record.status)));
}

std::optional<bool> verdict_of(const ComparisonResult& comparison) {
    return comparison.available && comparison.judged ? std::optional(comparison.within) : std::nullopt;
}

std::string uncertainty_text(const ComparisonResult& c) {
    if (const auto& u = c.reference_uncertainty)
        return u->relative() ? fmt::format("{} %", number(100 * u->value)) : number(u->value);
    return c.kind && describe(*c.kind).exact ? "none" : "unknown";
}

std::string kind_name(std::optional<ReferenceKind> kind) {
    return kind ? describe(*kind).heading : "references of unknown kind";
}

std::string deviations_table(const AnalysisSpec& scene) {
    Table table({"item", "source", "this scene", "reason"});
    for (const Deviation& d : scene.deviations) {
        table.add({text(d.item), text(d.source), text(d.used), markup(escape(d.reason), "wide")});
    }
    return table.html();
}

std::string schemes_table(const std::vector<SchemeRow>& rows) {
    std::vector<std::string> variants, keys;
    std::map<std::string, const SchemeRow*> row_of;
    std::map<std::pair<std::string, std::string>, std::string> used;
    for (const SchemeRow& row : rows) {
        if (std::find(variants.begin(), variants.end(), row.variant) == variants.end())
            variants.push_back(row.variant);
        if (row_of.emplace(row.key, &row).second) keys.push_back(row.key);
        used[{row.key, row.variant}] = row.used;
    }
    std::vector<std::string> headers = {"key", "meaning", "equation", "source"};
    headers.insert(headers.end(), variants.begin(), variants.end());
    Table table(headers, "compact");
    for (const std::string& key : keys) {
        const SchemeRow& row = *row_of.at(key);
        std::vector<Cell> cells = {text(key), text(row.meaning), text(row.equation), text(row.source)};
        for (const std::string& variant : variants) {
            const auto found = used.find({key, variant});
            cells.push_back(text(found == used.end() ? "same" : found->second));
        }
        table.add(cells);
    }
    return table.html();
}

std::string quantities_table(const AnalysisSpec& scene, const Runs& runs) {
    const std::string out = by_variant(variants_of(runs), [&](const std::string& variant) {
        return quantities_of_variant(scene, with_variant(runs, variant));
    });
    return out + paragraph("✓ within, ✗ outside the stated tolerance; no mark: no expected value.", "soft");
}

std::string comparison_tables(const Runs& runs) {
    return by_variant(variants_of(runs), [&](const std::string& variant) {
        return comparisons_of_variant(with_variant(runs, variant));
    });
}

}  // namespace wetdeck::report

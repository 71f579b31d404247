// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene's chapter.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/html.hpp"
#include "reports/parts.hpp"

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

std::string quantities_of_variant(const Runs& runs) {
    std::vector<std::string> headers{"quantity"};
    for (const RunSummary* run : runs) headers.push_back("dx " + spacing_text(run->record.particle_spacing));
    headers.insert(headers.end(), {"expected", "finest spacing", "source"});
    Table table(headers);
    for (const std::string& name : quantity_names(runs)) {
        std::vector<Cell> row{markup(escape(name), "name")};
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

/// What the rows of one comparison share.
Cell comparison_cell(const ComparisonResult& c, std::size_t rows) {
    return {fmt::format("<b>{}</b><br>{}<br><span class=\"soft\">reference uncertainty: {}</span>",
                        escape(c.title), escape(c.reference), uncertainty_text(c)),
            "", rows};
}

Cell comparison_verdict(const ComparisonResult& c) {
    Cell cell = verdict(verdict_of(c));
    if (c.available && !c.nrmse) cell = markup("<span class=\"badge warn\">not computed</span>");
    if (!c.note.empty()) cell.html += fmt::format(" {}", escape(c.note));
    return cell;
}

std::string comparisons_of_kind(const Runs& runs, std::optional<ReferenceKind> kind) {
    Table table({"comparison", "dx", "nrmse", "tolerance", "verdict", "peak", "time of peak"});
    std::size_t most = 0;  // a run that died early may have fewer
    for (const RunSummary* run : runs) most = std::max(most, run->comparisons.size());
    for (std::size_t k = 0; k < most; ++k) {
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
    return "<h4>" + escape("Against: " + kind_name(kind)) + "</h4>\n" + table.html();
}

std::string comparisons_of_variant(const Runs& runs) {
    std::set<std::optional<ReferenceKind>> kinds;
    for (const RunSummary* run : runs) {
        for (const ComparisonResult& c : run->comparisons) kinds.insert(c.kind);
    }
    // Measurements first; simulations by others never share a table with them.
    std::string out;
    for (const ReferenceKind kind : {ReferenceKind::experiment, ReferenceKind::analytic,
                                     ReferenceKind::stated, ReferenceKind::peer_simulation}) {
        if (kinds.contains(kind)) out += comparisons_of_kind(runs, kind);
    }
    if (kinds.contains(std::nullopt)) out += comparisons_of_kind(runs, std::nullopt);
    return out.empty() ? paragraph("No comparisons.", "soft") : out;
}

std::string joined(const std::vector<double>& values, int digits) {
    std::string out;
    for (const double value : values) out += (out.empty() ? "" : " → ") + number(value, digits);
    return out;
}

/// What the spacings say of the numerical uncertainty: the index, or the plain range where it has no meaning.
std::string numerical_uncertainty(const ConvergenceRow& row) {
    if (row.gci_fine) return fmt::format("GCI {}", number(*row.gci_fine));
    if (row.value.size() < 2) return "—";
    const auto [low, high] = std::minmax_element(row.value.begin(), row.value.end());
    return fmt::format("range {} to {}", number(*low), number(*high));
}

std::string convergence_verdict(const ConvergenceRow& row) {
    if (!row.asymptotic_ratio) return row.verdict;
    return row.verdict + ", asymptotic ratio " + number(*row.asymptotic_ratio);
}

std::string convergence_of_variant(const Summary& summary, const std::string& scene,
                                   const std::string& variant) {
    Table table({"quantity", "dx [m]", "value", "order", "extrapolated", "uncertainty, finest", "verdict"},
                "compact");
    for (const ConvergenceRow& row : summary.convergence) {
        if (row.scene != scene || row.variant != variant) continue;
        table.add({markup(escape(row.qoi), "name"), markup(joined(row.dx, 4), "number"),
                   markup(joined(row.value, 4), "number"), value(row.order), value(row.extrapolated, "-", 4),
                   markup(numerical_uncertainty(row), "number"), text(convergence_verdict(row))});
    }
    return table.empty() ? "" : table.html();
}

/// A block per variant; the first is open.
template <typename Content>
std::string by_variant(const std::vector<std::string>& variants, Content&& content) {
    if (variants.size() == 1) return content(variants.front());
    std::string out;
    for (const std::string& variant : variants) {
        const std::string html = content(variant);
        if (!html.empty()) out += details("Variant " + variant, html, variant == variants.front());
    }
    return out;
}

}  // namespace

Cell status_cell(const RunRecord& record) {
    const bool ok = record.status == RunStatus::ok;
    return markup(
        fmt::format("<span class=\"badge {}\">{}</span>", ok ? "good" : "bad", to_string(record.status)));
}

std::string uncertainty_text(const ComparisonResult& c) {
    if (c.reference_uncertainty) return fmt::format("{} %", number(100 * *c.reference_uncertainty));
    return c.kind && describe(*c.kind).exact ? "none" : "unknown";
}

std::string kind_name(std::optional<ReferenceKind> kind) {
    return kind ? describe(*kind).heading : "references of unknown kind";
}

std::string deviations_table(const AnalysisSpec& scene) {
    Table table({"item", "in the source", "used here", "reason"});
    for (const Deviation& d : scene.deviations) {
        table.add({text(d.item), text(d.source), text(d.used), markup(escape(d.reason), "wide")});
    }
    return table.html();
}

std::string quantities_table(const Runs& runs) {
    const std::string out = by_variant(variants_of(runs), [&](const std::string& variant) {
        return quantities_of_variant(with_variant(runs, variant));
    });
    return out + paragraph("✓ within, ✗ outside the stated tolerance; no mark: nothing is expected.", "soft");
}

std::string comparison_tables(const Runs& runs) {
    return by_variant(variants_of(runs), [&](const std::string& variant) {
        return comparisons_of_variant(with_variant(runs, variant));
    });
}

std::string convergence_table(const Summary& summary, const AnalysisSpec& scene) {
    const std::string out = by_variant(variants_of(runs_of(summary, scene)), [&](const std::string& variant) {
        return convergence_of_variant(summary, scene.scene, variant);
    });
    if (out.empty()) return paragraph("Too few spacings to judge convergence.", "soft");
    return out + paragraph(
                     "GCI: grid convergence index of the finest spacing, in the unit of the quantity. Where "
                     "the spacings do not converge monotonically there is no index; the range of the values "
                     "stands for it.",
                     "soft");
}

}  // namespace wetdeck::report

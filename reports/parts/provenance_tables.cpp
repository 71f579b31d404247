// SPDX-License-Identifier: BSD-3-Clause
// Provenance of runs and references.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

/// The hash that a run recorded for a reference in its list "NAME HASH, NAME HASH"; empty if it did not use
/// it.
std::string recorded_hash(const RunRecord& record, const std::string& reference) {
    const auto list = record.provenance.find("reference_hashes");
    if (list == record.provenance.end()) return "";
    const std::string entries = ", " + list->second;
    const std::string start = ", " + reference + " ";
    const std::size_t at = entries.find(start);
    if (at == std::string::npos) return "";
    const std::size_t begin = at + start.size();
    return entries.substr(begin, entries.find(',', begin) - begin);
}

/// The hash of the file as it is now, and the number of runs that used another version.
std::string hash_text(const ComparisonResult& c, const Runs& runs) {
    if (c.reference_hash.empty()) return "—";
    const auto others = std::count_if(runs.begin(), runs.end(), [&](const RunSummary* run) {
        const std::string recorded = recorded_hash(run->record, c.reference);
        return !recorded.empty() && recorded != c.reference_hash;
    });
    return others == 0 ? c.reference_hash
                       : fmt::format("{}; {} of the runs used another version", c.reference_hash, others);
}

}  // namespace

std::string references_table(const Runs& runs) {
    std::map<std::string, const ComparisonResult*> references;
    std::map<std::string, std::set<std::string>> series;  // compared with each
    for (const RunSummary* run : runs) {
        for (const ComparisonResult& c : run->comparisons) {
            references.emplace(c.reference, &c);
            series[c.reference].insert(c.quantity);
        }
    }
    Table table({"file", "source", "kind", "standard uncertainty", "compared with", "hash of the file"});
    for (const auto& [name, c] : references) {
        std::string quantities;
        for (const std::string& quantity : series[name])
            quantities += (quantities.empty() ? "" : ", ") + quantity;
        const bool cited = c->available && !c->citation.empty();
        table.add({text(name), markup(escape(cited ? c->citation : fmt::format("— {}", c->note)), "wide"),
                   text(c->kind ? name_of(c->kind) : "—"), text(c->available ? uncertainty_text(*c) : "—"),
                   text(quantities), text(hash_text(*c, runs))});
    }
    return table.empty() ? "" : "<h4>References</h4>\n" + table.html();
}

std::string unused_references_table(const AnalysisSpec& scene) {
    Table table({"file", "why no comparison uses it"});
    for (const UnusedReference& unused : scene.unused_references)
        table.add({text(unused.file), markup(escape(unused.reason), "wide")});
    return table.empty() ? "" : "<h4>Reference files that no comparison uses</h4>\n" + table.html();
}

std::string provenance_table(const Runs& runs) {
    std::map<std::string, std::map<std::string, std::vector<std::string>>> entries;  // key, value, runs
    for (const RunSummary* run : runs) {
        for (const auto& [key, content] : run->record.provenance) {
            entries[key][content].push_back(
                fmt::format("{} {}", run->record.variant, spacing_text(run->record.particle_spacing)));
        }
    }
    Table table({"entry", "value", "runs"});
    for (const auto& [key, values] : entries) {
        for (const auto& [content, names] : values) {
            const bool all = names.size() == runs.size();
            std::string list = all ? "all" : "";
            for (std::size_t i = 0; !all && i < names.size(); ++i) list += (i == 0 ? "" : ", ") + names[i];
            constexpr std::size_t longest = 400;
            const Cell cell =
                content.size() < longest
                    ? text(content)
                    : markup(source_text(fmt::format("{} characters", content.size()), content));
            table.add({markup(escape(key), "name"), cell, text(list)});
        }
    }
    return table.empty() ? paragraph("Nothing recorded.", "soft") : table.html();
}

}  // namespace wetdeck::report

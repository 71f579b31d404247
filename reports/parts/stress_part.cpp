// SPDX-License-Identifier: BSD-3-Clause
// Stability in hard cases, by scheme.
#include <fmt/format.h>

#include <set>

#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"

namespace wetdeck::report {
namespace {

constexpr const char* default_scheme = "default";

/// A setting run with another scheme than the default one is named "SETTING, SCHEME".
struct SplitSetting {
    std::string setting, scheme;
};

SplitSetting split(const std::string& setting) {
    const std::size_t comma = setting.rfind(", ");
    if (comma == std::string::npos) return {setting, ""};
    return {setting.substr(0, comma), setting.substr(comma + 2)};
}

/// Names of the schemes other than the default one: what follows the last comma of a setting where the
/// setting without it is a row of the same case. A comma of the setting's own does not name a scheme.
std::set<std::string> other_schemes(const std::vector<StressRow>& rows) {
    std::set<std::pair<std::string, std::string>> settings;
    for (const StressRow& row : rows) settings.emplace(row.stress_case, row.setting);
    std::set<std::string> schemes;
    for (const StressRow& row : rows) {
        const SplitSetting parts = split(row.setting);
        if (!parts.scheme.empty() && settings.count({row.stress_case, parts.setting}) != 0)
            schemes.insert(parts.scheme);
    }
    return schemes;
}

/// The rows of the hard cases with the scheme of each.
class SchemeRows {
  public:
    explicit SchemeRows(const std::vector<StressRow>& rows) : rows_(rows), others_(other_schemes(rows)) {}

    const std::vector<StressRow>& rows() const { return rows_; }
    const std::set<std::string>& others() const { return others_; }
    std::string scheme_of(const StressRow& row) const {
        const std::string last = split(row.setting).scheme;
        return others_.count(last) != 0 ? last : default_scheme;
    }
    bool by_default(const StressRow& row) const { return scheme_of(row) == default_scheme; }

  private:
    const std::vector<StressRow>& rows_;
    std::set<std::string> others_;
};

bool is_search(const StressRow& row) {
    return row.setting.starts_with("limit of ");
}

std::string instability_picture(const StressRow& row, const ReportInputs& inputs) {
    const auto found = inputs.instabilities.find(row.picture);
    if (found == inputs.instabilities.end()) return "";
    return fmt::format("<br><img src=\"{}\" alt=\"{}, {}\" loading=\"lazy\">",
                       data_address("image/png", found->second), escape(row.stress_case),
                       escape(row.setting));
}

std::string counts_table(const SchemeRows& all) {
    std::vector<std::string> schemes{default_scheme};
    schemes.insert(schemes.end(), all.others().begin(), all.others().end());
    Table table({"scheme", "settings", "stable"});
    for (const std::string& scheme : schemes) {
        std::size_t settings = 0, stable = 0;
        for (const StressRow& row : all.rows()) {
            if (is_search(row) || all.scheme_of(row) != scheme) continue;
            ++settings;
            if (row.survived) ++stable;
        }
        if (settings > 0)
            table.add(
                {text(scheme), whole(static_cast<double>(settings)), whole(static_cast<double>(stable))});
    }
    return table.html();
}

/// The rows that `wanted` takes.
template <class Wanted>
std::string stress_table(const SchemeRows& all, const ReportInputs& inputs, const Wanted& wanted) {
    Table table({"case", "setting", "outcome", "note"});
    for (const StressRow& row : all.rows()) {
        if (!wanted(row)) continue;
        table.add({text(row.stress_case), text(row.setting),
                   markup(row.survived ? "<span class=\"badge good\">stable</span>"
                                       : "<span class=\"badge bad\">became unstable</span>"),
                   markup(escape(row.note) + instability_picture(row, inputs), "wide")});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace

void add_stress_part(Page& page, const Summary& summary, const ReportInputs& inputs) {
    if (summary.stress.empty()) return;
    const SchemeRows all(summary.stress);
    page.add(counts_table(all));
    const std::string unstable =
        stress_table(all, inputs, [&](const StressRow& row) { return all.by_default(row) && !row.survived; });
    page.add(unstable.empty() ? paragraph("The default scheme was stable in every setting.")
                              : "<h4>Settings in which the default scheme became unstable</h4>\n" + unstable);
    const std::string limits = stress_table(all, inputs, is_search);
    if (!limits.empty())
        page.add("<h4>Margins between the values in use and the stability limits</h4>\n" + limits);
    page.add(details("Settings in which the default scheme was stable",
                     stress_table(all, inputs, [&](const StressRow& row) {
                         return all.by_default(row) && row.survived && !is_search(row);
                     })));
    page.add(details("Other schemes",
                     stress_table(all, inputs, [&](const StressRow& row) { return !all.by_default(row); })));
}

}  // namespace wetdeck::report

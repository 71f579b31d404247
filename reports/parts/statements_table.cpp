// SPDX-License-Identifier: BSD-3-Clause
// What the source of a scene says, against the runs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/parts/tables.hpp"

namespace wetdeck::report {
namespace {

std::string interval(const StatementResult& s) {
    if (!std::isfinite(s.high)) return "at least " + number_with_unit(s.low, s.unit);
    if (!std::isfinite(s.low)) return "at most " + number_with_unit(s.high, s.unit);
    return number(s.low) + " to " + number_with_unit(s.high, s.unit);
}

Cell judgement(const StatementResult& s) {
    if (!s.holds()) return text(s.note.empty() ? "not judged" : "not judged: " + s.note);
    return *s.holds() ? markup("<span class=\"badge good\">holds</span>")
                      : markup("<span class=\"badge bad\">does not hold</span>");
}

}  // namespace

std::string statements_table(const Summary& summary, const AnalysisSpec& scene) {
    Table table({"statement", "variant", "against", "measure", "dx", "value", "holds for", "judgement"});
    for (const StatementResult& s : summary.statements) {
        if (s.scene != scene.scene) continue;
        table.add({markup(escape(s.says), "wide"), markup(escape(s.variant), "name"), text(s.against),
                   text(s.measure), s.dx > 0 ? value(s.dx, "m", 4) : text("—"), value(s.value, s.unit),
                   text(interval(s)), judgement(s)});
    }
    return table.empty() ? "" : table.html();
}

}  // namespace wetdeck::report

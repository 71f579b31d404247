// SPDX-License-Identifier: BSD-3-Clause
// What the source of a scene says, against the runs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/words.hpp"
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

/// The words of a quantity in a text that begins with its name; other texts as they are.
std::string in_words(const AnalysisSpec& scene, const std::string& text) {
    const std::string name = text.substr(0, text.find(", "));
    const auto same = [&name](const QuantitySpec& spec) { return spec.name == name; };
    if (std::none_of(scene.quantities.begin(), scene.quantities.end(), same)) return escape(text);
    return named_words(quantity_words(scene, name), name) + escape(text.substr(name.size()));
}

std::vector<const StatementResult*> of_scene(const Summary& summary, const AnalysisSpec& scene) {
    std::vector<const StatementResult*> all;
    for (const StatementResult& s : summary.statements)
        if (s.scene == scene.scene) all.push_back(&s);
    return all;
}

}  // namespace

std::string statements_table(const Summary& summary, const AnalysisSpec& scene) {
    Table table({"statement", "variant", "against", "measure", "dx", "value", "holds for", "judgement"},
                "compact");
    const std::vector<const StatementResult*> all = of_scene(summary, scene);
    for (std::size_t n = 0, next = 0; n < all.size(); n = next) {
        while (next < all.size() && all[next]->says == all[n]->says) ++next;
        for (std::size_t k = n; k < next; ++k) {
            const StatementResult& s = *all[k];
            std::vector<Cell> cells;
            if (k == n) cells.push_back(markup(escape(s.says), "wide", next - n));
            cells.insert(cells.end(),
                         {markup(escape(s.variant), "name"), markup(in_words(scene, s.against)),
                          markup(in_words(scene, s.measure)), s.dx > 0 ? value(s.dx, "m", 4) : text("—"),
                          value(s.value, s.unit), text(interval(s)), judgement(s)});
            table.add(cells);
        }
    }
    return table.empty() ? "" : table.html();
}

}  // namespace wetdeck::report

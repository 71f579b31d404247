// SPDX-License-Identifier: BSD-3-Clause
// Statements of a scene's source, and variants that the report shows beside each other.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "validation/metrics/statements.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

std::vector<std::string> variants(const TomlTable& table, const std::string& key, const Scene& scene) {
    const std::vector<std::string> named = table.texts(key);
    if (named.empty()) table.fail(key, "expected at least one variant");
    for (const std::string& name : named) {
        const auto same = [&](const VariantInfo& variant) { return variant.name == name; };
        if (std::none_of(scene.variants.begin(), scene.variants.end(), same))
            table.fail(key, fmt::format("'{}' is not a variant of this scene", name));
    }
    return named;
}

Window interval(const TomlTable& table, const std::string& key) {
    const std::vector<double> ends = table.numbers(key, 2);
    if (!(ends[0] < ends[1])) table.fail(key, "expected a low end below the high one");
    return {ends[0], ends[1]};
}

SourceStatement read_statement(const TomlTable& table, const std::vector<std::string>& series,
                               const std::vector<std::string>& quantities, const Scene& scene) {
    SourceStatement s;
    s.says = table.text("says");
    s.variants = variants(table, "variants", scene);
    if (table.has("against")) s.against = variants(table, "against", scene);
    if (!s.against.empty() && s.against.size() != s.variants.size())
        table.fail("against", "expected one variant for each of 'variants'");
    const std::vector<std::string>& measures = statement_measure_names();
    const std::string measure = table.choice("measure", measures);
    s.measure = static_cast<SourceStatement::Measure>(std::find(measures.begin(), measures.end(), measure) -
                                                      measures.begin());
    const bool curves = s.measure == SourceStatement::Measure::curve_difference;
    s.quantity = table.choice(curves ? "series" : "quantity", curves ? series : quantities);
    s.against_quantity = curves ? s.quantity : table.choice("against_quantity", quantities, s.quantity);
    if (s.against.empty() && s.against_quantity == s.quantity)
        table.fail_missing("against", "expected the variants to compare with, or 'against_quantity'");
    if (curves && table.has("window")) s.window = interval(table, "window");
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    s.low = table.number_or("at_least", -unlimited);
    s.high = table.number_or("at_most", unlimited);
    if (!(s.low < s.high)) table.fail("at_most", "expected a number above 'at_least'");
    if (!table.has("at_least") && !table.has("at_most"))
        table.fail_missing("at_least",
                           "expected the limits within which the statement holds, 'at_least' or "
                           "'at_most' or both");
    table.finish();
    return s;
}

SideBySide read_side_by_side(const TomlTable& table, const std::vector<std::string>& series,
                             const Scene& scene) {
    SideBySide s;
    s.title = table.text("title");
    s.variants = variants(table, "variants", scene);
    if (s.variants.size() < 2) table.fail("variants", "expected at least two variants");
    s.time = table.optional_number("time");
    if (table.has("series")) s.series = table.choice("series", series);
    if (!s.time && s.series.empty()) table.fail_missing("time", "expected a time [s], or 'series'");
    table.finish();
    return s;
}

}  // namespace

void read_statements(const TomlTable& root, const std::vector<std::string>& series,
                     const std::vector<std::string>& quantities, Scene& scene) {
    for (const TomlTable& table : root.tables("source_statements"))
        scene.analysis.statements.push_back(read_statement(table, series, quantities, scene));
    for (const TomlTable& table : root.tables("side_by_side"))
        scene.analysis.side_by_side.push_back(read_side_by_side(table, series, scene));
}

}  // namespace wetdeck

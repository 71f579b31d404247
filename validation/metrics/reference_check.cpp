// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/reference_check.hpp"

#include <fmt/format.h>

#include <map>

#include "solver/core/errors.hpp"
#include "validation/metrics/dimensions.hpp"

namespace wetdeck {
namespace {

/// Plain scales by name, with the unit in which each is taken.
using ScaleUses = std::map<std::string, Unit>;

void add_use(ScaleUses& uses, const AxisUnits& axis, const Column& column, const std::string& place) {
    const std::optional<Unit> unit = dimension_of_scale(axis, column);
    if (!unit) return;
    const auto [use, is_new] = uses.emplace(axis.scale, *unit);
    if (is_new || same_dimension(use->second, *unit)) return;
    throw InputError(
        fmt::format("{}: scale '{}' is taken in {} here and in {} before, expected one dimension", place,
                    axis.scale, unit->text, use->second.text));
}

/// One series and the columns that it is compared with.
struct Pair {
    const std::string& series;
    const SeriesUnits& units;
    const Reference& reference;
    std::string x_column, y_column;
};

void check_pair(const Pair& pair, ScaleUses& uses) {
    static_cast<void>(column_curve(pair.reference, pair.x_column, pair.y_column));
    const Column& x = find_column(pair.reference, pair.x_column);
    const Column& y = find_column(pair.reference, pair.y_column);
    check_dimensions(pair.series, pair.units, x, y);
    add_use(uses, pair.units.x, x, pair.units.place);
    add_use(uses, pair.units.y, y, pair.units.place);
}

}  // namespace

std::set<std::string> check_references(const AnalysisSpec& scene, ReferenceShelf& references) {
    std::set<std::string> missing;
    ScaleUses uses;
    for (const ComparisonSpec& c : scene.comparisons) {
        if (const Reference* found = references.find(c.reference))
            check_pair({c.quantity, c.units, *found, c.x_column, c.y_column}, uses);
        else
            missing.insert(c.reference);
    }
    for (const QuantitySpec& q : scene.quantities) {
        if (q.reference.empty()) continue;
        if (const Reference* found = references.find(q.reference))
            check_pair({q.series, q.units, *found, found->columns.front().name, q.y_column}, uses);
        else
            missing.insert(q.reference);
    }
    return missing;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/reference_check.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

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
    const SeriesScaling& scaling;
    std::optional<Window> window;  ///< on the scaled abscissa
};

void check_extent(const Pair& pair) {
    const Curve curve = scaled_reference(pair.reference, pair.x_column, pair.y_column, pair.scaling.x_scale,
                                         pair.scaling.y_scale);
    const std::string& file = pair.reference.path.string();
    if (curve.x.size() < 2)
        throw InputError(fmt::format("{}: curve {} of {} has one point, expected at least two",
                                     pair.units.place, pair.y_column, file));
    if (pair.window && (pair.window->end <= curve.x.front() || pair.window->begin >= curve.x.back()))
        throw InputError(
            fmt::format("{}: window {:.6g} to {:.6g} lies outside curve {} of {}, which spans {:.6g} "
                        "to {:.6g} over the same axis",
                        pair.units.place, pair.window->begin, pair.window->end, pair.y_column, file,
                        curve.x.front(), curve.x.back()));
}

void check_pair(const Pair& pair, ScaleUses& uses) {
    const Column& x = find_column(pair.reference, pair.x_column);
    const Column& y = find_column(pair.reference, pair.y_column);
    check_dimensions(pair.series, pair.units, x, y);
    add_use(uses, pair.units.x, x, pair.units.place);
    add_use(uses, pair.units.y, y, pair.units.place);
    check_extent(pair);
}

}  // namespace

std::set<std::string> check_references(const AnalysisSpec& scene, ReferenceShelf& references) {
    std::set<std::string> missing;
    ScaleUses uses;
    for (const ComparisonSpec& c : scene.comparisons) {
        if (const Reference* found = references.find(c.reference))
            check_pair({c.quantity, c.units, *found, c.x_column, c.y_column, c,
                        c.align_peaks ? std::nullopt : c.window},
                       uses);
        else
            missing.insert(c.reference);
    }
    for (const QuantitySpec& q : scene.quantities) {
        if (q.reference.empty()) continue;
        if (const Reference* found = references.find(q.reference))
            check_pair({q.series, q.units, *found, found->columns.front().name, q.y_column, q, q.window},
                       uses);
        else
            missing.insert(q.reference);
    }
    return missing;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/dimensions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

bool is_plain(const AxisUnits& axis) {
    return !axis.scale.empty() && axis.scale_unit.empty();
}

bool has_unit(const Unit& unit) {
    return unit.powers != Powers{};
}

/// One axis of a comparison.
struct Axis {
    std::string series;  ///< as messages name it
    const AxisUnits& units;
    const Column& column;
    const char* scale_key;
};

void check_axis(const Axis& axis) {
    if (axis.units.series.empty()) return;
    const Unit series = unit_named(axis.units.series), column = unit_named(axis.column.unit);
    if (has_unit(column)) {
        if (same_dimension(series, column)) return;
        throw InputError(fmt::format("{} is in {}, column '{}' in {}, expected the same dimension",
                                     axis.series, axis.units.series, axis.column.name,
                                     axis.column.given_unit));
    }
    if (axis.units.scale.empty()) {
        if (!has_unit(series)) return;
        throw InputError(fmt::format(
            "{} is in {}, column '{}' in - (scaled already), expected a '{}' in {} or a column in {}",
            axis.series, axis.units.series, axis.column.name, axis.scale_key, axis.units.series,
            axis.units.series));
    }
    if (is_plain(axis.units) || same_dimension(series, unit_named(axis.units.scale_unit))) return;
    throw InputError(fmt::format(
        "{} is in {}, scale '{}' in {}, expected the same dimension, as column '{}' is in -", axis.series,
        axis.units.series, axis.units.scale, axis.units.scale_unit, axis.column.name));
}

/// series^y abscissa^x, as the metric makes its number.
struct Exponents {
    int x = 0, y = 0;
};

Exponents exponents_of(Dimension dimension) {
    switch (dimension) {
        case Dimension::abscissa:
            return {1, 0};
        case Dimension::series_per_abscissa:
            return {-1, 1};
        case Dimension::series_times_abscissa:
            return {1, 1};
        case Dimension::series:
            break;
    }
    return {0, 1};
}

Unit power_product(const Unit& x, const Unit& y, Exponents e) {
    const Unit number{};
    Unit product = e.y == 1 ? y : number;
    if (e.x == 1) product = e.y == 1 ? product * x : x;
    if (e.x == -1) product = product / x;
    return product;
}

Unit scale_unit(const AxisUnits& axis) {
    Unit unit = axis.scale_unit.empty() ? Unit{} : unit_named(axis.scale_unit);
    unit.factor = 1;
    return unit;
}

/// Whether the number, which is `scale` SI units of the dimension of `unit`, is what the unit says.
bool same_size(const Unit& unit, double scale) {
    return std::abs(unit.factor / scale - 1) < 1e-6;
}

}  // namespace

void check_dimensions(const std::string& series, const SeriesUnits& units, const Column& x, const Column& y) {
    try {
        check_axis({fmt::format("the abscissa of series '{}'", series), units.x, x, "x_scale"});
        check_axis({fmt::format("series '{}'", series), units.y, y, "y_scale"});
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", units.place, error.what()));
    }
}

std::optional<Unit> dimension_of_scale(const AxisUnits& axis, const Column& column) {
    if (axis.series.empty() || !is_plain(axis) || has_unit(unit_named(column.unit))) return std::nullopt;
    return unit_named(axis.series);
}

std::string quantity_unit(const QuantitySpec& spec, const std::optional<std::string>& stated) {
    const AxisUnits &x = spec.units.x, &y = spec.units.y;
    if (x.series.empty() || y.series.empty()) return stated.value_or("-");
    const Exponents e = exponents_of(spec.metric->dimension);
    const Unit natural = power_product(unit_named(x.series), unit_named(y.series), e);
    const Unit scaled = natural / power_product(scale_unit(x), scale_unit(y), e);
    const bool open = (e.x != 0 && is_plain(x)) || (e.y != 0 && is_plain(y));
    const bool is_scaled = (e.x != 0 && !x.scale.empty()) || (e.y != 0 && !y.scale.empty());
    if (!stated) return open ? "-" : is_scaled ? scaled.text : natural.text;
    const Unit unit = unit_named(*stated);
    const double size = std::pow(spec.x_scale, e.x) * std::pow(spec.y_scale, e.y);
    const bool as_series = same_dimension(unit, natural) && same_size(unit, size);
    const bool as_scaled = !open && same_dimension(unit, scaled) && same_size(unit, 1);
    const bool by_plain_scale = open && (!same_dimension(unit, natural) || !has_unit(natural));
    if (as_series || as_scaled || by_plain_scale) return *stated;
    const std::string given = is_scaled ? fmt::format("units of {:g} {}", size, natural.text) : natural.text;
    throw InputError(fmt::format("is '{}', but the metric {} of series '{}' gives {}", *stated,
                                 spec.metric->name, spec.series, given));
}

}  // namespace wetdeck

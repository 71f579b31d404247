// SPDX-License-Identifier: BSD-3-Clause
// Dimensions of what is compared: a series over its abscissa with the columns of a reference, and the unit of
// a quantity with what its metric makes of the series. A plain number as scale takes the dimension that its
// use asks for; a scale with a unit is checked.
#pragma once

#include <optional>
#include <string>

#include "validation/metrics/reference.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/metrics/units.hpp"

namespace wetdeck {

/// Throws InputError that names both units unless the columns can be compared with the series:
///   column with a unit:  it and the series have the same dimension (both are divided by the scale);
///   column without one:  it is scaled already, so the series needs a scale of its dimension, or has none.
/// Axes of unknown units pass.
void check_dimensions(const std::string& series, const SeriesUnits& units, const Column& x, const Column& y);

/// The unit of the number that a metric takes from a series: the stated one, if it agrees, else the one that
/// follows from series and scales, "-" where a plain scale leaves it open. Throws InputError for a stated
/// unit of another dimension or size.
std::string quantity_unit(const QuantitySpec& spec, const std::optional<std::string>& stated);

/// The dimension that a plain scale must have: that of the series where the column has no unit.
std::optional<Unit> dimension_of_scale(const AxisUnits& axis, const Column& column);

}  // namespace wetdeck

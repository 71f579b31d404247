// SPDX-License-Identifier: BSD-3-Clause
// Errors of a run in the conservation of energy and momentum.
#pragma once

#include <optional>

#include "validation/store/run_record.hpp"

namespace wetdeck {

/// Largest rise of the total energy above its lowest value so far: with E = energy_kinetic + energy_potential
/// + energy_compression,
///     max over t of ( E(t) - min over s <= t of E(s) ) / max( max E_potential - min E_potential,
///     |E_potential(0)| ).
/// Without a driven body energy can only be lost, so any rise is an error; loss is physical (impact,
/// viscosity) and not counted. Empty if one of the series is missing, they are not sampled at the same
/// instants, a value is not finite or the scale is zero.
std::optional<double> energy_error(const RunRecord& record);

/// Largest absolute value of the series `momentum_error`; empty if the run has none or a value is not finite.
std::optional<double> momentum_error(const RunRecord& record);

}  // namespace wetdeck

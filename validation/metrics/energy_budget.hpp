// SPDX-License-Identifier: BSD-3-Clause
// Energies and other sums over the fluid, as changes since the start of a run.
#pragma once

#include <optional>
#include <string>

#include "solver/core/curve.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// (E(t) - E(0)) / |E_potential(0)| of each energy and of their sum, over time [s].
struct EnergyChanges {
    Curve kinetic, potential, compression, total;
};

/// Empty if one of the three energies is missing, they are not sampled at the same instants, or the potential
/// energy starts from zero.
std::optional<EnergyChanges> energy_changes(const RunRecord& record);

/// Largest |y(t) / y(0) - 1| of a scalar series; empty without the series or if it starts from zero.
std::optional<double> relative_drift(const RunRecord& record, const std::string& series);

/// Largest value of a scalar series; empty without it.
std::optional<double> largest_value(const RunRecord& record, const std::string& series);

}  // namespace wetdeck

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

/// The series that add_energy_loss() makes.
inline constexpr const char* energy_loss_name = "energy_loss";
inline constexpr const char* energy_loss_description =
    "energy that all fluid has lost since the start, over its potential energy then; work of bodies not "
    "taken out; made of the energies by the analysis, not stored";

/// Adds the series energy_loss [-], (E(0) - E(t)) / |E_potential(0)| with E the sum of the three energies, to
/// a record that lacks it. Without energy_changes() nothing is added.
void add_energy_loss(RunRecord& record);

/// Largest |y(t) / y(0) - 1| of a scalar series; empty without the series or if it starts from zero.
std::optional<double> relative_drift(const RunRecord& record, const std::string& series);

/// Largest value of a scalar series; empty without it.
std::optional<double> largest_value(const RunRecord& record, const std::string& series);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Which models have pairs in mixed precision. A harmonic mean divides by a sum that may vanish, which single
// precision cannot tell from rounding; the dissipation switch belongs to the same scheme.
#pragma once

#include <string>

#include "solver/core/execution.hpp"
#include "solver/physics/model.hpp"

namespace wetdeck {

/// The choice of a model that mixed precision does not have, as a scene writes it; empty where there is none.
inline std::string without_mixed_pairs(const Model& model) {
    if (model.velocity_mean == Mean::harmonic) return "velocity_mean = \"harmonic\"";
    if (model.pressure_mean == Mean::harmonic) return "pressure_mean = \"harmonic\"";
    if (model.impedance_mean == ImpedanceMean::harmonic) return "impedance_mean = \"harmonic\"";
    return model.dissipation_switch ? "dissipation_switch = true" : "";
}

/// Mixed where the model has such pairs.
inline Precision default_precision(const Model& model) {
    return without_mixed_pairs(model).empty() ? Precision::mixed : Precision::double_precision;
}

}  // namespace wetdeck

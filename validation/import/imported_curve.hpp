// SPDX-License-Identifier: BSD-3-Clause
// From the record of another code to a reference curve (reference_data/README.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/import/code_record.hpp"

namespace wetdeck {

/// What the files do not say, or what the user wants of them.
struct ImportChoices {
    std::vector<std::string> columns;          ///< which; may be empty where there is one
    std::optional<double> layer;               ///< thickness of the computed layer [m]
    std::optional<double> factor;              ///< 2: half of a symmetric body was computed
    std::optional<std::string> datum;          ///< of pressures: gauge, absolute
    std::optional<double> reference_pressure;  ///< taken off absolute pressures [Pa]
    std::optional<std::string> pressure;       ///< p, p_rgh
    std::optional<std::string> phase;          ///< water, two-phase
    std::optional<std::string> sign;           ///< which direction is positive
    std::optional<std::string> code, code_version;
    std::optional<std::string> setup;        ///< what was computed, in a sentence
    std::optional<std::string> scene;        ///< or the scene of this program that it stands for
    std::optional<std::string> unit;         ///< of the chosen columns
    std::optional<std::string> time_unit;    ///< of the time
    std::optional<std::string> time_origin;  ///< what happens at time 0
};

/// The text of a reference curve in SI units. Loads of columns in N and N m are divided by the layer,
/// absolute pressures become gauge pressures. Throws InputError, in one line, with the options that are
/// missing and what each is to say; for a column that is not there, the line lists those that are.
/// @param date  of today, YYYY-MM-DD
std::string imported_curve(const CodeRecord& record, const ImportChoices& choices, const std::string& date);

}  // namespace wetdeck

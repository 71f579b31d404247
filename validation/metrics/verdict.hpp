// SPDX-License-Identifier: BSD-3-Clause
// What a comparison with its uncertainties allows to conclude, after ASME V&V 20. The error of the model lies
// within E +- 1.96 u_val with a confidence of 95 %:
//     validated               all of it within the accuracy that the user requires
//     too high, too low       none of it on the other side of zero
//     within the uncertainty  zero is possible
//     refine first            zero is possible, but mostly for the spacing's part of the uncertainty
//     unknown                 a part of the uncertainty is not known
// Beside an exact solution or another code, where nothing is validated, the words are
//     agrees, higher, lower, refine first, unknown.
#pragma once

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Half the width of a 95 % interval over the standard uncertainty, of a normal distribution.
inline constexpr double confidence = 1.96;

/// Whether the error is larger than the known parts of its uncertainty allow for, and none is unknown.
bool error_is_shown(const ValidationRow& row);

/// Sets verdict, sentence and largest part of a row whose error, uncertainties and interval are filled in.
void conclude(ValidationRow& row);

}  // namespace wetdeck

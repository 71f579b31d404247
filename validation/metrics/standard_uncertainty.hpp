// SPDX-License-Identifier: BSD-3-Clause
// The uncertainty of a reference, as its file states it.
#pragma once

#include <cmath>
#include <string>

namespace wetdeck {

/// Standard (k = 1), of a value in SI units or scaled.
struct StandardUncertainty {
    double value = 0;
    std::string unit = {};  ///< of `value`; empty: relative to what is measured

    bool relative() const { return unit.empty(); }
    /// In the unit of the measured value.
    double of(double measured) const { return relative() ? value * std::abs(measured) : value; }
};

inline bool operator==(const StandardUncertainty& a, const StandardUncertainty& b) {
    return a.value == b.value && a.unit == b.unit;
}

/// "0.03" and "3 %" are relative, "0.03 m/s" is not. Throws InputError, "is ..., expected ...".
StandardUncertainty uncertainty_in(const std::string& text);

}  // namespace wetdeck

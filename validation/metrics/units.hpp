// SPDX-License-Identifier: BSD-3-Clause
// Units of measurement and their dimensions, by the library udunits2, within the mechanics of this program:
// every unit is a product of powers of metre, kilogram, second and radian. Angles count as a dimension, so
// that rad/s and Hz, which differ by 2 pi, are not taken for each other.
#pragma once

#include <array>
#include <string>

namespace wetdeck {

/// Powers of metre, kilogram, second and radian.
using Powers = std::array<int, 4>;

struct Unit {
    std::string text = "-";  ///< as written
    double factor = 1;       ///< SI units in one of this unit
    Powers powers{};         ///< all zero for "-", a number without a unit
};

/// The unit that the text names: "-", "kPa", "km/h", "m s-2", "N·s/m". Departures from udunits2, which would
/// read other things: `g` alone is standard gravity, 9.80665 m/s^2 (in a product, as in "g/cm^3", the gram),
/// and so is `g0`; `deg` is the degree of angle.
/// Throws InputError "unknown unit ..." for a text that names none, and for a unit with an offset (degrees
/// Celsius), a number in front, a logarithm, or of electricity, temperature or light.
Unit unit_named(const std::string& text);

/// Metre, kilogram, second and radian as a text: "Pa" for m^-1 kg s^-2, "m^2 s^-3" where the SI has no name.
std::string si_name(const Powers& powers);

bool same_dimension(const Unit& a, const Unit& b);

/// Whether the text names a unit of length.
bool is_length(const std::string& text);

/// Units of products and quotients, written by their SI names.
Unit operator*(const Unit& a, const Unit& b);
Unit operator/(const Unit& a, const Unit& b);

}  // namespace wetdeck

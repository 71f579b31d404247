// SPDX-License-Identifier: BSD-3-Clause
// The few operations that physics functions need besides arithmetic, for plain numbers. The pair loop's packs
// of eight bring their own overloads, found by argument-dependent lookup: one formula serves a hand-written
// test and the fast loop.
#pragma once

namespace wetdeck {

inline double maximum(double a, double b) {
    return a > b ? a : b;
}
inline double minimum(double a, double b) {
    return a < b ? a : b;
}
inline double positive_part(double a) {
    return maximum(a, 0);
}
/// Whether a < b, for a pack in any lane.
inline bool any_less(double a, double b) {
    return a < b;
}
inline double select(bool condition, double a, double b) {
    return condition ? a : b;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Quadrature, roots and ordinary differential equations by GSL, for exact solutions.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "solver/core/curve.hpp"

namespace wetdeck::verification {

using Function = std::function<double(double)>;

/// Integral of f over [from, to], adaptive, to 1e-11 relative.
double integral(const Function& f, double from, double to);

/// Root of f between two places where its signs differ, to rounding. Throws std::logic_error if they do not.
double root(const Function& f, double low, double high);

/// y'(t) = rates(t, y), y(0) = start: the states at the given times (ascending), to 1e-10 relative.
std::vector<std::vector<double>> ode(
    const std::function<std::vector<double>(double, const std::vector<double>&)>& rates,
    std::vector<double> start, const std::vector<double>& times);

/// The points (x, y) in the order of x, as a curve.
Curve sorted_curve(std::vector<std::pair<double, double>> points);

/// n equidistant values from low to high.
std::vector<double> linspace(double low, double high, std::size_t n);

}  // namespace wetdeck::verification

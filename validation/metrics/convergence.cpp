// SPDX-License-Identifier: BSD-3-Clause
// Solution verification: observed order, Richardson value and grid convergence index of a quantity.
#include "validation/metrics/convergence.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "validation/metrics/least_squares_fit.hpp"

namespace wetdeck {
namespace {

constexpr double safety_factor = 1.25;
constexpr double largest_order = 30;

struct OrderProblem {
    double log_r21, log_r32, log_ratio;
};

/// log of the right side minus log of the left side; the quotient at p = 0 is the limit.
double order_residual(double p, void* parameters) {
    const auto& problem = *static_cast<const OrderProblem*>(parameters);
    const double quotient = std::abs(p) < 1e-12
                                ? problem.log_r32 / problem.log_r21
                                : std::expm1(p * problem.log_r32) / std::expm1(p * problem.log_r21);
    return p * problem.log_r21 + std::log(quotient) - problem.log_ratio;
}

/// |f_coarse - f_fine| / (r^p - 1), the estimated error of the finer of two values.
double fine_error(double h_coarse, double h_fine, double f_coarse, double f_fine, double p) {
    return std::abs(f_coarse - f_fine) / std::expm1(p * std::log(h_coarse / h_fine));
}

std::string verdict_of(const ConvergenceRow& row, double difference_coarse, double difference_fine,
                       double formal_order) {
    if (difference_coarse == 0 || difference_fine == 0) return "not asymptotic";
    if (!row.monotone) return "oscillatory";
    if (!row.order) return "not asymptotic";
    if (*row.order <= 0) return "divergent";
    if (*row.order < 0.5 || *row.order > 2 * formal_order) return "not asymptotic";
    if (row.asymptotic_ratio && (*row.asymptotic_ratio < 0.5 || *row.asymptotic_ratio > 2))
        return "not asymptotic";
    return "monotonic";
}

}  // namespace

std::optional<double> observed_order(double h3, double h2, double h1, double f3, double f2, double f1) {
    const double ratio = (f3 - f2) / (f2 - f1);
    if (!(ratio > 0) || !std::isfinite(ratio)) return std::nullopt;
    OrderProblem problem{std::log(h2 / h1), std::log(h3 / h2), std::log(ratio)};
    if (order_residual(-largest_order, &problem) > 0 || order_residual(largest_order, &problem) < 0)
        return std::nullopt;
    gsl_function function{order_residual, &problem};
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    gsl_root_fsolver_set(solver.get(), &function, -largest_order, largest_order);
    constexpr int most_iterations = 200;  // Brent on a bracket of 60 needs far fewer
    for (int i = 0; i < most_iterations; ++i) {
        gsl_root_fsolver_iterate(solver.get());
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                                   gsl_root_fsolver_x_upper(solver.get()), 1e-12, 0) == GSL_SUCCESS) {
            break;
        }
    }
    return gsl_root_fsolver_root(solver.get());
}

ConvergenceRow convergence(std::vector<std::pair<double, double>> points, double formal_order) {
    std::sort(points.begin(), points.end(), std::greater<>());
    ConvergenceRow row;
    for (const auto& [spacing, value] : points) {
        row.dx.push_back(spacing);
        row.value.push_back(value);
    }
    const std::size_t n = points.size();
    row.verdict = "too few spacings";
    if (n < 3) return row;

    if (const auto fit = fit_least_squares(points)) row.least_squares = fit->uncertainty;
    const auto [h3, f3] = points[n - 3];
    const auto [h2, f2] = points[n - 2];
    const auto [h1, f1] = points[n - 1];
    row.monotone = (f3 - f2) * (f2 - f1) > 0;
    if (row.monotone) row.order = observed_order(h3, h2, h1, f3, f2, f1);
    if (n > 3 && row.order && *row.order > 0) {
        const auto [h4, f4] = points[n - 4];
        const double p = *row.order;
        row.asymptotic_ratio =
            fine_error(h4, h3, f4, f3, p) / (std::pow(h3 / h2, p) * fine_error(h3, h2, f3, f2, p));
    }
    row.verdict = verdict_of(row, f3 - f2, f2 - f1, formal_order);
    if (row.verdict == "monotonic") {
        const double error = fine_error(h2, h1, f2, f1, *row.order);
        row.extrapolated = f1 + std::copysign(error, f1 - f2);
        row.gci_fine = safety_factor * error;
    }
    return row;
}

std::optional<double> numerical_uncertainty(const ConvergenceRow& row) {
    if (row.least_squares) return 0.5 * *row.least_squares;
    if (row.gci_fine) return 0.5 * *row.gci_fine;
    if (row.value.size() < 3) return std::nullopt;
    const auto [low, high] = std::minmax_element(row.value.end() - 3, row.value.end());
    return *high - *low;
}

}  // namespace wetdeck

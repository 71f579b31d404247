// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/least_squares_fit.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace wetdeck {
namespace {

using Points = std::vector<std::pair<double, double>>;  // spacings over the finest one, and values

struct Expansion {
    Eigen::VectorXd coefficients;  ///< f0 and those of the powers
    double limit = 0, at_finest = 0;
    double deviation = 0;
};

/// @param unknowns  of the fit, for the degrees of freedom
Expansion fit_powers(const Points& points, const std::vector<double>& powers, std::size_t unknowns) {
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd terms(n, static_cast<Eigen::Index>(powers.size()) + 1);
    Eigen::VectorXd values(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& [spacing, value] = points[static_cast<std::size_t>(i)];
        values[i] = value;
        terms(i, 0) = 1;
        for (std::size_t k = 0; k < powers.size(); ++k)
            terms(i, static_cast<Eigen::Index>(k) + 1) = std::pow(spacing, powers[k]);
    }
    Expansion fit;
    fit.coefficients = terms.colPivHouseholderQr().solve(values);
    const Eigen::VectorXd fitted = terms * fit.coefficients;
    fit.limit = fit.coefficients[0];
    fit.at_finest = fitted[n - 1];
    fit.deviation =
        std::sqrt((values - fitted).squaredNorm() / static_cast<double>(points.size() - unknowns));
    return fit;
}

constexpr std::size_t unknowns_with_order = 3;
constexpr double lowest_order = 0.05, highest_order = 8;

double deviation_at(double order, void* points) {
    return fit_powers(*static_cast<Points*>(points), {order}, unknowns_with_order).deviation;
}

/// The order of least deviation: the best of a grid, refined between its neighbours.
double best_order(Points points) {
    constexpr int grid = 160;
    const auto at = [](int k) { return lowest_order + k * (highest_order - lowest_order) / grid; };
    int best = 0;
    for (int k = 1; k <= grid; ++k)
        if (deviation_at(at(k), &points) < deviation_at(at(best), &points)) best = k;
    if (best == 0 || best == grid) return at(best);
    const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> search(
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
    gsl_function function{deviation_at, &points};
    double low = at(best - 1), high = at(best + 1);
    const double middle = deviation_at(at(best), &points);
    if (deviation_at(low, &points) <= middle || deviation_at(high, &points) <= middle) return at(best);
    gsl_min_fminimizer_set(search.get(), &function, at(best), low, high);
    constexpr int most_iterations = 100;
    for (int i = 0; i < most_iterations; ++i) {
        if (gsl_min_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
        low = gsl_min_fminimizer_x_lower(search.get());
        high = gsl_min_fminimizer_x_upper(search.get());
        if (gsl_min_test_interval(low, high, 1e-8, 0) == GSL_SUCCESS) break;
    }
    return gsl_min_fminimizer_x_minimum(search.get());
}

struct Choice {
    Expansion fit;
    std::optional<double> order;
    bool trusted = true;  ///< the order is in the range of the small safety factor
};

Choice choose(const Points& points) {
    const double order = best_order(points);
    if (order >= 0.5 && order <= 2) return {fit_powers(points, {order}, unknowns_with_order), order};
    std::vector<Expansion> fits;
    if (order < 0.5) fits.push_back(fit_powers(points, {1, 2}, 3));
    fits.push_back(fit_powers(points, {1}, 2));
    fits.push_back(fit_powers(points, {2}, 2));
    const auto best = std::min_element(fits.begin(), fits.end(), [](const Expansion& a, const Expansion& b) {
        return a.deviation < b.deviation;
    });
    return {*best, std::nullopt, order >= 0.5 && order < 2.1};
}

}  // namespace

std::optional<LeastSquaresFit> fit_least_squares(Points points) {
    if (points.size() < 4) return std::nullopt;
    std::sort(points.begin(), points.end(), std::greater<>());
    const double finest = points.back().first, value = points.back().second;
    double low = value, high = value;
    for (auto& [spacing, f] : points) {
        spacing /= finest;
        low = std::min(low, f);
        high = std::max(high, f);
    }
    LeastSquaresFit result;
    result.limit = value;
    const double difference = (high - low) / static_cast<double>(points.size() - 1);
    if (difference == 0) return result;
    const Choice choice = choose(points);
    const Expansion& fit = choice.fit;
    result.limit = fit.limit;
    result.order = choice.order;
    result.deviation = fit.deviation;
    const double error = std::abs(fit.at_finest - fit.limit), residual = std::abs(value - fit.at_finest);
    const bool smooth = fit.deviation < difference;
    const double factor = smooth && choice.trusted ? 1.25 : 3;
    result.uncertainty = smooth ? factor * error + fit.deviation + residual
                                : 3 * fit.deviation / difference * (error + fit.deviation + residual);
    return result;
}

}  // namespace wetdeck

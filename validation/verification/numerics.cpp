// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/numerics.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace wetdeck::verification {
namespace {

/// Turns off GSL's error handler, which ends the program; results are checked here instead. All threads share
/// the handler: the last one restores it.
class ErrorsReturned {
  public:
    ErrorsReturned() {
        const std::lock_guard lock(mutex);
        if (users++ == 0) before = gsl_set_error_handler_off();
    }
    ~ErrorsReturned() {
        const std::lock_guard lock(mutex);
        if (--users == 0) gsl_set_error_handler(before);
    }
    ErrorsReturned(const ErrorsReturned&) = delete;
    ErrorsReturned& operator=(const ErrorsReturned&) = delete;

  private:
    static inline std::mutex mutex;
    static inline int users = 0;
    static inline gsl_error_handler_t* before = nullptr;
};

double call(double x, void* function) {
    return (*static_cast<const Function*>(function))(x);
}

}  // namespace

double integral(const Function& f, double from, double to) {
    if (from == to) return 0;
    const ErrorsReturned errors;
    constexpr std::size_t intervals = 1000;
    const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
        gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
    gsl_function wrapped{call, const_cast<Function*>(&f)};
    double value = 0, error = 0;
    gsl_integration_qag(&wrapped, from, to, 1e-300, 1e-11, intervals, GSL_INTEG_GAUSS31, workspace.get(),
                        &value, &error);
    if (!(error <= 1e-8 * std::abs(value)))
        throw std::logic_error("integral: does not converge to eight digits");
    return value;
}

double root(const Function& f, double low, double high) {
    const ErrorsReturned errors;
    if (!(f(low) * f(high) <= 0)) throw std::logic_error("root: no change of sign between the two places");
    const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    gsl_function wrapped{call, const_cast<Function*>(&f)};
    gsl_root_fsolver_set(solver.get(), &wrapped, low, high);
    constexpr int most_iterations = 300;
    for (int i = 0; i < most_iterations; ++i) {
        if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
        if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                                   gsl_root_fsolver_x_upper(solver.get()), 0, 1e-14) == GSL_SUCCESS)
            break;
    }
    return gsl_root_fsolver_root(solver.get());
}

std::vector<std::vector<double>> ode(
    const std::function<std::vector<double>(double, const std::vector<double>&)>& rates,
    std::vector<double> start, const std::vector<double>& times) {
    const ErrorsReturned errors;
    struct System {
        const std::function<std::vector<double>(double, const std::vector<double>&)>& rates;
        std::size_t size;
    } system{rates, start.size()};
    gsl_odeiv2_system wrapped{[](double t, const double* y, double* out, void* parameters) {
                                  const auto& s = *static_cast<System*>(parameters);
                                  const std::vector<double> result = s.rates(t, {y, y + s.size});
                                  std::copy(result.begin(), result.end(), out);
                                  return static_cast<int>(GSL_SUCCESS);
                              },
                              nullptr, start.size(), &system};
    const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
        gsl_odeiv2_driver_alloc_y_new(&wrapped, gsl_odeiv2_step_rk8pd, 1e-6 * times.back(), 1e-13, 1e-11),
        gsl_odeiv2_driver_free);
    double t = 0;
    std::vector<std::vector<double>> states;
    for (const double time : times) {
        if (time > t && gsl_odeiv2_driver_apply(driver.get(), &t, time, start.data()) != GSL_SUCCESS)
            throw std::logic_error("ode: no step small enough");
        states.push_back(start);
    }
    return states;
}

Curve sorted_curve(std::vector<std::pair<double, double>> points) {
    std::sort(points.begin(), points.end());
    Curve curve;
    for (const auto& [x, y] : points) {
        curve.x.push_back(x);
        curve.y.push_back(y);
    }
    return curve;
}

std::vector<double> linspace(double low, double high, std::size_t n) {
    std::vector<double> values(n);
    for (std::size_t k = 0; k < n; ++k)
        values[k] = low + (high - low) * static_cast<double>(k) / static_cast<double>(n - 1);
    return values;
}

}  // namespace wetdeck::verification

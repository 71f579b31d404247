// SPDX-License-Identifier: BSD-3-Clause
// Free fall of a wedge into water, two-dimensional, with the coefficients of its similarity flow.
#include "validation/analytic/wedge_free_fall.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace wetdeck {
namespace {

struct Model {
    double force, added_mass, buoyancy;  ///< over z V^2, z^2 dV/dt and z^2
    double mass, gravity;

    double acceleration(double z, double v) const {
        return (mass * gravity - force * z * v * v - buoyancy * z * z) / (mass + added_mass * z * z);
    }
};

int rate(double, const double state[], double derivative[], void* model) {
    derivative[0] = state[1];
    derivative[1] = static_cast<const Model*>(model)->acceleration(state[0], state[1]);
    return GSL_SUCCESS;
}

}  // namespace

WedgeFall wedge_free_fall(const WedgeSimilarity& wedge, const FallingWedge& fall, double depth, double step) {
    Model model{wedge.force_coefficient * fall.density, wedge.added_mass_coefficient * fall.density,
                fall.density * fall.gravity / std::tan(wedge.deadrise), fall.mass, fall.gravity};
    gsl_odeiv2_system system{rate, nullptr, 2, &model};
    const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, step, 1e-12, 1e-10),
        gsl_odeiv2_driver_free);
    WedgeFall result;
    std::array state{0.0, fall.speed};
    double time = 0;
    for (int row = 1; state[0] < depth && state[1] > 0; ++row) {
        result.time.push_back(time);
        result.penetration.push_back(state[0]);
        result.velocity.push_back(state[1]);
        result.force.push_back(fall.mass * (fall.gravity - model.acceleration(state[0], state[1])));
        if (gsl_odeiv2_driver_apply(driver.get(), &time, row * step, state.data()) != GSL_SUCCESS) {
            throw std::runtime_error("free fall of a wedge: the equation of motion could not be integrated");
        }
    }
    return result;
}

}  // namespace wetdeck

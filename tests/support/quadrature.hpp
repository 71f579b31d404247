// SPDX-License-Identifier: BSD-3-Clause
// Integrals by adaptive quadrature, for formulas that claim to be one.
#pragma once

#include <gsl/gsl_integration.h>

#include <memory>

namespace wetdeck::samples {

/// Integral of f over [from, to] to 1e-12 relative.
template <class Function>
double integral(const Function& f, double from, double to) {
    const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
        gsl_integration_workspace_alloc(200), gsl_integration_workspace_free);
    gsl_function wrapped;
    wrapped.function = [](double x, void* context) { return (*static_cast<const Function*>(context))(x); };
    wrapped.params = const_cast<Function*>(&f);
    double value = 0, error = 0;
    gsl_integration_qag(&wrapped, from, to, 0, 1e-12, 200, GSL_INTEG_GAUSS31, workspace.get(), &value,
                        &error);
    return value;
}

}  // namespace wetdeck::samples

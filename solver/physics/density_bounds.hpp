// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the density of water from its kernel sum S_i = SUM_j V_j W_ij over fluid and walls:
//     rho_lowest <= rho_i <= max(rho_open, rho_0 (1 + 10 (S_i - S_full)))
//
// Above: the continuity equation counts a wall, or other water, as soon as it comes within the kernel's
// support, and would compress a surface that nothing has touched yet: a body would act as if it were half a
// spacing larger. A particle whose support is not full has nothing to press against. S_full is below one, so
// that disorder does not count as a gap. Water that touches a face counts as fully supported, else thin jets
// would pass through walls. rho_open follows from the weight of one spacing of water: a surface at rest keeps
// its pressure.
//
// Below: water without air bears no negative pressure (rho_lowest = rho_0). Water behind a face is compressed
// in proportion to its depth there, in spacings from the nearest layer:
//     rho_i >= rho_0 (1 + depth / 10),
// because the continuity equation does not see a particle that drifts into a wall with nothing behind it.
#pragma once

#include "solver/core/scalar_math.hpp"

namespace wetdeck {

/// Distance from a face below which water touches it [spacings], and the kernel sum that stands for it: any
/// density of a stable run is below its bound.
inline constexpr double touching_distance = 0.25, touching_kernel_sum = 10;

/// Slope of the upper bound beyond a full kernel sum: impacts compress water by a tenth and hardly change its
/// kernel sum.
inline constexpr double kernel_sum_steepness = 10;

/// Compression per spacing of depth behind a face. The kernel sum of a touching particle is
/// touching_kernel_sum plus that depth; all other kernel sums are so much lower that this bound is below
/// every density.
inline constexpr double compression_per_depth = 0.1;

/// Densities below this share of their reference end a run: the state is that of no fluid.
inline constexpr double lowest_density_ratio = 0.2;

/// The bounds of one update of the density of a phase.
struct DensityBounds {
    double lowest = 0;                   ///< [kg/m^3]
    const double* kernel_sum = nullptr;  ///< S of each particle; none for no upper bound
    double open = 0;                     ///< highest where the support is not full, finest spacing [kg/m^3]
    double full_kernel_sum = 1;          ///< S of a full support

    /// `density` within the bounds; `sum`, the particle's S, and `its_open`, the highest of its spacing,
    /// count only where there is an upper bound.
    template <class Real>
    Real limit(Real density, Real sum, Real its_open, double reference_density) const {
        if (!kernel_sum) return maximum(density, Real(lowest));
        const Real highest =
            maximum(its_open, reference_density * (1.0 + kernel_sum_steepness * (sum - full_kernel_sum)));
        const Real pushed_back =
            reference_density * (1.0 + compression_per_depth * (sum - touching_kernel_sum));
        return maximum(minimum(density, highest), maximum(pushed_back, Real(lowest)));
    }
};

}  // namespace wetdeck

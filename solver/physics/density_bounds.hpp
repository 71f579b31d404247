// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the density of water,
//     rho_lowest <= rho_i <= max(rho_open, rho_0 (1 + 10 (C_i - full))),   C_i = SUM_j V_j W_ij over fluid
//     and walls.
//
// Above: the continuity equation counts a wall, or other water, as soon as it comes within the kernel's
// support, and would compress a surface that nothing has touched yet. Bodies then act as if they were half a
// spacing larger, and the pressure beside them is too high (wedge at dx = 0.01: 1.4 times what the force
// says; 1.0 with the bound). A particle whose support is not full has nothing to press against. Full is less
// than one, so that disorder does not count as a gap. What is closer to a face than particles come to rest
// counts as covered: thin jets would pass through walls.
//
// rho_open is what the weight of one spacing of water gives: a surface at rest keeps its pressure.
//
// Below: water without air bears no tension, and what flies apart must not remember it: rho_lowest = rho_0.
// What touches a face is not under tension, and what is behind it is compressed by that alone,
//     rho_i >= rho_0 (1 + depth / 10),
// depth in spacings, counted from the nearest layer, so up to one: at a tenth of the speed of sound water
// stops within a third of one. The continuity equation does not see a particle that drifts into a wall with
// nothing behind it: what it gains from the mirrored wall ahead it loses behind. Such a particle was inside
// the sinking rectangle after half a second.
#pragma once

#include "solver/core/scalar_math.hpp"

namespace wetdeck {

/// Distance from a face below which water touches it [spacings], and the cover that it then has: any density
/// that a run survives is below.
inline constexpr double touching_distance = 0.25, touching_cover = 10;

/// Of the upper bound beyond a full cover: impacts compress water by a tenth, and leave its cover as it is.
inline constexpr double cover_steepness = 10;

/// Compression per spacing of depth behind a face. A touching particle's cover is touching_cover plus that
/// depth; the cover of all others is so much less that this bound is below every density.
inline constexpr double compression_per_depth = 0.1;

/// The bounds of one pass over the water.
struct DensityBounds {
    double lowest = 0;              ///< [kg/m^3]
    const double* cover = nullptr;  ///< C of each particle; none for no upper bound
    double open = 0;                ///< highest where the support is not full [kg/m^3]
    double full_cover = 1;          ///< C of a full support

    /// `density` within the bounds; `particle_cover` counts only where there is an upper bound.
    template <class Real>
    Real limit(Real density, Real particle_cover, double reference_density) const {
        if (!cover) return maximum(density, Real(lowest));
        const Real highest =
            maximum(Real(open), reference_density * (1.0 + cover_steepness * (particle_cover - full_cover)));
        const Real pushed_back =
            reference_density * (1.0 + compression_per_depth * (particle_cover - touching_cover));
        return maximum(minimum(density, highest), maximum(pushed_back, Real(lowest)));
    }
};

}  // namespace wetdeck

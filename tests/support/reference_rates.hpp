// SPDX-License-Identifier: BSD-3-Clause
// The rates of all particles by the plainest means: every pair, one after another, straight from the formulas
// of Yang et al. (2020). Slow, and independent of clusters, packs, lists and tables of coefficients.
#pragma once

#include <vector>

#include "solver/particles/fluid.hpp"
#include "solver/particles/walls.hpp"
#include "solver/physics/model.hpp"

namespace wetdeck::samples {

struct Rates {
    std::vector<double> density;                         ///< [kg/(m^3 s)]
    std::vector<double> acceleration_x, acceleration_y;  ///< [m/s^2], gravity included
    std::vector<double> kernel_sum;                      ///< SUM_j V_j W_ij
    std::vector<WallMean> wall;                          ///< Eq. (19)
};

/// Pressure, volume, density and impact mark, or fineness, of each particle are taken as they are.
/// @param graded  particles differ in their spacings
Rates reference_rates(const FluidParticles& fluid, const WallParticles& walls, const Model& model,
                      double particle_spacing, bool graded = false);

/// Largest difference over the largest expected value, over the particles [first, last).
double difference(const std::vector<double>& found, const std::vector<double>& expected, std::size_t first,
                  std::size_t last);

/// 2 V_i V_j P* |dW/dr| e_ij: what particle i gives to particle j [N/m].
Vec2 reference_pair_force(const FluidParticles& fluid, std::size_t i, std::size_t j, const Model& model,
                          double particle_spacing);

}  // namespace wetdeck::samples

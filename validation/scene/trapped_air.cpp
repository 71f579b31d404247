// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/trapped_air.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/scene/expected_motion.hpp"

namespace wetdeck {
namespace {

/// Water above air, per column of the tank.
struct Column {
    double bottom, height;  ///< of the water [m]
};

/// The lowest water of each column between the ends of the boxes; none where a column has no water.
std::optional<std::vector<Column>> columns_of(const Scene& scene) {
    std::vector<Column> columns;
    for (const double x : column_middles(scene)) {
        std::optional<Column> found;
        for (const Box& box : scene.water_boxes) {
            if (x < box.low.x() || x > box.high.x()) continue;
            if (!found) found = Column{box.low.y(), 0};
            found->bottom = std::min(found->bottom, box.low.y());
            found->height += box.high.y() - box.low.y();
        }
        if (!found) return std::nullopt;
        columns.push_back(*found);
    }
    return columns;
}

/// Over B and the volume.
double work_of_squeezing(double share, double exponent) {
    const bool isothermal = std::abs(exponent - 1) < 1e-9;
    const double compression =
        isothermal ? -std::log(share) : (std::pow(share, 1 - exponent) - 1) / (exponent - 1);
    return compression - (1 - share);
}

}  // namespace

double squeezed_share(double weight, double stiffness, double exponent, double energy_of_motion) {
    double low = 1e-6, high = 1;
    for (int halving = 0; halving < 60; ++halving) {
        const double x = 0.5 * (low + high);
        const double energy = energy_of_motion + weight * (1 - x);
        (stiffness * work_of_squeezing(x, exponent) > energy ? low : high) = x;
    }
    return 0.5 * (low + high);
}

std::optional<std::string> doubtful_trapped_air(const Scene& scene) {
    if (!scene.air) return std::nullopt;
    const auto columns = columns_of(scene);
    if (!columns) return std::nullopt;
    double depth = 0;  // of the water, the largest: the hardest fall
    for (const Column& column : *columns) {
        const double below = column.bottom - scene.tank.low.y();
        if (!(below > 0)) return std::nullopt;  // the water stands on the floor
        depth = std::max(depth, column.height);
    }
    const TaitEquationOfState& air = scene.model.air.eos;
    const double weight = scene.model.water.eos.reference_density * scene.model.gravity.norm() * depth;
    const double share = squeezed_share(weight, air.coefficient(), air.exponent);
    if (share >= least_squeezed_share) return std::nullopt;
    const double needed = weight * (1 - least_squeezed_share) /
                          work_of_squeezing(least_squeezed_share, air.exponent);  // B [Pa]
    return fmt::format(
        "the water falls on air that it encloses and squeezes it to about {:.2g} of its volume: below a "
        "third it leaks through the walls; expected air of more than {:.3g} m/s, or a way out for it",
        share, std::sqrt(needed * air.exponent / air.reference_density));
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "solver/setup/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

constexpr double largest_stretch = 0.02;

struct Axis {
    int count;
    double spacing;
};

Axis fit(double length, double particle_spacing) {
    const int count = std::max(1, static_cast<int>(std::lround(length / particle_spacing)));
    return {count, length / count};
}

}  // namespace

bool spacing_fits(double length, double particle_spacing) {
    return std::abs(fit(length, particle_spacing).spacing / particle_spacing - 1) <= largest_stretch;
}

int boundary_layers(double support_radius, double particle_spacing) {
    return static_cast<int>(std::ceil(support_radius / particle_spacing - 1e-9));
}

void fill_box(FluidParticles& fluid, Phase phase, Box region, double particle_spacing, double density) {
    const Vec2 size = region.high - region.low;
    const Axis axes[] = {fit(size.x(), particle_spacing), fit(size.y(), particle_spacing)};
    for (const double side : {size.x(), size.y()}) {
        if (spacing_fits(side, particle_spacing)) continue;
        char text[200];
        std::snprintf(text, sizeof text,
                      "particle spacing %.6g m does not fit the side of %.6g m (%.2f particles)",
                      particle_spacing, side, side / particle_spacing);
        throw InputError(text);
    }
    const double volume = axes[0].spacing * axes[1].spacing;
    for (int column = 0; column < axes[0].count; ++column) {
        for (int row = 0; row < axes[1].count; ++row) {
            const Vec2 offset((column + 0.5) * axes[0].spacing, (row + 0.5) * axes[1].spacing);
            fluid.add(phase, region.low + offset, density * volume, density);
        }
    }
}

WallParticles tank_walls(Box tank, double particle_spacing, double support_radius, DomainEnds ends) {
    const Vec2 size = tank.high - tank.low;
    const Axis along_x = fit(size.x(), particle_spacing), along_y = fit(size.y(), particle_spacing);
    const int layers = boundary_layers(support_radius, particle_spacing);
    WallParticles walls;
    const auto coordinate = [&](int index, const Axis& axis, double low) {
        if (index < 0) return low + (index + 0.5) * particle_spacing;
        if (index >= axis.count)
            return low + axis.count * axis.spacing + (index - axis.count + 0.5) * particle_spacing;
        return low + (index + 0.5) * axis.spacing;
    };
    for (int column = -layers; column < along_x.count + layers; ++column) {
        for (int row = -layers; row < along_y.count + layers; ++row) {
            const bool behind_open = (column < 0 && ends != DomainEnds::walls) ||
                                     (column >= along_x.count && ends == DomainEnds::periodic);
            const bool between_ends = (column >= 0 && column < along_x.count) || behind_open;
            if (between_ends && row >= 0 && row < along_y.count) continue;
            const Vec2 position(coordinate(column, along_x, tank.low.x()),
                                coordinate(row, along_y, tank.low.y()));
            Vec2 nearest = position.cwiseMax(tank.low).cwiseMin(tank.high);
            if (behind_open) nearest.x() = position.x();
            walls.add(position, (nearest - position).normalized());
        }
    }
    return walls;
}

}  // namespace wetdeck

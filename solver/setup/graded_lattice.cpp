// SPDX-License-Identifier: BSD-3-Clause
#include "solver/setup/graded_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "solver/setup/lattice.hpp"

namespace wetdeck {
namespace {

/// Distance from a box within which it is moved to a side of the region [finest spacings].
constexpr double least_distance = 3;

/// Thicknesses of the rings on one side, outwards; together as thick as the side is far away.
std::vector<double> thicknesses(double distance, const Grading& g) {
    std::vector<double> rings;
    if (distance < 1e-9 * g.finest) return rings;
    double sum = 0;
    while (sum < distance) {
        const double grown = (g.finest + g.growth * sum) / (1 - 0.5 * g.growth);  // in the middle of the ring
        rings.push_back(std::min(grown, g.coarsest * g.finest));
        sum += rings.back();
    }
    const double without_last = sum - rings.back();
    if (rings.size() > 1 && distance / without_last < sum / distance) {
        rings.pop_back();
        sum = without_last;
    }
    for (double& thickness : rings) thickness *= distance / sum;
    return rings;
}

/// A region along one axis: rings before the finest cells, these, and rings behind.
struct Axis {
    double low, high;            ///< of the finest cells [m]
    int count;                   ///< of the finest cells
    std::vector<double> before;  ///< thicknesses outwards, towards low values [m]
    std::vector<double> behind;  ///< the same towards high values [m]
};

Axis axis_of(double low, double high, double box_low, double box_high, const Grading& g) {
    const double near = least_distance * g.finest;
    const bool to_low = box_low<low + near, to_high = box_high> high - near;
    if (to_low && to_high) {
        if (!spacing_fits(high - low, g.finest))
            throw InputError("the finest spacing does not fit the side that its box fills");
        return {low, high, std::max(1, static_cast<int>(std::lround((high - low) / g.finest))), {}, {}};
    }
    const double begin = to_low ? low : std::min(box_low, high),
                 end = to_high ? high : std::max(box_high, low);
    Axis axis{low, high, std::max(1, static_cast<int>(std::ceil((end - begin) / g.finest - 1e-6))), {}, {}};
    const double length = axis.count * g.finest;
    if (!to_low) axis.low = to_high ? high - length : 0.5 * (begin + end - length);
    if (!to_high) axis.high = axis.low + length;
    axis.before = thicknesses(axis.low - low, g);
    axis.behind = thicknesses(high - axis.high, g);
    return axis;
}

/// Cells of a strip, as long as it is thick, side by side along x or y.
void divide(std::vector<Box>& cells, Box strip, bool along_x) {
    const Vec2 size = strip.high - strip.low;
    const double length = along_x ? size.x() : size.y(), thickness = along_x ? size.y() : size.x();
    if (!(length > 0 && thickness > 0)) return;
    const int count = std::max(1, static_cast<int>(std::lround(length / thickness)));
    const auto edge = [&](int n) { return n == count ? length : n * (length / count); };
    for (int n = 0; n < count; ++n) {
        Box cell = strip;
        const int k = along_x ? 0 : 1;
        cell.high[k] = strip.low[k] + edge(n + 1);
        cell.low[k] = strip.low[k] + edge(n);
        cells.push_back(cell);
    }
}

}  // namespace

double Grading::spacing_at(Vec2 place) const {
    const Vec2 outside = (around.low - place).cwiseMax(place - around.high).cwiseMax(Vec2::Zero());
    return std::min(finest + growth * outside.maxCoeff(), coarsest * finest);
}

std::vector<Box> graded_cells(Box region, const Grading& grading) {
    const Vec2 low = region.low, high = region.high;
    const Box& box = grading.around;
    const Axis x = axis_of(low.x(), high.x(), box.low.x(), box.high.x(), grading);
    const Axis y = axis_of(low.y(), high.y(), box.low.y(), box.high.y(), grading);
    std::vector<Box> cells;
    const double wide = (x.high - x.low) / x.count, tall = (y.high - y.low) / y.count;
    for (int column = 0; column < x.count; ++column)
        for (int row = 0; row < y.count; ++row)
            cells.push_back({{x.low + column * wide, y.low + row * tall},
                             {x.low + (column + 1) * wide, y.low + (row + 1) * tall}});
    Box inner{{x.low, y.low}, {x.high, y.high}};
    const std::size_t rings = std::max({x.before.size(), x.behind.size(), y.before.size(), y.behind.size()});
    for (std::size_t k = 0; k < rings; ++k) {
        Box outer = inner;
        const auto next = [k](const std::vector<double>& list, double at, double sign, double end) {
            return k + 1 < list.size() ? at + sign * list[k] : end;  // the last one ends at the side
        };
        outer.low = {next(x.before, inner.low.x(), -1, low.x()), next(y.before, inner.low.y(), -1, low.y())};
        outer.high = {next(x.behind, inner.high.x(), 1, high.x()),
                      next(y.behind, inner.high.y(), 1, high.y())};
        divide(cells, {outer.low, {outer.high.x(), inner.low.y()}}, true);
        divide(cells, {{outer.low.x(), inner.high.y()}, outer.high}, true);
        divide(cells, {{outer.low.x(), inner.low.y()}, {inner.low.x(), inner.high.y()}}, false);
        divide(cells, {{inner.high.x(), inner.low.y()}, {outer.high.x(), inner.high.y()}}, false);
        inner = outer;
    }
    return cells;
}

double fineness_of(double volume, double finest) {
    return std::min(1.0, finest / std::sqrt(volume));
}

double coarsest_over_finest(const FluidParticles& fluid, const WallParticles& walls) {
    double least = 1;
    for (const FluidState& p : fluid.state) least = std::min(least, p.fineness);
    for (const double fineness : walls.fineness) least = std::min(least, fineness);
    return 1 / least;
}

void fill_cells(FluidParticles& fluid, Phase phase, const std::vector<Box>& cells, double finest,
                double density) {
    for (const Box& cell : cells) {
        const double volume = (cell.high - cell.low).prod();
        fluid.add(phase, 0.5 * (cell.low + cell.high), density * volume, density,
                  fineness_of(volume, finest));
    }
}

WallParticles graded_tank_walls(Box tank, const std::vector<Box>& cells, double finest, int layers,
                                DomainEnds ends) {
    WallParticles walls;
    for (const Box& cell : cells) {
        const Vec2 size = cell.high - cell.low, middle = 0.5 * (cell.low + cell.high);
        const double near = 1e-6 * finest, fineness = fineness_of(size.prod(), finest);
        const bool open_left = ends == DomainEnds::mirror_left;
        // sides of the tank that the cell touches along each axis: -1 at the low one, 1 at the high one
        const auto sides = [&](int k) {
            std::vector<int> found{0};
            if (cell.low[k] < tank.low[k] + near && !(k == 0 && open_left)) found.push_back(-1);
            if (cell.high[k] > tank.high[k] - near) found.push_back(1);
            return found;
        };
        const auto add = [&](Vec2 position, Vec2 normal) {
            walls.add(position, normal, fineness);
            const double beyond = position.x() - tank.low.x();
            if (open_left && normal.y() != 0 && beyond < layers * size.x())
                walls.add({tank.low.x() - beyond, position.y()}, {-normal.x(), normal.y()}, fineness);
        };
        for (const int x : sides(0)) {
            for (const int y : sides(1)) {
                if (x == 0 && y == 0) continue;
                for (int i = 0; i < (x == 0 ? 1 : layers); ++i) {
                    for (int j = 0; j < (y == 0 ? 1 : layers); ++j) {
                        const Vec2 position(middle.x() + x * (i + 1) * size.x(),
                                            middle.y() + y * (j + 1) * size.y());
                        Vec2 nearest = position.cwiseMax(tank.low).cwiseMin(tank.high);
                        add(position, (nearest - position).normalized());
                    }
                }
            }
        }
    }
    return walls;
}

}  // namespace wetdeck

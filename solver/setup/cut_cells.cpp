// SPDX-License-Identifier: BSD-3-Clause
#include "solver/setup/cut_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetdeck {
namespace {

constexpr double whole = 1 - 1e-9;  // shares of a cell
constexpr double kept = 0.5;
constexpr double least_distance = 0.2;  // of a particle from a face, in spacings

/// What the bodies leave of a particle's cell.
struct Cell {
    Vec2 centroid = Vec2::Zero();
    double area = 0;   ///< [m^2]
    double share = 1;  ///< of the whole cell
};

Cell cell_of(const FluidState& particle, double volume, const std::vector<Outline>& outlines) {
    const double half = 0.5 * std::sqrt(volume);
    const Vec2 middle = particle.position();
    const AreaMoments left = area_left({middle - Vec2(half, half), middle + Vec2(half, half)}, outlines);
    const double share = left.area / volume;
    return share < whole ? Cell{left.centroid, left.area, share} : Cell{middle, volume, 1};
}

/// The particles whose cells a body may cut, by number.
std::map<std::size_t, Cell> cells_near(const FluidParticles& fluid, const std::vector<Outline>& outlines,
                                       double particle_spacing) {
    std::vector<Box> around;
    for (const Outline& outline : outlines) {
        Box box{outline[0], outline[0]};
        for (const Vec2& corner : outline) extend(box, corner);
        const Vec2 margin(2 * particle_spacing, 2 * particle_spacing);
        around.push_back({box.low - margin, box.high + margin});
    }
    std::map<std::size_t, Cell> cells;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const Vec2 at = fluid.state[i].position();
        const auto holds = [&](const Box& box) {
            return (at - box.low).minCoeff() > 0 && (box.high - at).minCoeff() > 0;
        };
        if (std::any_of(around.begin(), around.end(), holds))
            cells[i] = cell_of(fluid.state[i], fluid.mass[i] / fluid.state[i].density, outlines);
    }
    return cells;
}

/// The nearest point that keeps its distance from all bodies: the centroid of a cell around a corner can lie
/// inside it.
Vec2 clear_of(const std::vector<Outline>& outlines, Vec2 point, double particle_spacing) {
    const double difference = 1e-3 * particle_spacing;
    for (int k = 0; k < 10; ++k) {
        for (const Outline& outline : outlines) {
            const double lacks = least_distance * particle_spacing - distance_to(outline, point);
            if (lacks <= 0) continue;
            const auto distance = [&](double x, double y) {
                return distance_to(outline, point + Vec2(x, y));
            };
            const Vec2 away(distance(difference, 0) - distance(-difference, 0),
                            distance(0, difference) - distance(0, -difference));
            if (!away.isZero(0)) point += 1.001 * lacks * away.normalized();
        }
    }
    return point;
}

/// Adds a small cell to the nearest one of its phase that is kept, if there is one beside it: a slit narrower
/// than half a spacing holds no fluid.
void join(const Cell& small, Phase phase, const FluidParticles& fluid, double particle_spacing,
          std::map<std::size_t, Cell>& cells) {
    Cell* nearest = nullptr;
    double distance = 1.5 * particle_spacing;
    for (auto& [i, cell] : cells) {
        if (cell.share < kept || fluid.phase(i) != phase) continue;
        const double there = (fluid.state[i].position() - small.centroid).norm();
        if (there >= distance) continue;
        distance = there;
        nearest = &cell;
    }
    if (nearest == nullptr) return;
    const double area = nearest->area + small.area;
    nearest->centroid = (nearest->area * nearest->centroid + small.area * small.centroid) / area;
    nearest->area = area;
}

}  // namespace

void cut_cells(FluidParticles& fluid, const std::vector<Outline>& outlines, double particle_spacing) {
    std::map<std::size_t, Cell> cells = cells_near(fluid, outlines, particle_spacing);
    for (const auto& [i, cell] : cells)
        if (cell.share < kept && cell.share > 1 - whole)
            join(cell, fluid.phase(i), fluid, particle_spacing, cells);
    FluidParticles left;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const double density = fluid.state[i].density;
        const auto found = cells.find(i);
        const bool is_cut = found != cells.end() && found->second.centroid != fluid.state[i].position();
        if (!is_cut)
            left.add(fluid.phase(i), fluid.state[i].position(), fluid.mass[i], density,
                     fluid.state[i].fineness);
        else if (found->second.share >= kept)
            left.add(fluid.phase(i), clear_of(outlines, found->second.centroid, particle_spacing),
                     density * found->second.area, density, fluid.state[i].fineness);
    }
    fluid = std::move(left);
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/cell_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetdeck {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void append(std::vector<Cluster>& clusters, std::size_t begin, std::size_t end, const Cluster& kind) {
    for (std::size_t first = begin; first < end; first += cluster_width) {
        Cluster cluster = kind;
        cluster.first = static_cast<std::uint32_t>(first);
        cluster.count = static_cast<std::uint32_t>(std::min<std::size_t>(cluster_width, end - first));
        clusters.push_back(cluster);
    }
}

}  // namespace

CellGrid grid_over(Box box, double particle_spacing) {
    CellGrid grid{box.low, 3.2 * particle_spacing, particle_spacing, 0, 0};
    const Vec2 size = box.high - box.low;
    grid.strips = static_cast<std::uint32_t>(std::ceil(size.x() / grid.cell_width)) + 1;
    grid.rows = static_cast<std::uint32_t>(std::ceil(size.y() / grid.cell_height)) + 1;
    return grid;
}

CellLevels::CellLevels(const CellGrid& over_domain, double coarsest) : finest_(over_domain.cell_height) {
    const std::size_t count = coarsest > 1 ? std::max<std::size_t>(level_number(1 / coarsest) + 1, 2) : 1;
    std::uint32_t first_cell = 0;
    for (std::size_t n = 0; n < count; ++n) {
        levels_.push_back({over_domain,
                           first_cell,
                           std::max(std::exp2(-1.0 - static_cast<double>(n)), 1 / coarsest),
                           {Vec2::Constant(-infinity), Vec2::Constant(infinity)}});
        first_cell = levels_.back().end_cell();
    }
}

std::size_t CellLevels::level_number(double fineness) {
    int exponent;
    std::frexp(fineness, &exponent);
    return static_cast<std::size_t>(std::max(-exponent, 0));
}

void CellLevels::fit_to(const std::vector<Box>& extents) {
    std::uint32_t first_cell = 0;
    for (std::size_t n = 0; n < levels_.size(); ++n) {
        Level& level = levels_[n];
        const bool empty = extents[n].low.x() > extents[n].high.x();
        level.grid = grid_over(empty ? Box{Vec2::Zero(), Vec2::Zero()} : extents[n], std::exp2(n) * finest_);
        level.extent = extents[n];
        level.first_cell = first_cell;
        first_cell = level.end_cell();
    }
}

void CellLevels::append_clusters(std::vector<Cluster>& clusters, std::size_t group, Phase phase) const {
    Cluster kind;
    kind.phase = phase;
    kind.slow = group == 0;
    const std::uint32_t* first = start.data() + group * count();
    for (const Level& level : levels_)
        append(clusters, first[level.first_cell], first[level.end_cell()], kind);
}

}  // namespace wetdeck

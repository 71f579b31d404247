// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/phase_defects.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace wetdeck {
namespace {

bool in_a_body(const Simulation& simulation, std::span<const Outline> outlines, Vec2 point) {
    for (std::size_t b = 0; b < outlines.size(); ++b)
        if (contains(outlines[b], simulation.bodies()[b].local(point))) return true;
    return false;
}

/// Square cells over the tank, each with a mark.
class Cells {
  public:
    Cells(Box box, double size)
        : low_(box.low),
          size_(size),
          columns_(std::max<long>(1, std::lround((box.high.x() - box.low.x()) / size))),
          rows_(std::max<long>(1, std::lround((box.high.y() - box.low.y()) / size))),
          marked_(static_cast<std::size_t>(columns_ * rows_)) {}

    /// Marks the cells whose centres are within the distance of the point.
    void mark_around(double x, double y, double distance) {
        const double middle_x = (x - low_.x()) / size_, middle_y = (y - low_.y()) / size_;
        const double radius = distance / size_;
        const auto [first_row, last_row] = range(middle_y, radius, rows_);
        for (long row = first_row; row <= last_row; ++row) {
            const double up = static_cast<double>(row) + 0.5 - middle_y;
            const auto [first, last] =
                range(middle_x, std::sqrt(std::max(0.0, radius * radius - up * up)), columns_);
            if (first > last) continue;
            char* const begin = marked_.data() + row * columns_;
            std::fill(begin + first, begin + last + 1, char{1});
        }
    }

    template <class Visit>
    void for_each_unmarked(const Visit& visit) const {
        for (long row = 0; row < rows_; ++row)
            for (long column = 0; column < columns_; ++column)
                if (!marked_[static_cast<std::size_t>(row * columns_ + column)]) visit(centre(column, row));
    }

  private:
    Vec2 centre(long column, long row) const {
        return low_ + size_ * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
    }
    /// Cells whose centres are within `half` of `middle`, both in cells.
    static std::pair<long, long> range(double middle, double half, long count) {
        const double low = middle - half - 0.5, high = middle + half - 0.5;
        const auto whole = static_cast<long>(std::max(low, 0.0));
        const long first = static_cast<double>(whole) < low ? whole + 1 : whole;
        return {first, high < 0 ? -1 : std::min(count - 1, static_cast<long>(high))};
    }

    Vec2 low_;
    double size_;
    long columns_, rows_;
    std::vector<char> marked_;
};

/// Sets of particles that grow together.
class Groups {
  public:
    explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t of(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[of(a)] = of(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

double void_area(const Simulation& simulation, std::span<const Outline> outlines) {
    const double size = 0.25 * simulation.particle_spacing();
    Cells cells(simulation.domain(), size);
    for (const FluidState& p : simulation.fluid().state)
        cells.mark_around(p.x, p.y, simulation.spacing_of(p));
    const WallParticles& walls = simulation.walls();
    for (std::size_t n = 0; n < walls.size(); ++n)
        cells.mark_around(walls.state[n].x, walls.state[n].y,
                          simulation.particle_spacing() / walls.fineness[n]);
    double area = 0;
    cells.for_each_unmarked([&](Vec2 centre) {
        if (!in_a_body(simulation, outlines, centre)) area += size * size;
    });
    return area;
}

MixedParticles mixed_particles(const Simulation& simulation) {
    const NeighbourList& list = simulation.neighbours();
    const FluidParticles& fluid = simulation.fluid();
    const FluidState* listed = list.listed(fluid);
    const auto near = [&](const FluidState& p, Neighbours neighbours) {
        const double reach = 2 * simulation.spacing_of(p);
        return std::count_if(neighbours.begin(), neighbours.end(), [&](std::uint32_t j) {
            return (listed[j].position() - p.position()).squaredNorm() < reach * reach;
        });
    };
    MixedParticles mixed;
    if (fluid.water == fluid.size()) return mixed;  // groups are then coarse and fine
    for (const Cluster& cluster : list.clusters()) {
        const auto own = static_cast<std::size_t>(cluster.phase);
        const Neighbours same = fluid_neighbours(list.blocks(), cluster, own);
        const Neighbours other = fluid_neighbours(list.blocks(), cluster, 1 - own);
        if (other.empty()) continue;
        std::size_t& count = cluster.phase == Phase::water ? mixed.water_in_air : mixed.air_in_water;
        for (std::uint32_t lane = 0; lane < cluster.count; ++lane) {
            const FluidState& p = fluid.state[cluster.first + lane];
            const auto of_own = near(p, same) - 1;  // the list holds the particle itself
            if (3 * of_own < near(p, other)) ++count;
        }
    }
    return mixed;
}

double enclosed_air(const Simulation& simulation) {
    const NeighbourList& list = simulation.neighbours();
    const FluidParticles& fluid = simulation.fluid();
    constexpr auto air = static_cast<std::size_t>(Phase::air);
    Groups groups(fluid.size());
    for (const Cluster& cluster : list.clusters()) {
        if (cluster.phase != Phase::air) continue;
        for (const std::uint32_t j : fluid_neighbours(list.blocks(), cluster, air)) {
            if (j >= fluid.size()) continue;  // a periodic image
            if (j < cluster.first) continue;  // has met these
            for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
                const Vec2 apart = fluid.state[i].position() - fluid.state[j].position();
                const double reach = 1.5 * std::max(simulation.spacing_of(fluid.state[i]),
                                                    simulation.spacing_of(fluid.state[j]));
                if (apart.squaredNorm() < reach * reach) groups.join(i, j);
            }
        }
    }
    std::vector<double> volume(fluid.size());
    double all = 0;
    for (std::size_t i = fluid.water; i < fluid.size(); ++i) {
        volume[groups.of(static_cast<std::uint32_t>(i))] += fluid.state[i].volume;
        all += fluid.state[i].volume;
    }
    return volume.empty() ? 0 : all - *std::max_element(volume.begin(), volume.end());
}

double coarsest_at_bodies(const Simulation& simulation) {
    const NeighbourList& list = simulation.neighbours();
    const WallParticles& walls = simulation.walls();
    const FluidState* listed = list.listed(simulation.fluid());
    const double finest = simulation.particle_spacing();
    const auto touches = [&](const FluidState& p, const Cluster& cluster) {
        const double reach = 0.75 * (simulation.spacing_of(p) + finest);
        const auto first = walls.state.begin() + cluster.first;
        return std::any_of(first, first + cluster.count, [&](const WallState& w) {
            return (p.position() - Vec2(w.x, w.y)).squaredNorm() < reach * reach;
        });
    };
    double coarsest = finest;
    for (const Cluster& cluster : list.wall_clusters()) {
        if (cluster.first < walls.fixed) continue;
        for (std::size_t group = 0; group < group_count; ++group)
            for (const std::uint32_t j : fluid_neighbours(list.blocks(), cluster, group))
                if (simulation.spacing_of(listed[j]) > coarsest && touches(listed[j], cluster))
                    coarsest = simulation.spacing_of(listed[j]);
    }
    return coarsest / finest;
}

std::size_t particles_in_bodies(const Simulation& simulation, std::span<const Outline> outlines) {
    if (outlines.empty()) return 0;
    const auto& state = simulation.fluid().state;
    return static_cast<std::size_t>(std::count_if(state.begin(), state.end(), [&](const FluidState& p) {
        return in_a_body(simulation, outlines, p.position());
    }));
}

}  // namespace wetdeck

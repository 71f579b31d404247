// SPDX-License-Identifier: BSD-3-Clause
// Where particles lie: cells of a grid, strip by strip, and the first particle of each cell.
//
// Where particles differ in their smoothing lengths there is one grid a level, each twice as coarse as the
// one before and no larger than where its particles are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/neighbours/cluster.hpp"

namespace wetdeck {

/// `rows` cells in each of `strips` strips. Cells at the rim of the grid stand for all that is beyond it.
struct CellGrid {
    Vec2 origin = Vec2::Zero();              ///< lower left corner [m]
    double cell_width = 0, cell_height = 0;  ///< [m]
    std::uint32_t strips = 0, rows = 0;

    struct Cell {
        std::uint32_t strip, row;
    };
    /// The cell that holds a place, or is nearest to it.
    Cell cell_of(Vec2 place) const {
        const auto clamped = [](double offset, double width, std::uint32_t count) {
            return static_cast<std::uint32_t>(
                std::clamp(offset / width, 0.0, static_cast<double>(count - 1)));
        };
        return {clamped(place.x() - origin.x(), cell_width, strips),
                clamped(place.y() - origin.y(), cell_height, rows)};
    }
};

/// A grid over a box that is 3.2 spacings wide and one high a cell.
CellGrid grid_over(Box box, double particle_spacing);

/// The cells of one kind of particles, which are kept sorted by them.
class CellLevels {
  public:
    /// @param over_domain  in cells of the finest spacing
    /// @param coarsest     largest spacing over the finest; 1: all are equal, and there is one level
    CellLevels(const CellGrid& over_domain, double coarsest);

    /// Places the grids where the particles of their levels are, if there are several.
    /// @param place, fineness  of the particle with a number below `count`
    template <class Place, class Fineness>
    void fit(std::size_t count, Place place, Fineness fineness) {
        if (levels_.size() == 1) return;
        std::vector<Box> extents(levels_.size(), empty_box());
        for (std::size_t n = 0; n < count; ++n) extend(extents[level_of(fineness(n))], place(n));
        fit_to(extents);
    }
    /// Number of the cell of a particle; fineness is not read where there is one level.
    std::uint32_t cell_of(Vec2 place, double fineness) const {
        const Level& level = levels_[level_of(fineness)];
        return level.number(level.grid.cell_of(place));
    }
    /// Number of cells.
    std::size_t count() const { return levels_.back().end_cell(); }

    /// First particle of each cell, group after group, and an end mark.
    std::vector<std::uint32_t> start;

    /// Clusters of the particles of a group, none of two levels.
    void append_clusters(std::vector<Cluster>& clusters, std::size_t group, Phase phase) const;

    /// Calls visit(begin, end) for runs of particles of a group that hold all which points in a box have
    /// near.
    /// @param least_half_fineness  half the least fineness of the points
    template <class Visit>
    void for_each_run(Box box, double least_half_fineness, const ListReach& reach, std::size_t group,
                      const Visit& visit) const {
        const std::uint32_t* first = start.data() + group * count();
        for (const Level& level : levels_) {
            const double farthest = reach.of(least_half_fineness + 0.5 * level.least_fineness);
            const Vec2 lowest = box.low - Vec2::Constant(farthest),
                       highest = box.high + Vec2::Constant(farthest);
            if (level.is_clear_of(lowest, highest)) continue;
            const CellGrid::Cell low = level.grid.cell_of(lowest), high = level.grid.cell_of(highest);
            for (std::uint32_t strip = low.strip; strip <= high.strip; ++strip) {
                const std::uint32_t begin = first[level.number({strip, low.row})];
                const std::uint32_t end = first[level.number({strip, high.row}) + 1];
                if (begin != end) visit(begin, end);
            }
        }
    }

  private:
    /// The grid of particles of up to twice the smoothing length of the level before.
    struct Level {
        CellGrid grid;
        std::uint32_t first_cell;
        double least_fineness;  ///< of its particles
        Box extent;             ///< that holds all its particles; infinite where there is one level [m]

        std::uint32_t number(CellGrid::Cell cell) const {
            return first_cell + cell.strip * grid.rows + cell.row;
        }
        std::uint32_t end_cell() const { return first_cell + grid.strips * grid.rows; }
        bool is_clear_of(Vec2 lowest, Vec2 highest) const {
            return (highest - extent.low).minCoeff() < 0 || (extent.high - lowest).minCoeff() < 0;
        }
    };
    std::size_t level_of(double fineness) const {
        return levels_.size() == 1 ? 0 : std::min(level_number(fineness), levels_.size() - 1);
    }
    /// Each level holds finenesses from a power of two on.
    static std::size_t level_number(double fineness);
    void fit_to(const std::vector<Box>& extents);

    double finest_;              ///< spacing [m]
    std::vector<Level> levels_;  ///< from the finest to the coarsest
};

}  // namespace wetdeck

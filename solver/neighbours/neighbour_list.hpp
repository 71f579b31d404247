// SPDX-License-Identifier: BSD-3-Clause
// Clusters of adjacent particles and their common neighbours.
//
// A grid of cells two spacings wide and one high, numbered strip by strip, serves twice: fluid particles
// sorted along it make compact clusters (about 2 x 4 particles), and the candidates of a cluster are one
// contiguous run per strip. The list holds every pair closer than the kernel's support plus a skin. It stays
// complete while no particle has moved further than half the skin since it was built: two particles can then
// have come closer by no more than the skin.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/core/particles.hpp"
#include "solver/core/vec2.hpp"
#include "solver/neighbours/periodic_images.hpp"
#include "solver/pair_loop/pair_loop.hpp"

namespace wetdeck {

class NeighbourList {
  public:
    /// @param domain  where particles are expected [m]; those outside are still found, only more slowly
    /// @param with_walls_own_lists  also list the fluid around each boundary particle (Shepard pressure)
    /// @param periodic_x  the left and the right end of the domain are one place
    NeighbourList(Box domain, double particle_spacing, double support_radius, double skin,
                  bool with_walls_own_lists, bool periodic_x = false);

    /// Sorts the tank's boundary particles along the grid. Needed once, before the first build.
    void place_fixed(WallParticles& walls);

    /// Sorts the fluid and the particles of bodies along the grid (ids keep track) and lists all pairs within
    /// support and skin. Where the domain is periodic, particles that have left it come in at the other end.
    void build(FluidParticles& fluid, WallParticles& walls, const PairLoops& loops, int threads);

    /// Half the skin: how far a particle may move from where it was at the last build [m].
    double allowance() const { return 0.5 * skin_; }
    /// Position of particle i at the last build.
    Vec2 built_at(std::size_t i) const { return {built_[2 * i], built_[2 * i + 1]}; }
    const double* built_positions() const { return built_.data(); }

    /// What the indices of neighbours mean: the fluid, and behind it its periodic images as they now are.
    const FluidState* listed(const FluidParticles& fluid) {
        return images_ ? images_->appended_to(fluid) : fluid.state.data();
    }

    const std::vector<Cluster>& clusters() const { return clusters_; }
    /// Of the clusters, one a thread.
    const std::vector<std::size_t>& shares() const { return shares_; }
    /// Clusters of boundary particles that have fluid near, with that fluid as neighbours; none holds
    /// particles of both tank and bodies.
    const std::vector<Cluster>& wall_clusters() const { return wall_clusters_; }
    /// Whether there are any.
    bool with_walls_own_lists() const { return with_walls_own_lists_; }
    std::size_t entries() const;
    std::size_t bytes() const;

  private:
    struct Cell {
        std::uint32_t strip, row;
    };
    Cell cell_of(double x, double y) const;
    std::uint32_t cell_index(Cell cell) const { return cell.strip * rows_ + cell.row; }
    void sort_fluid(FluidParticles& fluid, int threads);
    void place_images(const FluidParticles& fluid);
    void sort_walls(WallParticles& walls, std::size_t begin, std::size_t end,
                    std::vector<std::uint32_t>& start);
    void list_neighbours(const FluidParticles& fluid, const WallParticles& walls, const PairLoops& loops,
                         int threads);

    std::optional<PeriodicImages> images_;
    Vec2 origin_;
    double cell_width_, cell_height_;
    std::uint32_t strips_, rows_;
    double reach_, skin_;
    bool with_walls_own_lists_;

    std::vector<std::uint32_t> fluid_start_;  ///< first particle of (phase, cell), plus an end mark
    std::vector<std::uint32_t> image_start_;  ///< the same of the periodic images
    std::vector<std::uint32_t> fixed_start_, body_start_;  ///< first boundary particle of a cell
    std::vector<Cluster> clusters_, wall_clusters_;
    std::vector<std::size_t> shares_;
    std::vector<std::vector<std::uint32_t>> block_lists_;  ///< neighbour indices of a block of clusters
    std::vector<double> built_;                            ///< x, y of each fluid particle at the last build
    std::vector<std::uint32_t> key_, order_;
    FluidParticles sorted_;  ///< scratch of the sort, kept to avoid allocation
    WallParticles sorted_walls_;
};

}  // namespace wetdeck

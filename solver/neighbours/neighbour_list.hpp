// SPDX-License-Identifier: BSD-3-Clause
// Clusters of adjacent particles and their common neighbours.
//
// A grid of cells 3.2 spacings wide and one high, numbered strip by strip, serves twice: fluid particles
// sorted along it make compact clusters, and the candidates of a cluster are one
// contiguous run per strip (cell_levels.hpp). The list holds every pair
// closer than the kernel's support plus a skin. It stays complete while no two particles can have come closer
// by more than the skin since it was built (relative_motion.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/core/vec2.hpp"
#include "solver/neighbours/cell_levels.hpp"
#include "solver/neighbours/domain_images.hpp"
#include "solver/neighbours/relative_motion.hpp"
#include "solver/particles/walls.hpp"

namespace wetdeck {

class NeighbourList {
  public:
    /// @param domain  where particles are expected [m]; those outside are still found, only more slowly
    /// @param with_walls_own_lists  also list the fluid around each boundary particle (Shepard pressure)
    /// @param ends    what is beyond the left and the right end of the domain
    /// @param coarsest  largest smoothing length over the finest, which the spacing and the support are those
    /// of; 1: all are equal, and nobody's fineness is read
    /// @param slow_fineness  largest fineness of the slow fluid; 0: water is slow and air is fast
    NeighbourList(Box domain, double particle_spacing, double support_radius, double skin,
                  bool with_walls_own_lists, DomainEnds ends = DomainEnds::walls, double coarsest = 1,
                  double slow_fineness = 0);

    /// Sorts the tank's boundary particles along the grid. Needed once, before the first build.
    void sort_fixed_walls(WallParticles& walls);

    /// Sorts the fluid and the particles of bodies along the grid (ids keep track) and lists all pairs within
    /// support and skin. Particles that have left a periodic domain come in at the other end, those
    /// behind a plane of symmetry before it.
    void build(FluidParticles& fluid, WallParticles& walls, NearFilter near, int threads);

    /// Call it after every move: no particle has moved by more than `farthest` [m] since the last call, or
    /// the build. Returns whether the list is still complete; once it is not, it must be built.
    ///
    /// Looks at the particles only when the sum of the longest moves has used up the rest of the skin.
    bool still_complete(double farthest, const FluidParticles& fluid, const WallParticles& walls,
                        int threads);
    double skin() const { return reach_.skin; }  ///< [m]
    /// Changes the skin from the next build on; a domain with images takes one as thick as it has room for.
    void set_skin(double skin, const WallParticles& walls);
    /// By how much any two particles may still come closer: the skin after a build [m].
    double slack() const { return slack_; }
    /// For a list that was built again as it was at a checkpoint.
    void set_slack(double slack) { slack_ = slack; }
    /// Position of particle i at the last build.
    Vec2 built_at(std::size_t i) const { return {built_[2 * i], built_[2 * i + 1]}; }
    const double* built_positions() const { return built_.data(); }

    /// What the indices of neighbours mean: the fluid, and behind it its images as they now are.
    const FluidState* listed(const FluidParticles& fluid) const {
        return images_ ? images_->appended_to(fluid) : fluid.state.data();
    }
    /// Number of both.
    std::size_t listed_count(const FluidParticles& fluid) const {
        return fluid.size() + (images_ ? images_->images().size() : 0);
    }

    const std::vector<Cluster>& clusters() const { return clusters_; }
    /// Neighbours of the clusters and of the wall clusters.
    const NeighbourBlocks& blocks() const { return blocks_; }
    /// Number of particles of the slow group, which come first.
    std::size_t slow() const { return slow_; }
    /// Of the clusters, one a thread.
    const std::vector<std::size_t>& shares() const { return shares_; }
    /// The same of the pairs with fast fluid.
    const std::vector<std::size_t>& fast_shares() const { return fast_shares_; }
    /// Clusters of boundary particles that have fluid near, with that fluid as neighbours; none holds
    /// particles of both tank and bodies.
    const std::vector<Cluster>& wall_clusters() const { return wall_clusters_; }
    /// Whether there are any.
    bool with_walls_own_lists() const { return with_walls_own_lists_; }
    std::size_t entries() const;
    std::size_t bytes() const;

  private:
    /// Positions and finenesses of the particles of some cells, each so many numbers apart.
    struct Places {
        const CellLevels& cells;
        const double* positions;
        std::size_t stride;
        const double* fineness;
        std::size_t fineness_stride;
    };
    double fineness_of(const FluidState& p) const { return graded_ ? p.fineness : 1; }
    /// Number of the group of particle i.
    std::uint32_t group_of(const FluidParticles& fluid, std::size_t i) const {
        const bool slow = slow_fineness_ > 0 ? fluid.state[i].fineness <= slow_fineness_ : i < fluid.water;
        return slow ? 0 : 1;
    }
    void sort_fluid(FluidParticles& fluid, int threads);
    void reorder(FluidParticles& fluid, int threads);
    void place_images(const FluidParticles& fluid);
    /// Reach of the coarsest [m].
    double farthest_reach() const { return reach_.of(1 / coarsest_); }
    void sort_walls(WallParticles& walls, std::size_t begin, std::size_t end, CellLevels& cells);
    void collect_moves(const FluidParticles& fluid, const WallParticles& walls, int threads);
    void list_neighbours(const FluidParticles& fluid, const WallParticles& walls, NearFilter near,
                         int threads);
    struct Search;
    void list_block(const Search& search, std::size_t block);

    std::optional<DomainImages> images_;
    CellGrid grid_;  ///< over the domain, of the finest
    ListReach reach_;
    double slack_ = 0;
    double coarsest_;
    bool graded_;
    RelativeMotion motion_;
    bool with_walls_own_lists_;
    double slow_fineness_;
    std::size_t slow_ = 0;

    CellLevels fluid_cells_, image_cells_;  ///< of the slow fluid, then of the fast
    CellLevels fixed_cells_, body_cells_;   ///< of boundary particles
    std::vector<Cluster> clusters_, wall_clusters_;
    std::vector<std::size_t> shares_, fast_shares_;
    NeighbourBlocks blocks_;
    std::vector<double> built_;     ///< x, y of each fluid particle at the last build
    std::vector<Vec2> built_body_;  ///< positions of the bodies' particles then
    std::vector<std::uint32_t> key_, order_;
    WallParticles sorted_walls_;  ///< scratch of the sort, kept to avoid allocation
};

}  // namespace wetdeck

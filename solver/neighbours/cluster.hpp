// SPDX-License-Identifier: BSD-3-Clause
// Clusters: eight adjacent particles of one phase and their common neighbours.
//
// Fluid is listed in two groups: the slow one, whose pairs with itself count once in several steps, and the
// fast one (see time/verlet.hpp). They are water and air, or coarse and fine water.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/particles/fluid.hpp"

namespace wetdeck {

inline constexpr std::uint32_t cluster_width = 8;

/// The groups of the fluid, slow before fast.
inline constexpr std::size_t group_count = 2;

/// Eight (or, at the end of a group, fewer) adjacent particles of one group. Their neighbours are a range of
/// one of the blocks of the list: first the slow fluid, then the fast, then boundary particles.
struct Cluster {
    std::uint32_t first = 0;                                    ///< index of the first particle
    std::uint32_t count = 0;                                    ///< 1..8
    Phase phase = Phase::water;                                 ///< of its particles
    bool slow = true;                                           ///< the group of its particles
    bool rests = false;                                         ///< is left alone by steps of the fast fluid
    std::uint32_t block = 0;                                    ///< of the list that holds the neighbours
    std::uint32_t offset = 0;                                   ///< of the neighbours in that block
    std::array<std::uint32_t, group_count> fluid_neighbours{};  ///< their number, by group
    std::uint32_t wall_neighbours = 0;                          ///< number of boundary particles among them

    /// Index of the particle in a lane; the last one stands in for those that a smaller cluster lacks.
    std::uint32_t at(std::uint32_t lane) const { return first + std::min(lane, count - 1); }
};

/// Indices of neighbours of consecutive clusters, one vector a block.
using NeighbourBlocks = std::vector<std::vector<std::uint32_t>>;

/// Indices of some of a cluster's neighbours.
using Neighbours = std::span<const std::uint32_t>;

/// The fluid neighbours of a cluster of one group.
inline Neighbours fluid_neighbours(const NeighbourBlocks& blocks, const Cluster& cluster, std::size_t group) {
    const std::size_t skipped = group == 0 ? 0 : cluster.fluid_neighbours[0];
    return {blocks[cluster.block].data() + cluster.offset + skipped, cluster.fluid_neighbours[group]};
}

/// The boundary particles among the neighbours of a cluster.
inline Neighbours wall_neighbours(const NeighbourBlocks& blocks, const Cluster& cluster) {
    const std::size_t skipped = std::size_t{cluster.fluid_neighbours[0]} + cluster.fluid_neighbours[1];
    return {blocks[cluster.block].data() + cluster.offset + skipped, cluster.wall_neighbours};
}

/// Positions of the particles of a cluster, by lane.
struct ClusterPoints {
    double x[cluster_width], y[cluster_width];
    double half_fineness[cluster_width];  ///< half the finest smoothing length over their own
};

/// How far apart the particles of a listed pair are at most.
struct ListReach {
    double support = 0;  ///< of the kernel of the finest [m]
    double skin = 0;     ///< [m]

    /// Of a pair with this fineness: the finest smoothing length over that of its kernel [m].
    template <class Real>
    Real of(Real fineness) const {
        return support / fineness + skin;
    }
};

/// Particles among which the neighbours of a cluster are looked for: indices [begin, end) of positions that
/// stand `stride` numbers apart, x first.
struct Candidates {
    const double* positions = nullptr;
    std::size_t stride = 0;
    std::uint32_t begin = 0, end = 0;
    const double* fineness = nullptr;  ///< where particles differ in it: as many numbers apart as this
    std::size_t fineness_stride = 0;
};

/// Writes to `out` which of the candidates are within reach of any of the points, and returns how many. It
/// may write a cluster's width of entries beyond them.
using NearFilter = std::uint32_t (*)(const ClusterPoints& points, const Candidates& candidates,
                                     const ListReach& reach, std::uint32_t* out);

/// Which pairs a pass sums up.
enum class Pairs { all, with_fast };

/// First clusters of as many consecutive shares of about the same number of neighbours as there are threads,
/// and an end mark. With Pairs::with_fast, slow fluid counts by its neighbours in the fast one: in the steps
/// of the fast fluid alone the rest of it is left alone.
std::vector<std::size_t> equal_shares(const std::vector<Cluster>& clusters, int threads,
                                      Pairs pairs = Pairs::all);

}  // namespace wetdeck

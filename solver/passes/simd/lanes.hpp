// SPDX-License-Identifier: BSD-3-Clause
// A cluster in registers, one particle a lane, and its geometry with one neighbour. Included only by the
// translation units that are compiled once per instruction set.
#pragma once

#include <algorithm>
#include <cstring>

#include "solver/passes/pass_input.hpp"
#include "solver/passes/simd/pack.hpp"

namespace wetdeck::WETDECK_ISA {

/// The particles of a cluster, one per lane. Lanes beyond its count hold particles that are computed and not
/// stored.
struct Lanes {
    Pack x, y, vx, vy, pressure, density;
    Pack impact, fineness;  ///< the same number of the state
};

/// The eight numbers of each particle of a cluster, turned: one number of all particles a pack.
template <class State>
WETDECK_INLINE void load_columns(const State* state, const Cluster& cluster, Pack (&columns)[pack_width]) {
    static_assert(sizeof(State) == pack_width * sizeof(double) && alignof(State) == sizeof(State));
    const double* rows[cluster_width];
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) rows[lane] = &state[cluster.at(lane)].x;
    transpose(rows, columns);
}

/// The way back, for the particles that the cluster has.
template <class State>
WETDECK_INLINE void store_columns(Pack (&columns)[pack_width], State* state, const Cluster& cluster) {
    double* rows[cluster_width];
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) rows[lane] = &state[cluster.at(lane)].x;
    if (cluster.count < cluster_width) {  // lanes beyond hold the last particle, too
        for (Pack& column : columns)
            for (std::uint32_t lane = cluster.count; lane < cluster_width; ++lane)
                column.lanes[lane] = column.lanes[cluster.count - 1];
    }
    transpose(columns, rows);
}

/// One number of each particle of a cluster.
WETDECK_INLINE Pack load(const double* values, const Cluster& cluster) {
    Pack pack;
    if (cluster.count == cluster_width) {
        std::memcpy(&pack.lanes, values + cluster.first, sizeof pack.lanes);
    } else {
        for (std::uint32_t lane = 0; lane < cluster_width; ++lane)
            pack.lanes[lane] = values[cluster.at(lane)];
    }
    return pack;
}

WETDECK_INLINE Lanes load(const FluidState* state, const Cluster& cluster) {
    Pack c[pack_width];
    load_columns(state, cluster, c);
    return {c[0], c[1], c[2], c[3], c[4], c[6], c[7], c[7]};
}

WETDECK_INLINE void store(Pack values, double* out, const Cluster& cluster) {
    if (cluster.count == cluster_width) {
        std::memcpy(out + cluster.first, &values.lanes, sizeof values.lanes);
        return;
    }
    for (std::uint32_t lane = 0; lane < cluster.count; ++lane) out[cluster.first + lane] = values.lanes[lane];
}

/// Geometry of the pairs of a cluster with one neighbour; e points from i to j, e = -(dx, dy) / r.
template <class Number>
struct SeparationOf {
    Number x, y, distance, inverse_distance;
};
using Separation = SeparationOf<Pack>;

/// A particle is in its own list; the smallest distance keeps 1/r finite there, where every other factor is
/// zero.
template <class Eight>
requires std::is_same_v<decltype(Eight::x), Pack> WETDECK_INLINE Separation separation(const Eight& i,
                                                                                       double x, double y) {
    constexpr double least_squared_distance = 1e-60;
    Separation s;
    s.x = i.x - x;
    s.y = i.y - y;
    const Pack squared = s.x * s.x + (s.y * s.y + least_squared_distance);
    square_roots(squared, s.distance, s.inverse_distance);
    return s;
}

/// Neighbours as they stand in memory, one after the other.
template <class State>
struct OneByOne {
    struct Iterator {
        const State* states;
        const std::uint32_t* index;

        WETDECK_INLINE const State& operator*() const { return states[*index]; }
        WETDECK_INLINE void operator++() { ++index; }
        WETDECK_INLINE bool operator!=(const Iterator& other) const { return index != other.index; }
    };
    const State* states;
    Neighbours neighbours;

    WETDECK_INLINE Iterator begin() const { return {states, neighbours.data()}; }
    WETDECK_INLINE Iterator end() const { return {states, neighbours.data() + neighbours.size()}; }
};

/// Pairs of fluid particles in double precision. InMixed (mixed_lanes.hpp) has the same members.
struct InDouble {
    using Number = Pack;  ///< what a pair computes with
    using Fluid = Lanes;  ///< a cluster
    static WETDECK_INLINE Fluid load(const PassInput& in, const Cluster& cluster) {
        return WETDECK_ISA::load(in.fluid, cluster);
    }
    /// The cluster for its pairs with walls, which are in double precision.
    static WETDECK_INLINE const Lanes& beside_walls(const PassInput&, const Cluster&, const Fluid& fluid) {
        return fluid;
    }
    static WETDECK_INLINE OneByOne<FluidState> each(const PassInput& in, Neighbours neighbours) {
        return {in.fluid, neighbours};
    }
    /// Of separations [m].
    static constexpr double unit_of_length(const PassInput&) { return 1; }
    /// A sum, or a number of the cluster, in double precision.
    static WETDECK_INLINE Pack total(Number sum) { return sum; }
    static WETDECK_INLINE Pack of_cluster(Number number) { return number; }
};

/// Eight boundary particles, one per lane.
struct WallLanes {
    Pack x, y, vx, vy, nx, ny, relative_x, relative_y;  ///< relative: acceleration less gravity
    Pack fineness;                                      ///< the finest spacing over its own
};

WETDECK_INLINE WallLanes load(const PassInput& in, const Cluster& cluster) {
    Pack c[pack_width];
    load_columns(in.wall, cluster, c);
    return {c[0],
            c[1],
            c[2],
            c[3],
            c[4],
            c[5],
            c[6] - in.gravity.x(),
            c[7] - in.gravity.y(),
            load(in.wall_fineness, cluster)};
}

template <class Number>
struct VectorSumOf {
    Number x = 0.0, y = 0.0;
};
using VectorSum = VectorSumOf<Pack>;

}  // namespace wetdeck::WETDECK_ISA

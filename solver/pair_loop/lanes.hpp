// SPDX-License-Identifier: BSD-3-Clause
// A cluster in registers, one particle a lane, and its geometry with one neighbour. Included only by the
// translation units that are compiled once per instruction set.
#pragma once

#include <algorithm>

#include "solver/pair_loop/pack.hpp"
#include "solver/pair_loop/pair_loop.hpp"

namespace wetdeck::WETDECK_ISA {

/// The particles of a cluster, one per lane. Lanes beyond its count hold particles that are computed and not
/// stored.
struct Lanes {
    Pack x, y, vx, vy, pressure, density, impact;
};

WETDECK_INLINE Lanes load(const FluidState* state, std::uint32_t first, std::uint32_t count) {
    Lanes lanes;
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
        const FluidState& particle = state[first + std::min(lane, count - 1)];
        lanes.x.lanes[lane] = particle.x;
        lanes.y.lanes[lane] = particle.y;
        lanes.vx.lanes[lane] = particle.vx;
        lanes.vy.lanes[lane] = particle.vy;
        lanes.pressure.lanes[lane] = particle.pressure;
        lanes.density.lanes[lane] = particle.density;
        lanes.impact.lanes[lane] = particle.impact;
    }
    return lanes;
}

WETDECK_INLINE void store(Pack values, double* out, const Cluster& cluster) {
    for (std::uint32_t lane = 0; lane < cluster.count; ++lane) out[cluster.first + lane] = values.lanes[lane];
}

/// Geometry of the pairs of a cluster with one neighbour; e points from i to j, e = -(dx, dy) / r.
struct Separation {
    Pack x, y, distance, inverse_distance;
};

/// A particle meets itself in its own list; the smallest distance keeps 1/r finite there, where all else is
/// zero.
template <class Eight>
WETDECK_INLINE Separation separation(const Eight& i, double x, double y) {
    constexpr double least_squared_distance = 1e-60;
    Separation s;
    s.x = i.x - x;
    s.y = i.y - y;
    const Pack squared = s.x * s.x + (s.y * s.y + least_squared_distance);
    s.inverse_distance = inverse_sqrt(squared);
    s.distance = squared * s.inverse_distance;
    return s;
}

/// Eight boundary particles, likewise.
struct WallLanes {
    Pack x, y, vx, vy, nx, ny, drive_x, drive_y;  ///< drive: acceleration less gravity
};

WETDECK_INLINE WallLanes load(const PassInput& in, const Cluster& cluster) {
    WallLanes w;
    for (std::uint32_t lane = 0; lane < cluster_width; ++lane) {
        const WallState& particle = in.wall[cluster.first + std::min(lane, cluster.count - 1)];
        w.x.lanes[lane] = particle.x;
        w.y.lanes[lane] = particle.y;
        w.vx.lanes[lane] = particle.vx;
        w.vy.lanes[lane] = particle.vy;
        w.nx.lanes[lane] = particle.nx;
        w.ny.lanes[lane] = particle.ny;
        w.drive_x.lanes[lane] = particle.ax - in.gravity.x();
        w.drive_y.lanes[lane] = particle.ay - in.gravity.y();
    }
    return w;
}

struct VectorSum {
    Pack x = 0.0, y = 0.0;
};

}  // namespace wetdeck::WETDECK_ISA

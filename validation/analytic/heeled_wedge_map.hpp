// SPDX-License-Identifier: BSD-3-Clause
// Conformal map of the self-similar flow around a wedge with two different faces: free surfaces and faces
// (equations at the head of heeled_wedge_map.cpp).
#pragma once

#include <Eigen/Core>
#include <array>

#include "validation/analytic/log_grid.hpp"

namespace wetdeck {

/// Left (0) and right (1); what belongs to one side is seen in a frame whose x points away from the wedge.
constexpr std::array<int, 2> both_sides{0, 1};

/// The four numbers that the map has besides the shape of its free surfaces.
struct HeeledMapParameters {
    double apex = 0;                        ///< image of the apex, between the tips at -1 and 1
    double still = 0;                       ///< where the acceleration vanishes, between the tips
    std::array<double, 2> contact_angle{};  ///< rad
};

/// One free surface, from the tip of the jet outwards; index: node in log r, r the distance from the tip in
/// the plane of the map.
struct HeeledSurface {
    Eigen::ArrayXd turn_rate;    ///< d(delta)/d(log r)
    Eigen::ArrayXd length;       ///< s, from the tip
    Eigen::ArrayXd length_rate;  ///< ds/d(log r)
    Eigen::ArrayXd slope;        ///< delta, 0 far out, in the frame of the side
    double strength = 0;         ///< K that gives the surface its total turn
    double outer_x = 0;          ///< far out: x minus s, counted from the tip
    double outer_z = 0;          ///< far out: z, counted from the tip
};

/// One face in eta = log(distance from the tip/distance from the apex), in the plane of the map, from the tip
/// to the apex.
struct HeeledFace {
    Eigen::ArrayXd length_rate;    ///< |dz/d(eta)|
    Eigen::ArrayXd velocity_rate;  ///< -dU/d(eta) of the velocity U along the face, for strength 1
    double length = 0;
};

/// The free surfaces of two faces for given parameters, by iteration.
class HeeledWedgeMap {
  public:
    /// Deadrise [rad] left and right; step of the logarithmic grids.
    HeeledWedgeMap(std::array<double, 2> deadrise, double step);

    /// Finds the free surfaces, beginning with the last ones found. Throws std::runtime_error.
    void solve(const HeeledMapParameters& parameters);

    const HeeledSurface& surface(int side) const { return surfaces_[static_cast<std::size_t>(side)]; }
    const HeeledMapParameters& parameters() const { return parameters_; }
    double step() const { return step_; }
    double far_distance() const { return 1 + r_(r_.size() - 1); }  ///< |zeta| of the last node of a surface
    HeeledFace face(int side) const;

    /// Free surfaces of another map to begin with; its step may be another one.
    void begin_with(const HeeledWedgeMap& other);

  private:
    Eigen::ArrayXd update(int side);

    std::array<double, 2> deadrise_;
    double step_;
    HeeledMapParameters parameters_;
    std::array<HeeledSurface, 2> surfaces_;
    Eigen::ArrayXd l_, r_;
    LogKernel kernel_;
    Eigen::MatrixXd across_;
};

}  // namespace wetdeck

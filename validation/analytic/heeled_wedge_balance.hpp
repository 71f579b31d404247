// SPDX-License-Identifier: BSD-3-Clause
// Flow along the faces of a heeled wedge, and the loads on it from the momentum of the water.
#pragma once

#include <Eigen/Core>
#include <array>

#include "validation/analytic/heeled_wedge_map.hpp"

namespace wetdeck {

/// Along a face from the tip to the apex, in units of rho, V and V t.
struct HeeledFaceFlow {
    double step = 0;                   ///< of the grid
    Eigen::ArrayXd length_rate;        ///< d(length)/d(node coordinate)
    Eigen::ArrayXd length;             ///< from the tip
    Eigen::ArrayXd relative_velocity;  ///< U - z, positive towards the tip
    Eigen::ArrayXd relative_integral;  ///< of the relative velocity over the length, from the tip
    Eigen::ArrayXd pressure;           ///< over rho V^2
    double wetted_length = 0;
    double relative_potential = 0;  ///< relative_integral at the apex
};

/// Loads on the wedge over rho V^3 t and rho V^4 t^2.
struct HeeledMomentumLoads {
    double force_x = 0, force_y = 0;
    double moment = 0;  ///< about the point of first contact, counterclockwise positive
};

std::array<HeeledFaceFlow, 2> heeled_face_flows(const HeeledWedgeMap& map,
                                                const std::array<double, 2>& deadrise);

/// Rate of change of momentum and angular momentum of the water inside a large half circle.
HeeledMomentumLoads heeled_momentum_loads(const HeeledWedgeMap& map, const std::array<double, 2>& deadrise,
                                          const std::array<HeeledFaceFlow, 2>& flow);

}  // namespace wetdeck

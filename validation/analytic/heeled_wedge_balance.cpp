// SPDX-License-Identifier: BSD-3-Clause
// Flow along the faces of a heeled wedge, and the loads on it from the momentum of the water.
//
// Far away the potential is that of a dipole, D t^2 z/r^2, and the elevation D t^3/(3 x^2). Momentum of the
// water inside a large half circle, turned by Green's formula into the displaced first moments of area,
//     F_z = 2 pi D - 3 (integral of z^2 dx),   F_x = -6 (integral of x z dx),
// over faces and free surface from left to right. Angular momentum about the point of first contact:
//     M = -3 (integral of phi d(r^2/2)),   phi = (r^2 - |U - z|^2)/2 - p
// (all for t = 1, from Bernoulli's equation in the similarity frame).
#include "validation/analytic/heeled_wedge_balance.hpp"

#include <cmath>
#include <numbers>

namespace wetdeck {
namespace {

using Eigen::ArrayXd;
using std::numbers::pi;

struct Point {
    double x, z;
};

/// From a tip on, along a unit vector.
struct Line {
    Point tip, along;
    double length;
};

/// Of f(point, distance from the tip) over the length, exact for cubic polynomials.
template <typename Function>
double integral(const Line& line, const Function& f) {
    const auto at = [&](double l) {
        return f(Point{line.tip.x + l * line.along.x, line.tip.z + l * line.along.z}, l);
    };
    return line.length / 6 * (at(0) + 4 * at(line.length / 2) + at(line.length));
}

double depth_of_apex(const HeeledWedgeMap& map, const std::array<double, 2>& deadrise, double length,
                     int side) {
    return map.surface(side).outer_z + length * std::sin(deadrise[static_cast<std::size_t>(side)]);
}

}  // namespace

std::array<HeeledFaceFlow, 2> heeled_face_flows(const HeeledWedgeMap& map,
                                                const std::array<double, 2>& deadrise) {
    const std::array<HeeledFace, 2> faces{map.face(0), map.face(1)};
    const double strength = std::sqrt(map.surface(0).strength * map.surface(1).strength), h = map.step();
    const double unit = (depth_of_apex(map, deadrise, faces[0].length, 0) +
                         depth_of_apex(map, deadrise, faces[1].length, 1)) /
                        2;
    std::array<HeeledFaceFlow, 2> flows;
    for (const int side : both_sides) {
        const auto k = static_cast<std::size_t>(side);
        HeeledFaceFlow& flow = flows[k];
        const double power = map.parameters().contact_angle[k] / pi;  // of the length at the tip
        flow.step = h;
        flow.length_rate = faces[k].length_rate / unit;
        const ArrayXd velocity_rate = strength / unit * faces[k].velocity_rate;
        flow.length = running_integral(flow.length_rate, h, flow.length_rate(0) / power);
        flow.wetted_length = faces[k].length / unit;
        flow.relative_velocity =
            flow.length - running_integral(velocity_rate, h, velocity_rate(0) / (0.5 - power));
        flow.relative_integral = running_integral(flow.relative_velocity * flow.length_rate, h,
                                                  0.5 * flow.length(0) * flow.length(0));
        flow.pressure = flow.relative_integral - 0.5 * flow.relative_velocity.square();
        flow.relative_potential = flow.relative_integral(flow.relative_integral.size() - 1);
    }
    return flows;
}

HeeledMomentumLoads heeled_momentum_loads(const HeeledWedgeMap& map, const std::array<double, 2>& deadrise,
                                          const std::array<HeeledFaceFlow, 2>& flow) {
    const double h = map.step();
    double dipole = 0, area_x = 0, area_z = 0, angular = 0;
    for (const int side : both_sides) {
        const auto k = static_cast<std::size_t>(side);
        const HeeledSurface& surface = map.surface(side);
        const double unit = map.face(side).length / flow[k].wetted_length, outwards = side == 0 ? -1 : 1;

        // Free surface in the frame of its side, counted from outside inwards: x - s and z are small there.
        const ArrayXd s = surface.length / unit, s_l = surface.length_rate / unit;
        const auto from_outside = [&](const ArrayXd& rate, double power) -> ArrayXd {
            const ArrayXd inwards = rate.reverse();
            return -running_integral(inwards, h, inwards(0) / power).reverse();
        };
        const ArrayXd lag = from_outside(-2 * (0.5 * surface.slope).sin().square() * s_l, 5);  // x - s
        const ArrayXd z = from_outside(surface.slope.sin() * s_l, 2);
        const ArrayXd x = s + lag, x_l = surface.slope.cos() * s_l, z_l = surface.slope.sin() * s_l;
        const double cosine = std::cos(deadrise[k]), sine = std::sin(deadrise[k]);
        const Point along_surface{x_l(0) / s_l(0), z_l(0) / s_l(0)}, along_face{-cosine, -sine};
        const Point tip{x(0) - along_surface.x * s(0), z(0) - along_surface.z * s(0)};

        const auto sum = [h](const ArrayXd& rate) { return h * (rate.sum() - 0.5 * rate(0)); };
        const auto xz = [](const Point& p, double) { return p.x * p.z; };
        const auto zz = [](const Point& p, double) { return p.z * p.z; };
        // phi d(r^2/2)/dl at the distance l from the tip, on the thin jet beyond the first node.
        const auto turning = [](const Point& along) {
            return [along](const Point& p, double l) {
                return 0.5 * (p.x * p.x + p.z * p.z - l * l) * (p.x * along.x + p.z * along.z);
            };
        };
        const Line surface_jet{tip, along_surface, s(0)}, face_jet{tip, along_face, flow[k].length(0)};
        const Line whole_face{tip, along_face, flow[k].wetted_length};

        area_x += outwards * (sum(x * z * x_l) + along_surface.x * integral(surface_jet, xz) +
                              cosine * integral(whole_face, xz));
        area_z += sum(z.square() * x_l) + along_surface.x * integral(surface_jet, zz) +
                  cosine * integral(whole_face, zz);
        const ArrayXd face_x = tip.x - flow[k].length * cosine, face_z = tip.z - flow[k].length * sine;
        const ArrayXd potential = 0.5 * (face_x.square() + face_z.square()) - flow[k].relative_integral;
        angular += outwards * (sum(0.5 * (lag * (x + s) + z.square()) * (x * x_l + z * z_l)) +
                               integral(surface_jet, turning(along_surface)) +
                               sum(potential * (face_x * cosine + face_z * sine) * flow[k].length_rate) -
                               integral(face_jet, turning(along_face)));
        const double stretch = s_l(s_l.size() - 1) / map.far_distance();  // |dz/d zeta| far out
        dipole += 0.25 * surface.strength / (unit * unit) * stretch;
    }
    return {-6 * area_x, 2 * pi * dipole - 3 * area_z, -3 * angular};
}

}  // namespace wetdeck

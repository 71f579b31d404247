// SPDX-License-Identifier: BSD-3-Clause
#include "solver/bodies/flow.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace wetdeck {

void measure_bodies(Flow& flow, double added_mass, Vec2 gravity) {
    for (RigidBody& body : flow.bodies) body.radius = body.added_mass = body.added_inertia = 0;
    for (std::size_t n = flow.walls.fixed; n < flow.walls.size(); ++n) {
        const BodyPoint& point = flow.walls.body_point[n];
        const RigidBody& own = flow.bodies.at(point.body);
        const Vec2 place(point.x, point.y);
        RigidBody& body = flow.bodies[own.joined_to.value_or(point.body)];  // that carries it
        const Vec2 at = own.joined_to ? Vec2(own.joint + Eigen::Rotation2Dd(own.joint_angle) * place) : place;
        body.radius = std::max(body.radius, at.norm());
        body.added_mass += added_mass;
        body.added_inertia += added_mass * (at - body.guide.pivot.value_or(Vec2::Zero())).squaredNorm();
    }
    for (RigidBody& body : flow.bodies) {
        for (int k = 0; k < 2; ++k) {
            if (body.forced(k) && body.added_mass > body.mass) body.acceleration[k] = gravity[k];
        }
    }
}

void sum_own_kernels(WallParticles& walls, const WendlandC2& kernel, double volume) {
    struct Point {
        std::size_t owner;  // 0: the tank
        Vec2 position;
        double fineness;
        std::size_t index;
    };
    std::vector<Point> points;
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const BodyPoint& p = walls.body_point[n];
        if (n < walls.fixed) {
            points.push_back({0, {walls.state[n].x, walls.state[n].y}, walls.fineness[n], n});
        } else {
            points.push_back({std::size_t{p.body} + 1, {p.x, p.y}, walls.fineness[n], n});
        }
    }
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return std::tuple(a.owner, a.position.x(), a.index) < std::tuple(b.owner, b.position.x(), b.index);
    });
    walls.own_sum.assign(walls.size(), volume * kernel.value(0));
    double coarsest = 1;
    for (const double fineness : walls.fineness) coarsest = std::max(coarsest, 1 / fineness);
    for (auto a = points.begin(); a != points.end(); ++a) {
        for (auto b = a + 1; b != points.end() && b->owner == a->owner; ++b) {
            if (b->position.x() - a->position.x() >= coarsest * kernel.support_radius()) break;
            const double of_pair = 0.5 * (a->fineness + b->fineness);
            const double share = volume * WendlandC2{kernel.smoothing_length / of_pair}.value(
                                              (b->position - a->position).norm());
            walls.own_sum[a->index] += share / (b->fineness * b->fineness);
            walls.own_sum[b->index] += share / (a->fineness * a->fineness);
        }
    }
    for (double& sum : walls.own_sum) sum = std::min(sum, 1.0);  // rounding of the lattice
}

void join_bodies(Flow& flow) {
    for (std::size_t b = 0; b < flow.bodies.size(); ++b) {
        RigidBody& body = flow.bodies[b];
        if (!body.joined_to) continue;
        if (*body.joined_to >= b || flow.bodies[*body.joined_to].joined_to)
            throw std::out_of_range("a body is joined to none before it");
        const RigidBody& carrier = flow.bodies[*body.joined_to];
        body.joint = carrier.local(body.position);
        body.joint_angle = body.angle - carrier.angle;
    }
}

void carry_joined_bodies(std::vector<RigidBody>& bodies) {
    for (RigidBody& body : bodies) {
        if (!body.joined_to) continue;
        const RigidBody& carrier = bodies[*body.joined_to];
        body.position = carrier.placed(body.joint);
        body.angle = carrier.angle + body.joint_angle;
        const Vec2 arm = body.position - carrier.position;
        body.velocity = carrier.velocity_at(arm);
        body.angular_velocity = carrier.angular_velocity;
        body.acceleration = carrier.acceleration_at(arm);
        body.angular_acceleration = carrier.angular_acceleration;
    }
}

void place_walls(Flow& flow, Vec2 gravity) {
    carry_joined_bodies(flow.bodies);
    WallParticles& walls = flow.walls;
    const bool tank_moves = flow.tank_motion.moves();
    FrameForces frame;
    if (tank_moves) frame = flow.tank_motion.forces(flow.time, gravity);
    for (std::size_t n = 0; tank_moves && n < walls.fixed; ++n) {
        WallState& wall = walls.state[n];
        const Vec2 force = frame.at({wall.x, wall.y}, Vec2::Zero());
        wall.ax = -force.x();
        wall.ay = -force.y();
    }
    for (std::size_t b = 0; b < flow.bodies.size(); ++b) {
        const RigidBody& body = flow.bodies[b];
        const Eigen::Matrix2d axes = body.axes();
        for (std::size_t n = walls.fixed; n < walls.size(); ++n) {
            const BodyPoint& point = walls.body_point[n];
            if (point.body != b) continue;
            const Vec2 arm = axes * Vec2(point.x, point.y), normal = axes * Vec2(point.nx, point.ny);
            const Vec2 position = body.position + arm, velocity = body.velocity_at(arm);
            Vec2 acceleration = body.acceleration_at(arm);
            if (tank_moves) acceleration -= frame.at(position, velocity);
            walls.state[n] = {position.x(), position.y(), velocity.x(),     velocity.y(),
                              normal.x(),   normal.y(),   acceleration.x(), acceleration.y()};
        }
    }
}

BodyLoad load_on(const Flow& flow, std::size_t body) {
    const WallParticles& walls = flow.walls;
    BodyLoad load;
    for (std::size_t n = walls.fixed; n < walls.size(); ++n) {
        if (walls.body_point[n].body != body) continue;
        const Vec2 force(walls.force_x[n], walls.force_y[n]);
        const Vec2 arm = Vec2(walls.state[n].x, walls.state[n].y) - flow.bodies[body].position;
        load.force += force;
        load.torque += arm.x() * force.y() - arm.y() * force.x();
    }
    return load;
}

BodyLoad load_on_both_halves(const Flow& flow, std::size_t body, double plane, double particle_spacing) {
    const WallParticles& walls = flow.walls;
    BodyLoad load;
    for (std::size_t n = walls.fixed; n < walls.size(); ++n) {
        if (walls.body_point[n].body == body)
            load.force.y() +=
                2 * share_of_half(walls.state[n].x - plane, particle_spacing) * walls.force_y[n];
    }
    return load;
}

}  // namespace wetdeck

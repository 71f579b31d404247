// SPDX-License-Identifier: BSD-3-Clause
// The series that a run records, and what follows from them.
#include <fmt/format.h>

#include <algorithm>

#include "solver/probes/energy.hpp"
#include "solver/probes/front.hpp"
#include "solver/probes/pressure.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/run/assemble.hpp"

namespace wetdeck {
namespace {

/// Direction of the side of an outline nearest to a point.
Vec2 side_direction(const Outline& outline, Vec2 point) {
    Vec2 best = Vec2::UnitX();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()];
        const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        const double distance = (a + share * (b - a) - point).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        best = (b - a).normalized();
    }
    return best;
}

/// Points evenly along a face, in the frame of the body's mass centre, each in the middle of its share.
std::vector<Vec2> face_points(const BodySpec& body, const ProbeSpec& spec) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < spec.points; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(spec.points);
        points.push_back(body.in_body_frame(spec.from + share * (spec.to - spec.from)));
    }
    return points;
}

std::vector<double> midpoints(double low, double high, std::size_t count) {
    std::vector<double> middle;
    for (std::size_t k = 0; k < count; ++k)
        middle.push_back(low + (high - low) * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
    return middle;
}

template <class F>
auto scalar(F f) {
    return [f](const Simulation& s, std::vector<double>& out) { out.push_back(f(s)); };
}

template <class F>
auto profile(F f) {
    return [f](const Simulation& s, std::vector<double>& out) {
        const std::vector<double> values = f(s);
        out.insert(out.end(), values.begin(), values.end());
    };
}

/// The mean slope of the curve over the interval of the given width about each of its abscissae; where the
/// curve ends, over the part of it that is there. A width of zero takes the two neighbouring samples.
std::vector<double> mean_slopes(const Curve& curve, double width) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        double begin = curve.x[i == 0 ? 0 : i - 1], end = curve.x[std::min(i + 1, curve.x.size() - 1)];
        begin = std::min(begin, std::max(curve.x.front(), curve.x[i] - 0.5 * width));
        end = std::max(end, std::min(curve.x.back(), curve.x[i] + 0.5 * width));
        const double rise = interpolate(curve, end) - interpolate(curve, begin);
        slopes.push_back(end > begin ? rise / (end - begin) : 0);
    }
    return slopes;
}

}  // namespace

Recorders::Recorders(const Scene& scene, double particle_spacing) {
    for (const ProbeSpec& spec : scene.probes) add_probe(scene, spec, particle_spacing);
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        for (SeriesInfo info : recorded_body_series()) {
            info.name = body_series_name(info.name, body);
            list_.push_back(info);
        }
        probes_.emplace_back([body](const Simulation& s, std::vector<double>& out) {
            const RigidBody& b = s.bodies()[body];  // in the order of recorded_body_series()
            out.insert(out.end(),
                       {b.position.x(), b.position.y(), b.angle, b.velocity.x(), b.velocity.y(),
                        b.angular_velocity, b.impulse.x(), b.impulse.y(), b.angular_impulse, b.work});
        });
    }
    list_.insert(list_.end(), every_run_series().begin(), every_run_series().end());
}

void Recorders::add_probe(const Scene& scene, const ProbeSpec& spec, double particle_spacing) {
    const auto gauge_text = [&spec] {
        return fmt::format("gauge pressure, chord-weighted mean over a disc of {} m at ({}, {}) m; {}",
                           spec.diameter, spec.centre.x(), spec.centre.y(), spec.note);
    };
    using Type = ProbeSpec::Type;
    switch (spec.type) {
        case Type::front:
            list_.push_back({spec.name, "m", "largest x that water reaches"});
            probes_.emplace_back(scalar(front_position));
            break;
        case Type::wall_pressure: {
            const PressureGauge gauge(spec.centre, Vec2::UnitY(), spec.diameter);
            gauge.check(particle_spacing);
            list_.push_back({spec.name, "Pa", gauge_text()});
            probes_.emplace_back(scalar([gauge](const Simulation& s) { return gauge.sample(s); }));
            break;
        }
        case Type::body_pressure: {
            const BodySpec& body = scene.bodies[spec.body];
            const Vec2 along = side_direction(body.outline, body.origin + spec.centre);
            const PressureGauge gauge(body.in_body_frame(spec.centre), along, spec.diameter, spec.body);
            gauge.check(particle_spacing);
            list_.push_back({spec.name, "Pa", gauge_text()});
            probes_.emplace_back(scalar([gauge](const Simulation& s) { return gauge.sample(s); }));
            break;
        }
        case Type::face_pressure: {
            const std::vector<Vec2> points = face_points(scene.bodies[spec.body], spec);
            list_.push_back({spec.name, "Pa",
                             "gauge pressure along a face, by arc length from its first end [m]",
                             midpoints(0, (spec.to - spec.from).norm(), spec.points)});
            probes_.emplace_back(profile([points, body = spec.body](const Simulation& s) {
                std::vector<Vec2> placed;
                for (const Vec2& point : points) placed.push_back(s.bodies()[body].placed(point));
                return face_pressures(s, placed);
            }));
            break;
        }
        case Type::air_film: {
            const BodySpec& body = scene.bodies[spec.body];
            const Vec2 from = body.in_body_frame(spec.from), to = body.in_body_frame(spec.to);
            list_.push_back({spec.name, "m", "gap between the face and the nearest water in front of it"});
            probes_.emplace_back(scalar(
                [=, number = spec.body](const Simulation& s) { return gap_to_water(s, number, from, to); }));
            break;
        }
        case Type::free_surface:
            list_.push_back({spec.name, "m", "height of the highest water, by x [m]; spray counts",
                             midpoints(spec.low, spec.high, spec.points)});
            probes_.emplace_back(profile(
                [spec](const Simulation& s) { return water_top(s, spec.low, spec.high, spec.points); }));
            break;
        case Type::water_depth:
            list_.push_back(
                {spec.name, "m",
                 fmt::format("depth of water at x = {} m over a width of {} m", spec.x, spec.width)});
            probes_.emplace_back(
                scalar([spec](const Simulation& s) { return water_depth(s, spec.x, spec.width); }));
            break;
    }
}

void Recorders::sample(const Simulation& simulation, bool audit, std::vector<double>& values) const {
    const double last_error = values.empty() ? 0 : values.back();
    values.clear();
    for (const auto& probe : probes_) probe(simulation, values);
    const Balance b = balance(simulation);  // in the order of every_run_series()
    values.insert(values.end(),
                  {b.kinetic, b.potential, b.compression, b.momentum.x(), b.momentum.y(), b.mass,
                   b.water_density_error, static_cast<double>(b.outside), simulation.time_step().size,
                   audit ? simulation.momentum_error() : last_error});
}

void add_body_means(const Scene& scene, std::map<std::string, Series>& series) {
    struct Source {
        const char* derived;
        const char* recorded;
        double width;
    };
    const Source sources[] = {{"body_force_x", "body_impulse_x", 0},
                              {"body_force_y", "body_impulse_y", 0},
                              {"body_torque", "body_angular_impulse", 0},
                              {"body_acceleration_x", "body_velocity_x", 0},
                              {"body_acceleration_y", "body_velocity_y", 0},
                              {"body_force_y_filtered", "body_impulse_y", scene.force_filter},
                              {"body_acceleration_y_filtered", "body_velocity_y", scene.force_filter}};
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        for (std::size_t k = 0; k < std::size(sources); ++k) {
            const Series& from = series.at(body_series_name(sources[k].recorded, body));
            const SeriesInfo& info = derived_body_series()[k];
            const double width = std::max(sources[k].width, 2 * scene.sample_interval);
            Series to{info.unit,
                      fmt::format("{}; centred moving mean over {:.4g} ms", info.description, 1e3 * width),
                      from.time,
                      mean_slopes({from.time, from.value}, sources[k].width),
                      {}};
            series[body_series_name(info.name, body)] = std::move(to);
        }
    }
}

}  // namespace wetdeck

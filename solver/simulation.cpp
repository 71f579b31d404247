// SPDX-License-Identifier: BSD-3-Clause
#include "solver/simulation.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/core/errors.hpp"
#include "solver/physics/sponge.hpp"
#include "solver/time/stage_timer.hpp"

namespace wetdeck {
namespace {

/// Densities outside this share of their reference end a run: the state is no fluid any more. Single air
/// particles caught between a plate and water are squeezed to five times theirs before they escape.
constexpr double lowest_density_ratio = 0.2, highest_density_ratio = 10;

bool needs_wall_means(const Model& model) {
    return model.wall_pressure != WallPressure::one_sided || model.wall_velocity == WallVelocity::mirrored;
}

double checked_spacing(double particle_spacing) {
    const bool good = particle_spacing > 0 && std::isfinite(particle_spacing);
    if (!good) throw InputError("particle_spacing must be positive");
    return particle_spacing;
}

}  // namespace

Simulation::Simulation(const Model& model, FluidParticles fluid, WallParticles walls, double particle_spacing,
                       Box domain, std::vector<RigidBody> bodies)
    : model_(model),
      fluid_(std::move(fluid)),
      walls_(std::move(walls)),
      bodies_(std::move(bodies)),
      body_radii_(bodies_.size(), 0),
      particle_spacing_(checked_spacing(particle_spacing)),
      domain_(domain),
      kernel_{model.smoothing_ratio * particle_spacing},
      threads_(model.threads > 0 ? model.threads : omp_get_max_threads()),
      loops_(pair_loops(model)),
      list_(domain, particle_spacing, kernel_.support_radius(), model.skin * kernel_.smoothing_length,
            needs_wall_means(model) || !bodies_.empty(), model.periodic_x) {
    for (const BodyPoint& point : walls_.body_point) {
        double& radius = body_radii_.at(point.body);
        radius = std::max(radius, std::hypot(point.x, point.y));
    }
    attach_fluid();
    for (const RigidBody& body : bodies_) body.check();
    if (fluid_.size() == 0) throw InputError("a simulation needs fluid particles");
    if (model_.periodic_x && (!bodies_.empty() || model_.sponge_thickness > 0))
        throw InputError("a periodic domain can have neither bodies nor a sponge layer");
    const double h = kernel_.smoothing_length;
    for (std::size_t i = 0; i < phase_count; ++i) {
        for (std::size_t j = 0; j < phase_count; ++j) {
            coefficients_.pair[i][j] = pair_coefficients(model_, Phase(i), Phase(j), h);
        }
        coefficients_.wall_pair[i] = wall_coefficients(model_, Phase(i), h);
    }
    const bool both = fluid_.water > 0 && fluid_.water < fluid_.size();
    model_.air_substeps = both ? air_substeps(model_) : 1;
    coefficients_.kernel = kernel_;
    coefficients_.gravity = model_.gravity;
    coefficients_.wall_volume = particle_spacing * particle_spacing;
    coefficients_.velocity_guard = 1e-12 * model_.water.eos.sound_speed;
    coefficients_.pressure_guard = 1e-12 * model_.water.eos.coefficient();
    coefficients_.particle_spacing = particle_spacing;
    coefficients_.reference_density = {model_.water.eos.reference_density, model_.air.eos.reference_density};
    coefficients_.threads = threads_;
    coefficients_.wall_pressure_mean = {model_.wall_pressure != WallPressure::one_sided,
                                        model_.wall_pressure == WallPressure::shepard};
    coefficients_.fixed_walls = walls_.fixed;
    list_.place_fixed(walls_);
    advance_fluid(0);
    built_bodies_ = bodies_;
    place_bodies();
    build_list();
    evaluate();
}

PassInput Simulation::pass_input() {
    PassInput in = inputs();
    in.new_wall_mean = walls_.mean.data();
    in.density_rate = fluid_.density_rate.data();
    in.water_weight = water_weight_;
    if (water_weight_ == 0) in.shares = &list_.air_shares();
    if (model_.full_cover > 0 && water_weight_ > 0) in.cover = fluid_.cover.data();
    in.acceleration_x = fluid_.acceleration_x.data();
    in.acceleration_y = fluid_.acceleration_y.data();
    in.wall_force_x = walls_.force_x.data();
    in.wall_force_y = walls_.force_y.data();
    return in;
}

void Simulation::build_list() {
    list_.build(fluid_, walls_, loops_, threads_);
    built_bodies_ = bodies_;
    // particles that no fluid is near are left out of the list
    std::fill(walls_.force_x.begin(), walls_.force_x.end(), 0.0);
    std::fill(walls_.force_y.begin(), walls_.force_y.end(), 0.0);
    ++list_builds_;
    water_near_air_ = 0;
    for (const Cluster& cluster : list_.clusters())
        if (cluster.phase == Phase::water && cluster.fluid_neighbours[1] > 0)
            water_near_air_ += cluster.count;
}

void Simulation::density_pass() {
    const StageTimer timer(stages_.density);
    loops_.density_rates(pass_input());
    if (model_.sponge_thickness > 0) soak({&fluid_.density_rate});
}

void Simulation::wall_pass() {
    const bool for_air = model_.wall_pressure == WallPressure::shepard;
    if (!needs_wall_means(model_) || (water_weight_ == 0 && !for_air)) return;
    const StageTimer timer(stages_.walls);
    loops_.wall_means(pass_input());
}

void Simulation::momentum_pass() {
    const StageTimer timer(stages_.momentum);
    loops_.accelerations(pass_input());
    if (model_.central_frequency > 0) {
        const double stiffness = model_.central_frequency * model_.central_frequency;
        for (std::size_t i = 0; i < fluid_.size(); ++i) {
            const double pull = (i < fluid_.water ? water_weight_ : 1) * stiffness;
            fluid_.acceleration_x[i] -= pull * fluid_.state[i].x;
            fluid_.acceleration_y[i] -= pull * fluid_.state[i].y;
        }
    }
    if (model_.sponge_thickness > 0) soak({&fluid_.acceleration_x, &fluid_.acceleration_y});
}

/// The sponge layer's factor on rates, Eqs. (24)-(25).
void Simulation::soak(std::initializer_list<std::vector<double>*> rates) {
    for (std::size_t i = 0; i < fluid_.size(); ++i) {
        const double distance = distance_to_wall(domain_, fluid_.state[i].x, fluid_.state[i].y);
        if (distance >= model_.sponge_thickness) continue;
        const double factor = sponge_factor(distance, model_.sponge_thickness);
        for (std::vector<double>* rate : rates) (*rate)[i] *= factor;
    }
}

/// Densities from their rates over a step, volumes and pressures, and the second half drift.
void Simulation::advance_fluid(double dt) {
    const auto advance = [&](Phase phase, std::size_t first, std::size_t last) {
        const bool water = phase == Phase::water;
        const TaitEquationOfState& eos = water ? model_.water.eos : model_.air.eos;
        DensityBounds bounds;
        bounds.lowest = (water && !model_.tension ? 1 : lowest_density_ratio) * eos.reference_density;
        if (dt > 0 && water && model_.full_cover > 0 && water_weight_ > 0) bounds.cover = fluid_.cover.data();
        bounds.full_cover = model_.full_cover;
        const double weight = model_.gravity.norm() * particle_spacing_;
        bounds.open = eos.reference_density * (1 + weight / (eos.sound_speed * eos.sound_speed));
        loops_.advance_fluid(fluid_.state.data(), fluid_.density_rate.data(), fluid_.mass.data(), first, last,
                             dt, eos, bounds, threads_);
    };
    advance(Phase::water, 0, fluid_.water);
    advance(Phase::air, fluid_.water, fluid_.size());
}

void Simulation::evaluate() {
    water_weight_ = model_.air_substeps;
    fastest_ = {};
    densest_ = {1, 1};
    for (std::size_t i = 0; i < fluid_.size(); ++i) {
        const auto phase = static_cast<std::size_t>(fluid_.phase(i));
        const Material& material = phase == 0 ? model_.water : model_.air;
        fastest_[phase] = std::max(fastest_[phase], fluid_.state[i].velocity().norm());
        densest_[phase] = std::max(densest_[phase], fluid_.state[i].density / material.eos.reference_density);
    }
    wall_pass();
    density_pass();
    momentum_pass();
    load_bodies();
    time_step_ = stable_step();
}

/// Eq. (26) with the sound speed of the most compressed fluid, c = c0 (rho/rho0)^((gamma - 1)/2): trapped air
/// squeezed to two thirds dies at the speed of the reference state.
TimeStep Simulation::stable_step() const {
    std::array<double, phase_count> fastest = fastest_;
    const TaitEquationOfState* laws[] = {&model_.water.eos, &model_.air.eos};
    for (std::size_t phase = 0; phase < phase_count; ++phase) {
        const double stiffened = std::pow(densest_[phase], 0.5 * (laws[phase]->exponent - 1));
        fastest[phase] += laws[phase]->sound_speed * (stiffened - 1);
    }
    return stable_time_step(model_, kernel_.smoothing_length, fastest, fluid_.water > 0,
                            fluid_.water < fluid_.size());
}

/// The pressure convection rate grad(p).v from the momentum equation itself: grad(p) = -rho (dv/dt - g), Eq.
/// (15).
void Simulation::mark_impacts() {
    const StageTimer timer(stages_.integration);
    const double fastest = std::max(fastest_[0], fastest_[1]);
    const double g = model_.gravity.norm();
    const auto size = static_cast<std::int64_t>(fluid_.size());
#pragma omp parallel for schedule(static) num_threads(threads_)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        FluidState& p = fluid_.state[i];
        const double rate = -p.density * ((fluid_.acceleration_x[i] - model_.gravity.x()) * p.vx +
                                          (fluid_.acceleration_y[i] - model_.gravity.y()) * p.vy);
        p.impact = rate > p.density * g * fastest ? 1 : 0;
    }
}

/// The first half kick and half drift of all fluid and the bodies. Returns how far the fastest particle has
/// moved; it moves as far in the second half.
double Simulation::kick_and_drift(double half) {
    const StageTimer timer(stages_.integration);
    double fastest2 = 0;
    const auto size = static_cast<std::int64_t>(fluid_.size());
#pragma omp parallel for schedule(static) num_threads(threads_) reduction(max : fastest2)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        FluidState& p = fluid_.state[i];
        p.vx += half * fluid_.acceleration_x[i];
        p.vy += half * fluid_.acceleration_y[i];
        p.x += half * p.vx;
        p.y += half * p.vy;
        fastest2 = std::max(fastest2, p.vx * p.vx + p.vy * p.vy);
    }
    double fastest = std::sqrt(fastest2);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        RigidBody& body = bodies_[b];
        body.kick(half, water_weight_);
        body.drift(half);
        fastest = std::max(fastest, body.fastest_within(body_radii_[b]));
    }
    place_bodies();
    return half * fastest;
}

/// The second half drift, with the densities at the end of the step.
void Simulation::advance_and_drift(double dt) {
    const StageTimer timer(stages_.integration);
    advance_fluid(dt);
    for (RigidBody& body : bodies_) body.drift(0.5 * dt);
    place_bodies();
}

/// Builds the list if particles that have moved by `farthest` may have made it incomplete.
void Simulation::refresh_list(double farthest) {
    const StageTimer timer(stages_.neighbours);
    if (!list_.still_complete(farthest, fluid_, walls_, threads_)) build_list();
}

/// The last half kick; finds the largest speeds and whether anything has left its range (rates too: the floor
/// below the densities would hide what is no number; after a new list they stand in the old order, and
/// another particle may be named).
std::optional<Instability> Simulation::last_kick(double dt) {
    const StageTimer timer(stages_.integration);
    const auto size = static_cast<std::int64_t>(fluid_.size());
    double fastest_water = 0, fastest_air = 0, densest_water = 1, densest_air = 1;
    std::int64_t first_bad = size;
    const Vec2 margin = Vec2::Constant(kernel_.support_radius());
    const Vec2 low = domain_.low - margin, high = domain_.high + margin;
    const double densities[] = {model_.water.eos.reference_density, model_.air.eos.reference_density};
    const double speeds[] = {highest_mach_number * model_.water.eos.sound_speed,
                             highest_mach_number * model_.air.eos.sound_speed};
    for (RigidBody& body : bodies_) body.kick(0.5 * dt, water_weight_);
#pragma omp parallel for schedule(static) num_threads(threads_)                       \
    reduction(max                                                                     \
              : fastest_water, fastest_air, densest_water, densest_air) reduction(min \
                                                                                  : first_bad)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        FluidState& p = fluid_.state[i];
        p.vx += 0.5 * dt * fluid_.acceleration_x[i];
        p.vy += 0.5 * dt * fluid_.acceleration_y[i];
        const double speed2 = p.vx * p.vx + p.vy * p.vy;
        const bool water = i < fluid_.water;
        double& fastest = water ? fastest_water : fastest_air;
        fastest = std::max(fastest, speed2);
        const double ratio = p.density / densities[water ? 0 : 1];
        double& densest = water ? densest_water : densest_air;
        densest = std::max(densest, ratio);
        const bool good = fluid_.density_rate[i] == fluid_.density_rate[i] && ratio > lowest_density_ratio &&
                          ratio < highest_density_ratio &&
                          speed2 < speeds[water ? 0 : 1] * speeds[water ? 0 : 1] && p.x > low.x() &&
                          p.y > low.y() && p.x < high.x() && p.y < high.y();
        if (!good) first_bad = std::min(first_bad, n);
    }
    fastest_ = {std::sqrt(fastest_water), std::sqrt(fastest_air)};
    densest_ = {densest_water, densest_air};
    if (first_bad == size) return body_trouble();
    const auto i = static_cast<std::size_t>(first_bad);
    const FluidState& bad = fluid_.state[i];
    const bool escaped = (bad.position() - low).minCoeff() <= 0 || (high - bad.position()).minCoeff() <= 0;
    char text[160];
    std::snprintf(text, sizeof text, "%s density %.4g kg/m3 and speed %.4g m/s %s",
                  i < fluid_.water ? "water" : "air", bad.density, bad.velocity().norm(),
                  escaped ? "escaped from the tank" : "left the range of a fluid");
    return Instability{time_, steps_ + 1, fluid_.id[i], fluid_.state[i].position(), text};
}

std::optional<Instability> Simulation::step(double longest) {
    const TimeStep stable = stable_step();
    time_step_ = stable;
    const double begin = time_, whole = std::min(longest, stable.size);
    if (model_.dissipation_switch) mark_impacts();
    std::optional<Instability> trouble;
    const int all = model_.air_substeps;
    for (int k = 0; k < all && !trouble; ++k) trouble = substep(whole / all, k);
    if (!trouble) time_ = begin + whole;  // not a sum, which might end just before the end
    ++steps_;
    ++limits_[static_cast<std::size_t>(stable.criterion)];
    return trouble;
}

/// A step of the air, this number of those in one of the water. What acts on water alone pushes it in the
/// first and the last of them and compresses it in the middle one, each time for all of them: between two
/// passes the rates of the last one, with its weight, are in force.
std::optional<Instability> Simulation::substep(double dt, int number) {
    const int all = model_.air_substeps;
    const bool middle = number == all / 2, last = number == all - 1;
    const double moved = kick_and_drift(0.5 * dt);
    refresh_list(moved);
    water_weight_ = middle ? all : 0;
    if (model_.wall_velocity == WallVelocity::mirrored && middle) wall_pass();
    density_pass();
    advance_and_drift(dt);
    refresh_list(moved);
    water_weight_ = last ? all : 0;
    wall_pass();
    momentum_pass();
    load_bodies();
    time_ += dt;
    particle_steps_ += last ? fluid_.size() : water_near_air_ + fluid_.size() - fluid_.water;
    return last_kick(dt);
}

std::optional<Instability> Simulation::run(double end, const Observer& observe, const Watch& watch) {
    constexpr std::uint64_t steps_between_watches = 64;
    observe(*this);
    while (time_ < end) {
        if (std::optional<Instability> trouble = step(end - time_)) return trouble;
        const StageTimer timer(stages_.probes);
        if (watch && (steps_ % steps_between_watches == 0 || time_ >= end)) {
            if (std::optional<Instability> trouble = watch(*this)) return trouble;
        }
        observe(*this);
    }
    return std::nullopt;
}

}  // namespace wetdeck

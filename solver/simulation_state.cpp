// SPDX-License-Identifier: BSD-3-Clause
// A simulation taken apart into plain numbers and put together again, to the same bits.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "solver/core/errors.hpp"
#include "solver/simulation.hpp"

namespace wetdeck {
namespace {

template <class Value>
std::vector<double> as_numbers(const std::vector<Value>& values) {
    return {values.begin(), values.end()};
}

/// Records of doubles only, one behind the other.
template <class Record>
std::vector<double> flat(const std::vector<Record>& records) {
    static_assert(sizeof(Record) % sizeof(double) == 0);
    const auto* first = reinterpret_cast<const double*>(records.data());
    return {first, first + records.size() * (sizeof(Record) / sizeof(double))};
}

template <class Record>
void unflatten(const std::vector<double>& values, std::vector<Record>& records) {
    std::copy(values.begin(), values.end(), reinterpret_cast<double*>(records.data()));
}

/// What changes of a body: pose, velocity, loads, impulses.
struct BodyNumbers {
    double x, y, angle, vx, vy, omega, fx, fy, torque, ax, ay, alpha, jx, jy, spin, work;
    double slow_fx, slow_fy, slow_torque, push_x, push_y, push_torque;
};

BodyNumbers numbers_of(const RigidBody& b) {
    return {b.position.x(),
            b.position.y(),
            b.angle,
            b.velocity.x(),
            b.velocity.y(),
            b.angular_velocity,
            b.force.x(),
            b.force.y(),
            b.torque,
            b.acceleration.x(),
            b.acceleration.y(),
            b.angular_acceleration,
            b.impulse.x(),
            b.impulse.y(),
            b.angular_impulse,
            b.work,
            b.slow.force.x(),
            b.slow.force.y(),
            b.slow.torque,
            b.slow_push.force.x(),
            b.slow_push.force.y(),
            b.slow_push.torque};
}

void set_numbers(RigidBody& b, const BodyNumbers& n) {
    b.position = {n.x, n.y};
    b.angle = n.angle;
    b.velocity = {n.vx, n.vy};
    b.angular_velocity = n.omega;
    b.force = {n.fx, n.fy};
    b.torque = n.torque;
    b.acceleration = {n.ax, n.ay};
    b.angular_acceleration = n.alpha;
    b.impulse = {n.jx, n.jy};
    b.angular_impulse = n.spin;
    b.work = n.work;
    b.slow = {{n.slow_fx, n.slow_fy}, n.slow_torque};
    b.slow_push = {{n.push_x, n.push_y}, n.push_torque};
}

std::vector<double> numbers_of(const std::vector<RigidBody>& bodies) {
    std::vector<BodyNumbers> all;
    for (const RigidBody& body : bodies) all.push_back(numbers_of(body));
    return flat(all);
}

void set_numbers(std::vector<RigidBody>& bodies, const std::vector<double>& values) {
    std::vector<BodyNumbers> all(bodies.size());
    unflatten(values, all);
    for (std::size_t b = 0; b < bodies.size(); ++b) set_numbers(bodies[b], all[b]);
}

/// Puts the particles of bodies in the order of `ids`: where a sort finds two in one cell it keeps their
/// order. Throws DataError unless `ids` names each of them once, and the fixed ones as they are.
void order_body_particles(WallParticles& walls, const std::vector<double>& ids) {
    std::vector<BodyPoint> by_id(walls.size());
    std::vector<int> missing(walls.size(), 0);
    for (std::size_t n = walls.fixed; n < walls.size(); ++n) {
        by_id[walls.id[n]] = walls.body_point[n - walls.fixed];
        missing[walls.id[n]] = 1;
    }
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const bool known = ids[n] >= 0 && ids[n] < static_cast<double>(walls.size());
        const bool fixed_as_is = n < walls.fixed && ids[n] == walls.id[n];
        if (!known || (!fixed_as_is && missing[static_cast<std::size_t>(ids[n])]-- != 1))
            throw DataError("the state names a boundary particle that is not there, or one twice");
        if (n < walls.fixed) continue;
        walls.id[n] = static_cast<std::uint32_t>(ids[n]);
        walls.body_point[n - walls.fixed] = by_id[walls.id[n]];
    }
}

class Reader {
  public:
    explicit Reader(const Simulation::State& state) : state_(state) {}

    const std::vector<double>& array(const char* name, std::size_t size) const {
        const auto found = state_.arrays.find(name);
        if (found == state_.arrays.end() || found->second.size() != size) {
            throw DataError(std::string("the state's array '") + name + "' is missing or of another length");
        }
        return found->second;
    }
    double number(const std::string& name) const {
        const auto found = state_.numbers.find(name);
        if (found == state_.numbers.end()) throw DataError("the state's number '" + name + "' is missing");
        return found->second;
    }
    /// A whole number below `end`.
    std::uint64_t count(const std::string& name, double end = 9e15) const {
        const double value = number(name);
        if (!(value >= 0 && value < end)) throw DataError("the state's number '" + name + "' is no count");
        return static_cast<std::uint64_t>(value);
    }

  private:
    const Simulation::State& state_;
};

constexpr std::size_t body_width = sizeof(BodyNumbers) / sizeof(double);
constexpr std::size_t state_width = sizeof(FluidState) / sizeof(double);
constexpr std::size_t wall_width = sizeof(WallState) / sizeof(double);
constexpr std::size_t mean_width = sizeof(WallMean) / sizeof(double);

/// The stage timers by name.
std::array<std::pair<const char*, double*>, 7> timers(StageTimes& s) {
    return {{{"neighbours_s", &s.neighbours},
             {"density_s", &s.density},
             {"momentum_s", &s.momentum},
             {"walls_s", &s.walls},
             {"bodies_s", &s.bodies},
             {"integration_s", &s.integration},
             {"probes_s", &s.probes}}};
}

}  // namespace

Simulation::State Simulation::state() const {
    State state;
    state.arrays["fluid"] = flat(fluid_.state);
    state.arrays["mass"] = fluid_.mass;
    state.arrays["density_rate"] = fluid_.density_rate;
    state.arrays["acceleration_x"] = fluid_.acceleration_x;
    state.arrays["acceleration_y"] = fluid_.acceleration_y;
    state.arrays["id"] = as_numbers(fluid_.id);
    const double* built = list_.built_positions();
    state.arrays["listed_at"] = {built, built + 2 * fluid_.size()};
    state.arrays["wall_mean"] = flat(walls_.mean);
    state.arrays["wall"] = flat(walls_.state);
    state.arrays["wall_id"] = as_numbers(walls_.id);
    state.arrays["bodies"] = numbers_of(bodies_);
    state.arrays["listed_bodies"] = numbers_of(built_bodies_);
    state.arrays["fastest"] = {fastest_.begin(), fastest_.end()};
    state.arrays["densest"] = {densest_.begin(), densest_.end()};
    state.numbers["time"] = time_;
    state.numbers["steps"] = static_cast<double>(steps_);
    state.numbers["particle_steps"] = static_cast<double>(particle_steps_);
    state.numbers["list_builds"] = static_cast<double>(list_builds_);
    state.numbers["list_slack"] = list_.slack();
    state.numbers["time_step"] = time_step_.size;
    state.numbers["criterion"] = static_cast<double>(time_step_.criterion);
    for (std::size_t k = 0; k < limits_.size(); ++k)
        state.numbers[std::string("limited_by_") + limiting_criterion_names[k]] =
            static_cast<double>(limits_[k]);
    StageTimes stages = stages_;
    for (const auto& [name, seconds] : timers(stages)) state.numbers[name] = *seconds;
    return state;
}

void Simulation::restore(const State& state) {
    const Reader in(state);
    const std::size_t size = fluid_.size();
    const std::vector<double>& fluid = in.array("fluid", state_width * size);
    const std::vector<double>& mass = in.array("mass", size);
    const std::vector<double>& density_rate = in.array("density_rate", size);
    const std::vector<double>& acceleration_x = in.array("acceleration_x", size);
    const std::vector<double>& acceleration_y = in.array("acceleration_y", size);
    const std::vector<double>& id = in.array("id", size);
    const std::vector<double>& listed_at = in.array("listed_at", 2 * size);
    const std::vector<double>& wall_mean = in.array("wall_mean", mean_width * walls_.size());
    const std::vector<double>& wall = in.array("wall", wall_width * walls_.size());
    const std::vector<double>& wall_id = in.array("wall_id", walls_.size());
    const std::vector<double>& bodies = in.array("bodies", body_width * bodies_.size());
    const std::vector<double>& listed_bodies = in.array("listed_bodies", body_width * bodies_.size());
    const std::vector<double>& fastest = in.array("fastest", fastest_.size());
    const std::vector<double>& densest = in.array("densest", densest_.size());
    std::vector<bool> seen(size, false);
    for (const double one : id) {
        const bool known = one >= 0 && one < static_cast<double>(size);
        if (!known || seen[static_cast<std::size_t>(one)])
            throw DataError("the state names a particle that is not there, or one twice");
        seen[static_cast<std::size_t>(one)] = true;
    }

    if (!std::all_of(listed_at.begin(), listed_at.end(), [](double x) { return std::isfinite(x); }))
        throw DataError("the state has particles nowhere");
    const double slack = in.number("list_slack");
    if (!(slack >= 0 && slack <= list_.skin()))
        throw DataError("the state has a neighbour list that is not in use");

    // The list must be the very one that was in use, in its order: it is built where it was built then. The
    // particles have kept their order since, so that sorting them by their cells changes nothing.
    fluid_.mass = mass;
    for (std::size_t i = 0; i < size; ++i) {
        fluid_.id[i] = static_cast<std::uint32_t>(id[i]);
        fluid_.state[i].x = listed_at[2 * i];
        fluid_.state[i].y = listed_at[2 * i + 1];
    }
    order_body_particles(walls_, wall_id);
    set_numbers(bodies_, listed_bodies);
    place_bodies();
    build_list();
    list_.set_slack(slack);
    unflatten(fluid, fluid_.state);
    set_numbers(bodies_, bodies);
    unflatten(wall, walls_.state);
    fluid_.density_rate = density_rate;
    fluid_.acceleration_x = acceleration_x;
    fluid_.acceleration_y = acceleration_y;
    unflatten(wall_mean, walls_.mean);
    std::copy(fastest.begin(), fastest.end(), fastest_.begin());
    std::copy(densest.begin(), densest.end(), densest_.begin());
    time_ = in.number("time");
    steps_ = in.count("steps");
    particle_steps_ = in.count("particle_steps");
    water_weight_ = model_.air_substeps;
    list_builds_ = in.count("list_builds");
    time_step_ = {in.number("time_step"),
                  static_cast<LimitingCriterion>(in.count("criterion", static_cast<double>(limits_.size())))};
    for (std::size_t k = 0; k < limits_.size(); ++k)
        limits_[k] = in.count(std::string("limited_by_") + limiting_criterion_names[k]);
    for (const auto& [name, seconds] : timers(stages_)) *seconds = in.number(name);
}

}  // namespace wetdeck

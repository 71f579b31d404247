// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation as plain numbers and back, to the same bits.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "solver/core/errors.hpp"
#include "solver/simulation.hpp"

namespace wetdeck {
namespace {

/// Numbers of one entry of a field.
template <class Value>
constexpr std::size_t width_of = std::is_arithmetic_v<Value> ? 1 : sizeof(Value) / sizeof(double);

/// The entries of a field as numbers; records hold doubles only.
template <class Value>
std::vector<double> flat(const std::vector<Value>& values) {
    if constexpr (std::is_arithmetic_v<Value>) {
        return {values.begin(), values.end()};
    } else {
        const auto* first = reinterpret_cast<const double*>(values.data());
        return {first, first + values.size() * width_of<Value>};
    }
}

template <class Value>
void unflatten(const std::vector<double>& numbers, std::vector<Value>& values) {
    if constexpr (std::is_arithmetic_v<Value>) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Value>(numbers[i]);
    } else {
        std::copy(numbers.begin(), numbers.end(), reinterpret_cast<double*>(values.data()));
    }
}

/// The changing numbers of all bodies, one body behind the other.
std::vector<double> numbers_of(const std::vector<RigidBody>& bodies) {
    std::vector<double> numbers;
    for (const RigidBody& body : bodies)
        for_each_number(body, [&numbers](double number) { numbers.push_back(number); });
    return numbers;
}

void set_numbers(std::vector<RigidBody>& bodies, const std::vector<double>& numbers) {
    auto next = numbers.begin();
    for (RigidBody& body : bodies) for_each_number(body, [&next](double& number) { number = *next++; });
}

/// Whether any body is let go later than at the start.
bool any_waits(const std::vector<RigidBody>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const RigidBody& body) { return body.guide.release_time > 0; });
}

/// When each body is let go [s].
std::vector<double> release_times(const std::vector<RigidBody>& bodies) {
    std::vector<double> times;
    for (const RigidBody& body : bodies) times.push_back(body.guide.release_time);
    return times;
}

/// Throws DataError unless `ids` are the numbers from 0 to their count, each once.
void check_ids(const std::vector<double>& ids, const char* kind) {
    std::vector<bool> seen(ids.size(), false);
    for (const double id : ids) {
        const bool known = id >= 0 && id < static_cast<double>(ids.size());
        if (!known || seen[static_cast<std::size_t>(id)])
            throw DataError(std::string("the state names a ") + kind + " that is not there, or one twice");
        seen[static_cast<std::size_t>(id)] = true;
    }
}

/// Puts the boundary particles of bodies in the order of `ids`: a sort keeps the order of two that it finds
/// in one cell. Throws DataError unless `ids` names each of them once, and those of the tank as they are.
void order_body_particles(WallParticles& walls, const std::vector<double>& ids) {
    check_ids(ids, "boundary particle");
    std::vector<BodyPoint> by_id(walls.size());
    for (std::size_t n = walls.fixed; n < walls.size(); ++n) by_id[walls.id[n]] = walls.body_point[n];
    for (std::size_t n = 0; n < walls.size(); ++n) {
        if (n < walls.fixed && ids[n] != walls.id[n])
            throw DataError("the state names a boundary particle that is not there, or one twice");
        if (n < walls.fixed) continue;
        walls.id[n] = static_cast<std::uint32_t>(ids[n]);
        walls.body_point[n] = by_id[walls.id[n]];
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
        if (!(value >= 0 && value < end)) throw DataError("the state's number '" + name + "' is not a count");
        return static_cast<std::uint64_t>(value);
    }

  private:
    const Simulation::State& state_;
};

std::size_t numbers_of_a_body() {
    return numbers_of(std::vector<RigidBody>(1)).size();
}

/// Adds the stored fields of particles to a state.
template <class Particles>
void store_fields(const Particles& particles, Simulation::State& state) {
    for_each_field(particles, [&state](const auto& field, const auto& values) {
        if (field.stored == Stored::yes) state.arrays[field.name] = flat(values);
    });
}

/// The stored fields of particles as the state holds them. Throws DataError where one has another length.
template <class Particles>
void check_fields(const Particles& particles, const Reader& in) {
    for_each_field(particles, [&in](const auto& field, const auto& values) {
        using Value = std::decay_t<decltype(values[0])>;
        if (field.stored == Stored::yes) in.array(field.name, width_of<Value> * values.size());
    });
}

template <class Particles>
void restore_fields(Particles& particles, const Reader& in) {
    for_each_field(particles, [&in](const auto& field, auto& values) {
        using Value = std::decay_t<decltype(values[0])>;
        if (field.stored == Stored::yes)
            unflatten(in.array(field.name, width_of<Value> * values.size()), values);
    });
}

}  // namespace

Simulation::State Simulation::state() const {
    State state;
    store_fields(flow_.fluid, state);
    store_fields(flow_.walls, state);
    const double* built = rates_.list().built_positions();
    state.arrays["listed_at"] = {built, built + 2 * flow_.fluid.size()};
    state.arrays["bodies"] = numbers_of(flow_.bodies);
    state.arrays["listed_bodies"] = numbers_of(rates_.listed_bodies());
    if (any_waits(flow_.bodies)) state.arrays["release_times"] = release_times(flow_.bodies);
    state.arrays["fastest"] = {extremes_.fastest.begin(), extremes_.fastest.end()};
    state.arrays["densest"] = {extremes_.densest.begin(), extremes_.densest.end()};
    state.numbers["time"] = flow_.time;
    state.numbers["steps"] = static_cast<double>(steps_);
    state.numbers["particle_steps"] = static_cast<double>(particle_steps_);
    state.numbers["list_builds"] = static_cast<double>(rates_.list_builds());
    state.numbers["list_slack"] = rates_.list().slack();
    state.numbers["list_skin"] = rates_.skin_choice().skin;
    state.numbers["list_served"] = rates_.skin_choice().served;
    state.numbers["lists_steps"] = rates_.skin_choice().steps;
    state.numbers["lists_skins"] = rates_.skin_choice().sum;
    state.numbers["time_step"] = time_step_.size;
    state.numbers["criterion"] = static_cast<double>(time_step_.criterion);
    for (std::size_t k = 0; k < limits_.size(); ++k)
        state.numbers[std::string("limited_by_") + limiting_criterion_names[k]] =
            static_cast<double>(limits_[k]);
    for_each_stage(rates_.stages(), [&state](const std::string& name, double seconds) {
        state.numbers[name + "_s"] = seconds;
    });
    return state;
}

void Simulation::restore(const State& state) {
    const Reader in(state);
    FluidParticles& fluid = flow_.fluid;
    const std::size_t size = fluid.size(), body_numbers = numbers_of_a_body() * flow_.bodies.size();
    check_fields(fluid, in);
    check_fields(flow_.walls, in);
    const std::vector<double>& listed_at = in.array("listed_at", 2 * size);
    const std::vector<double>& bodies = in.array("bodies", body_numbers);
    const std::vector<double>& listed_bodies = in.array("listed_bodies", body_numbers);
    std::vector<double> released(flow_.bodies.size(), 0.0);
    if (any_waits(flow_.bodies)) released = in.array("release_times", released.size());
    const std::vector<double>& fastest = in.array("fastest", extremes_.fastest.size());
    const std::vector<double>& densest = in.array("densest", extremes_.densest.size());
    check_ids(in.array("id", size), "particle");
    if (!std::all_of(listed_at.begin(), listed_at.end(), [](double x) { return std::isfinite(x); }))
        throw DataError("the state has particles at no position");
    const SkinChoice skin{in.number("list_skin"), in.number("list_served"), in.number("lists_steps"),
                          in.number("lists_skins")};
    const double slack = in.number("list_slack");
    if (!skin.is_sound()) throw DataError("the state has a skin of its neighbour list that is never chosen");
    rates_.restore_skin(skin, flow_.walls);
    if (!(slack >= 0 && slack <= rates_.list().skin()))
        throw DataError("the state has a neighbour list that is not in use");

    // The list must be the very one that was in use, in its order: it is built where it was built then. The
    // particles have kept their order since, so that sorting them by their cells changes nothing.
    restore_fields(fluid, in);
    for (std::size_t i = 0; i < size; ++i) {
        fluid.state[i].x = listed_at[2 * i];
        fluid.state[i].y = listed_at[2 * i + 1];
    }
    order_body_particles(flow_.walls, in.array("wall_id", flow_.walls.size()));
    set_numbers(flow_.bodies, listed_bodies);
    place_walls(flow_, model().gravity);
    rates_.build_list(flow_);
    if (flat(fluid.id) != in.array("id", size))
        throw DataError("the state has particles in another order than their neighbour list");
    rates_.list().set_slack(slack);
    restore_fields(fluid, in);
    restore_fields(flow_.walls, in);
    set_numbers(flow_.bodies, bodies);
    for (std::size_t b = 0; b < released.size(); ++b) {
        flow_.bodies[b].guide.release_time = released[b];
        flow_.bodies[b].held = in.number("time") <= released[b] && released[b] > 0;
    }
    std::copy(fastest.begin(), fastest.end(), extremes_.fastest.begin());
    std::copy(densest.begin(), densest.end(), extremes_.densest.begin());
    flow_.time = in.number("time");
    steps_ = in.count("steps");
    particle_steps_ = in.count("particle_steps");
    rates_.set_list_builds(in.count("list_builds"));
    time_step_ = {in.number("time_step"),
                  static_cast<LimitingCriterion>(in.count("criterion", static_cast<double>(limits_.size())))};
    for (std::size_t k = 0; k < limits_.size(); ++k)
        limits_[k] = in.count(std::string("limited_by_") + limiting_criterion_names[k]);
    for_each_stage(rates_.stages(),
                   [&in](const std::string& name, double& seconds) { seconds = in.number(name + "_s"); });
}

}  // namespace wetdeck

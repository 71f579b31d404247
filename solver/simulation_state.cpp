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

constexpr std::size_t state_width = sizeof(FluidState) / sizeof(double);
constexpr std::size_t mean_width = sizeof(WallMean) / sizeof(double);

/// The stage timers by name.
std::array<std::pair<const char*, double*>, 6> timers(StageTimes& s) {
    return {{{"neighbours_s", &s.neighbours},
             {"density_s", &s.density},
             {"momentum_s", &s.momentum},
             {"walls_s", &s.walls},
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
    state.arrays["fastest"] = {fastest_.begin(), fastest_.end()};
    state.numbers["time"] = time_;
    state.numbers["steps"] = static_cast<double>(steps_);
    state.numbers["list_builds"] = static_cast<double>(list_builds_);
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
    const std::vector<double>& fastest = in.array("fastest", fastest_.size());
    std::vector<bool> seen(size, false);
    for (const double one : id) {
        const bool known = one >= 0 && one < static_cast<double>(size);
        if (!known || seen[static_cast<std::size_t>(one)])
            throw DataError("the state names a particle that is not there, or one twice");
        seen[static_cast<std::size_t>(one)] = true;
    }

    if (!std::all_of(listed_at.begin(), listed_at.end(), [](double x) { return std::isfinite(x); }))
        throw DataError("the state has particles nowhere");

    // The list must be the very one that was in use, in its order: it is built where it was built then. The
    // particles have kept their order since, so that sorting them by their cells changes nothing.
    fluid_.mass = mass;
    for (std::size_t i = 0; i < size; ++i) {
        fluid_.id[i] = static_cast<std::uint32_t>(id[i]);
        fluid_.state[i].x = listed_at[2 * i];
        fluid_.state[i].y = listed_at[2 * i + 1];
    }
    build_list();
    unflatten(fluid, fluid_.state);
    fluid_.density_rate = density_rate;
    fluid_.acceleration_x = acceleration_x;
    fluid_.acceleration_y = acceleration_y;
    unflatten(wall_mean, walls_.mean);
    std::copy(fastest.begin(), fastest.end(), fastest_.begin());
    time_ = in.number("time");
    steps_ = in.count("steps");
    list_builds_ = in.count("list_builds");
    time_step_ = {in.number("time_step"),
                  static_cast<LimitingCriterion>(in.count("criterion", static_cast<double>(limits_.size())))};
    for (std::size_t k = 0; k < limits_.size(); ++k)
        limits_[k] = in.count(std::string("limited_by_") + limiting_criterion_names[k]);
    for (const auto& [name, seconds] : timers(stages_)) *seconds = in.number(name);
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/execute/series_keeper.hpp"

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

const std::string prefix = "series.";

std::vector<LiveColumn> columns(const Recorders& recorders) {
    std::vector<LiveColumn> result;
    for (const SeriesInfo& r : recorders.list()) result.push_back({r.name, r.unit, r.description});
    return result;
}

}  // namespace

SeriesKeeper::SeriesKeeper(const Scene& scene, double particle_spacing, const std::filesystem::path& run_dir,
                           const Checkpoint* from)
    : recorders_(scene, particle_spacing),
      interval_(scene.sample_interval),
      live_(run_dir, columns(recorders_)) {
    for (const SeriesInfo& r : recorders_.list()) kept_.push_back({r.unit, r.description, {}, {}, {}});
    if (!from) return;
    next_ = from->number("next_sample");
    times_ = from->array("sample_times");
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        kept_[k].value = from->array(prefix + recorders_.list()[k].name);
        if (kept_[k].value.size() != times_.size())
            throw DataError("the checkpoint's series '" + recorders_.list()[k].name + "' has another length");
    }
    for (std::size_t row = 0; row < times_.size(); ++row) {
        values_.clear();
        for (const Series& series : kept_) values_.push_back(series.value[row]);
        live_.append(times_[row], values_);
    }
}

void SeriesKeeper::observe(const Simulation& simulation, bool last) {
    if (simulation.time() < next_ && !last) return;
    if (!times_.empty() && simulation.time() <= times_.back()) return;
    while (next_ <= simulation.time()) next_ += interval_;
    recorders_.sample(simulation, values_);
    live_.append(simulation.time(), values_);
    times_.push_back(simulation.time());
    for (std::size_t k = 0; k < values_.size(); ++k) kept_[k].value.push_back(values_[k]);
}

std::map<std::string, Series> SeriesKeeper::series() const {
    std::map<std::string, Series> result;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        Series& series = result[recorders_.list()[k].name] = kept_[k];
        series.time = times_;
    }
    return result;
}

void SeriesKeeper::save(Checkpoint& checkpoint) const {
    checkpoint.numbers["next_sample"] = next_;
    checkpoint.arrays["sample_times"] = times_;
    for (std::size_t k = 0; k < kept_.size(); ++k)
        checkpoint.arrays[prefix + recorders_.list()[k].name] = kept_[k].value;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/time_series.hpp"

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

const std::string prefix = "series.";

std::vector<LiveColumn> columns(const Recorders& recorders) {
    std::vector<LiveColumn> result;
    for (const SeriesInfo& r : recorders.list()) {
        if (r.abscissa.empty()) result.push_back({r.name, r.unit, r.description});
        for (std::size_t k = 0; k < r.abscissa.size(); ++k)
            result.push_back({r.name + "[" + std::to_string(k) + "]", r.unit, r.description});
    }
    return result;
}

}  // namespace

TimeSeries::TimeSeries(const Scene& scene, double particle_spacing, const std::filesystem::path& run_dir,
                       const Checkpoint* from)
    : scene_(scene),
      recorders_(scene, particle_spacing),
      interval_(scene.sample_interval),
      live_(run_dir, columns(recorders_)) {
    for (const SeriesInfo& r : recorders_.list())
        series_.push_back({r.unit, r.description, {}, {}, r.abscissa});
    if (!from) return;
    next_ = from->number("next_sample");
    times_ = from->array("sample_times");
    for (std::size_t k = 0; k < series_.size(); ++k) {
        series_[k].value = from->array(prefix + recorders_.list()[k].name);
        if (series_[k].value.size() != times_.size() * series_[k].columns())
            throw DataError("the checkpoint's series '" + recorders_.list()[k].name + "' has another length");
    }
    for (std::size_t row = 0; row < times_.size(); ++row) {
        values_.clear();
        for (const Series& series : series_) {
            const auto first = series.value.begin() + static_cast<std::ptrdiff_t>(row * series.columns());
            values_.insert(values_.end(), first, first + static_cast<std::ptrdiff_t>(series.columns()));
        }
        live_.append(times_[row], values_);
    }
}

void TimeSeries::sample(const Simulation& simulation, bool last) {
    if (simulation.time() < next_ && !last) return;
    if (!times_.empty() && simulation.time() <= times_.back()) return;
    while (next_ <= simulation.time()) next_ += interval_;
    recorders_.sample(simulation, times_.size(), values_);
    live_.append(simulation.time(), values_);
    times_.push_back(simulation.time());
    auto next = values_.begin();
    for (Series& series : series_) {
        const auto end = next + static_cast<std::ptrdiff_t>(series.columns());
        series.value.insert(series.value.end(), next, end);
        next = end;
    }
}

std::map<std::string, Series> TimeSeries::all() const {
    std::map<std::string, Series> result;
    for (std::size_t k = 0; k < series_.size(); ++k) {
        Series& series = result[recorders_.list()[k].name] = series_[k];
        series.time = times_;
    }
    add_body_means(scene_, result);
    return result;
}

void TimeSeries::save(Checkpoint& checkpoint) const {
    checkpoint.numbers["next_sample"] = next_;
    checkpoint.arrays["sample_times"] = times_;
    for (std::size_t k = 0; k < series_.size(); ++k)
        checkpoint.arrays[prefix + recorders_.list()[k].name] = series_[k].value;
}

}  // namespace wetdeck

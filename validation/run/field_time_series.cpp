// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/field_time_series.hpp"

namespace wetdeck {
namespace {

const std::string times_name = "field_times";
const std::string prefix = "field_series.";

}  // namespace

FieldTimeSeries::FieldTimeSeries(const Scene& scene, const Checkpoint* from)
    : kinds_(field_series(scene)), outlines_(local_outlines(scene)), values_(kinds_.size()) {
    if (!from) return;
    times_ = from->array(times_name);
    for (std::size_t k = 0; k < kinds_.size(); ++k) values_[k] = from->array(prefix + kinds_[k].info.name);
}

void FieldTimeSeries::sample(const Simulation& simulation) {
    times_.push_back(simulation.time());
    for (std::size_t k = 0; k < kinds_.size(); ++k)
        values_[k].push_back(kinds_[k].value(simulation, outlines_));
}

std::map<std::string, Series> FieldTimeSeries::all() const {
    std::map<std::string, Series> result;
    if (times_.empty()) return result;
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
        const SeriesInfo& info = kinds_[k].info;
        result[info.name] = {info.unit, info.description, times_, values_[k], {}};
    }
    return result;
}

void FieldTimeSeries::save(Checkpoint& checkpoint) const {
    checkpoint.arrays[times_name] = times_;
    for (std::size_t k = 0; k < kinds_.size(); ++k)
        checkpoint.arrays[prefix + kinds_[k].info.name] = values_[k];
}

}  // namespace wetdeck

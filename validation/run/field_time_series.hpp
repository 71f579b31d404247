// SPDX-License-Identifier: BSD-3-Clause
// The series of a run that are taken when a field file is written.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/scene/scene.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

class FieldTimeSeries {
  public:
    /// Starts with the samples of the checkpoint `from` if there is one.
    FieldTimeSeries(const Scene& scene, const Checkpoint* from);

    void sample(const Simulation& simulation);
    /// By name; none before the first field file.
    std::map<std::string, Series> all() const;
    void save(Checkpoint& checkpoint) const;

  private:
    std::vector<FieldSeries> kinds_;
    std::vector<Outline> outlines_;
    std::vector<double> times_;
    std::vector<std::vector<double>> values_;  ///< in the order of kinds_
};

}  // namespace wetdeck

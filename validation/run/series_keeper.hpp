// SPDX-License-Identifier: BSD-3-Clause
// The series of a run as it goes: sampled at their interval, kept in memory, mirrored in the live file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/run/recorders.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/live_series.hpp"

namespace wetdeck {

class SeriesKeeper {
  public:
    /// Starts the live file anew; `from`, if any, brings the samples taken so far.
    SeriesKeeper(const Scene& scene, double particle_spacing, const std::filesystem::path& run_dir,
                 const Checkpoint* from);

    void observe(const Simulation& simulation, bool last);
    std::map<std::string, Series> series() const;
    void save(Checkpoint& checkpoint) const;

  private:
    const Scene& scene_;
    Recorders recorders_;
    double interval_;
    double next_ = 0;
    LiveSeries live_;
    std::vector<double> times_, values_;
    std::vector<Series> kept_;
};

}  // namespace wetdeck

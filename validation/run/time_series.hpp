// SPDX-License-Identifier: BSD-3-Clause
// The time series of a run: sampled at the scene's interval, kept in memory and copied to the live file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/run/recorders.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/live_series.hpp"

namespace wetdeck {

class TimeSeries {
  public:
    /// Starts the live file anew, with the samples of the checkpoint `from` if there is one.
    TimeSeries(const Scene& scene, double particle_spacing, const std::filesystem::path& run_dir,
               const Checkpoint* from);

    /// Takes a sample if one is due at this time, or if it is the last time of the run.
    void sample(const Simulation& simulation, bool last);
    /// All series by name, with forces and accelerations of the bodies.
    std::map<std::string, Series> all() const;
    void save(Checkpoint& checkpoint) const;

  private:
    const Scene& scene_;
    Recorders recorders_;
    double interval_;
    double next_ = 0;
    LiveSeries live_;
    std::vector<double> times_, values_;  ///< of all samples; of the last sample
    std::vector<Series> series_;          ///< in the order of the recorders; their times are in times_
};

}  // namespace wetdeck

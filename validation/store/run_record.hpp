// SPDX-License-Identifier: BSD-3-Clause
// Everything that is kept of one run, as plain data: what `run.h5` holds.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace wetdeck {

/// One recorded quantity. `value` is row-major, `time.size()` rows of `columns()` entries.
struct Series {
    std::string unit;              ///< SI, written "Pa", "m/s", "N s/m", "-"
    std::string description;       ///< what is sampled and how (averaging, size), one sentence
    std::vector<double> time;      ///< [s] since the start of the run, strictly increasing
    std::vector<double> value;     ///< SI
    std::vector<double> abscissa;  ///< coordinates of the columns of a two-dimensional series, else empty

    std::size_t columns() const { return abscissa.empty() ? 1 : abscissa.size(); }
};

enum class RunStatus { ok, unstable, failed };

/// "ok", "unstable" or "failed", as in summary.json.
std::string to_string(RunStatus status);
RunStatus run_status_from(const std::string& text);

/// What the run cost and what set its pace.
struct RunCost {
    double wall_s = 0;
    double core_s = 0;  ///< processor time of all threads [s]
    std::uint64_t steps = 0;
    double particle_steps = 0;  ///< particles whose rates were summed, over all steps
    double peak_rss_mb = 0;
    std::map<std::string, double> stage_seconds;              ///< wall seconds by stage of the time loop
    std::map<std::string, std::uint64_t> limiting_criterion;  ///< steps whose size each criterion set
};

struct RunRecord {
    std::string scene;
    std::string variant;
    double particle_spacing = 0;  ///< [m]
    std::uint64_t fluid_particles = 0;
    std::uint64_t particles = 0;  ///< fluid and boundary
    RunStatus status = RunStatus::ok;
    std::string stop_reason;  ///< one sentence: when, where, why; empty for a run that reached its end
    std::string scene_text;   ///< the scene file as it was read
    std::string scene_path;   ///< where it was read from
    std::map<std::string, double> parameters;  ///< every resolved number, by dotted key, SI
    std::map<std::string, std::string>
        provenance;  ///< of scene, program and machine; and texts of parameters
    std::map<std::string, Series> series;
    RunCost cost;
};

/// An entry of the provenance, empty if it is not there.
inline std::string provenance_entry(const RunRecord& record, const std::string& key) {
    const auto found = record.provenance.find(key);
    return found == record.provenance.end() ? std::string() : found->second;
}

/// Whether the run was asked to stop before its scene's end: what it did not get to is no failure of it.
inline bool stopped_early(const RunRecord& record) {
    const auto until = record.parameters.find("run.until"), end = record.parameters.find("run.end_time");
    return until != record.parameters.end() &&
           (end == record.parameters.end() || until->second < end->second);
}

}  // namespace wetdeck

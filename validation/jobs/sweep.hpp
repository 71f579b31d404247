// SPDX-License-Identifier: BSD-3-Clause
// The runs of a sweep: one scene and variant over a grid of the values of its keys, each point at several
// spacings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "validation/jobs/plan.hpp"
#include "validation/metrics/sweep_result.hpp"

namespace wetdeck {

/// "KEY=FROM:TO:COUNT" or "KEY=FROM:TO:COUNT UNIT"; KEY alone names a parameter of the scene. Throws
/// InputError for anything else, for a key that the scene computes from its parameters, and for a parameter
/// that the scene gives with a unit and this axis without.
SweepAxis parse_axis(const std::string& text, const Scene& scene);

struct SweepPlan {
    std::string scene;  ///< name or path
    std::string variant;
    std::vector<SweepAxis> axes;
    std::vector<double> spacings;        ///< [m], coarse to fine
    std::vector<std::string> overrides;  ///< KEY=VALUE, the same at every point
    std::filesystem::path directory;
};

/// Values at each point of the grid, one for each axis; the first axis changes fastest. Throws InputError for
/// a key that stands twice and beyond 10,000 points.
std::vector<std::vector<double>> grid_points(const std::vector<SweepAxis>& axes);

/// KEY=VALUE of a point, those of the plan first.
std::vector<std::string> overrides_at(const SweepPlan& plan, const std::vector<double>& at);

/// DIR/points/KEY=VALUE,KEY=VALUE
std::filesystem::path point_directory(const SweepPlan& plan, const std::vector<double>& at);

/// Every run, point by point, coarse spacings first. Throws InputError for a point whose scene is not sound,
/// and for a key that changes nothing in the run.
std::vector<SuiteRow> sweep_rows(const SweepPlan& plan);

/// DIR/sweep.json: the plan, for `wetdeck report`.
inline constexpr const char* sweep_file = "sweep.json";
void write_sweep_plan(const SweepPlan& plan);
/// Throws DataError for a file that is not one.
SweepPlan read_sweep_plan(const std::filesystem::path& directory);

}  // namespace wetdeck

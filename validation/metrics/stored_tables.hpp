// SPDX-License-Identifier: BSD-3-Clause
// Results beside the runs of a directory, written by their commands: DIR/ablation.json and
// DIR/stress.json, each {"schema": 1, "rows": [...]} with the keys of summary.json.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

inline constexpr const char* stress_file = "stress.json";

void write_ablation(const std::filesystem::path& directory, const std::vector<AblationRow>& rows);
void write_stress(const std::filesystem::path& directory, const std::vector<StressRow>& rows);

/// No rows where there is no file. Throws DataError, naming the file and the row, if it is not as written.
std::vector<AblationRow> read_ablation(const std::filesystem::path& directory);
std::vector<StressRow> read_stress(const std::filesystem::path& directory);

/// As in summary.json.
nlohmann::json ablation_json(const AblationRow& row);

}  // namespace wetdeck

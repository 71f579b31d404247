// SPDX-License-Identifier: BSD-3-Clause
// verification.json: results of the problems with exact solutions, so that a report can be made again without
// running anything; and the `verification` list of summary.json.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "validation/metrics/verification.hpp"

namespace wetdeck {

/// Its name in a directory of results.
inline constexpr const char* verification_file = "verification.json";

/// One entry per claim: problem, quantity, resolution, error, order, expected_order and their meaning.
nlohmann::json verification_list(const std::vector<VerificationProblem>& problems);

/// Everything, with curves and notes.
nlohmann::json verification_json(const std::vector<VerificationProblem>& problems);

/// The problems of a file that verification_json wrote; none if there is no such file. Throws DataError.
std::vector<VerificationProblem> read_verification(const std::filesystem::path& file);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck verify`: runs problems with exact solutions and keeps what they found.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/metrics/verification.hpp"

namespace wetdeck {

struct VerifyOptions {
    std::vector<std::string> problems;  ///< all if empty
    std::filesystem::path directory;
    bool fast = false;  ///< the quick problems alone, at their coarse resolutions
};

/// Runs the problems, prints a table each, writes DIR/verification.json. Results of other problems that the
/// file holds stay.
std::vector<VerificationProblem> run_verification(const VerifyOptions& options);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// summary.json: every figure of the report, for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// The program and the machine that wrote the summary.
struct ProgramInfo {
    std::string version, commit, compiler, simd;
    int threads = 0;
    std::string cpu;
    int cores = 0;
};

/// The summary in schema 1: SI units, null for what could not be computed (also for a number that is not
/// finite, and for `kind` and `within` of a comparison without a reference file).
nlohmann::json summary_json(const Summary& summary, const ProgramInfo& program);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The report of a sweep: design curves and maps of one scene over the values of its keys.
#pragma once

#include <filesystem>

#include "reports/page/report_inputs.hpp"
#include "validation/metrics/sweep_result.hpp"

namespace wetdeck::report {

/// Writes DIR/index.html and DIR/figures/: for each quantity its curves over the first key, one for each
/// combination of the others, with what is expected and the values of other methods; with two keys or more a
/// map; the curves that several quantities make up; and a table of the points. Throws EnvironmentError if the
/// machine refuses.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result,
                        const ReportInputs& inputs);

}  // namespace wetdeck::report

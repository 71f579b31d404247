// SPDX-License-Identifier: BSD-3-Clause
// The report of a directory of runs: DIR/index.html and DIR/figures/*.{svg,csv}.
#pragma once

#include <filesystem>

#include "reports/page/report_inputs.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck::report {

/// Writes DIR/index.html and DIR/figures. The same arguments give the same bytes. `figures` belongs to the
/// report: drawings and tables of an earlier report that are no longer part of it are removed. Without
/// gnuplot the page says so and has interactive figures only. Throws EnvironmentError if the machine refuses.
void write_report(const std::filesystem::path& directory, const Summary& summary, const ReportInputs& inputs);

}  // namespace wetdeck::report

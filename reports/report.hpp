// SPDX-License-Identifier: BSD-3-Clause
// The report of a directory of runs: DIR/index.html, further pages beside it, and DIR/figures/*.{svg,csv}.
#pragma once

#include <filesystem>

#include "reports/page/report_inputs.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck::report {

/// Writes DIR/index.html, DIR/scene-NAME.html for each scene, DIR/statistics.html and, where there is
/// something to show, DIR/exact-solutions.html, hard-cases.html and sources.html; with `inputs.single_file`
/// all of them as one DIR/index.html. The same arguments give the same bytes. `figures` belongs to the
/// report: pages, drawings and tables of an earlier report that are no longer part of it are removed. Without
/// gnuplot the first page says so and figures are interactive only. Throws EnvironmentError if the machine
/// refuses.
void write_report(const std::filesystem::path& directory, const Summary& summary, const ReportInputs& inputs);

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// The report of a directory of runs: DIR/index.html and DIR/figures/*.{svg,csv}.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck::report {

/// What the colours of a picture mean.
struct ColourBar {
    std::string label;
    std::string unit;
    double low = 0;
    double high = 1;
    std::vector<std::string> colours;  ///< "#rrggbb" from low to high, equally spaced
};

/// A field drawn by the caller.
struct Picture {
    std::string title;
    double time = 0;  ///< [s]
    std::vector<unsigned char> png;
    std::vector<ColourBar> colour_bars;
    std::optional<double> scaled_time;  ///< T, where the scene has one scale of time
};

/// What the report shows beside the analysis.
struct ReportInputs {
    std::vector<std::pair<std::string, std::string>> program;  ///< name and value, in the order shown
    std::vector<std::pair<std::string, std::string>> machine;
    std::map<std::string, std::vector<Picture>> pictures;  ///< by RunSummary::directory
    std::map<std::string, std::string> sketches;           ///< SVG of the set-up, by scene
    std::map<std::string, std::string> deaths;             ///< PNG, by StressRow::picture
    std::string plotly;  ///< text of plotly.js; empty: the figures are static
    std::string note;    ///< one sentence on how this report was made
};

/// Text of the plotly.js that was installed or built with the program, empty if there is none.
std::string load_plotly();

/// Writes DIR/index.html and DIR/figures. The same arguments give the same bytes. `figures` belongs to the
/// report: drawings and tables of an earlier report that are no longer part of it are removed. Without
/// gnuplot the page says so and has interactive figures only. Throws EnvironmentError if the machine refuses.
void write_report(const std::filesystem::path& directory, const Summary& summary, const ReportInputs& inputs);

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// What the caller of the report hands in besides the analysis: pictures, sketches, the plotting library.
#pragma once

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

/// A key in which the scheme of a variant differs from that of the scene's source.
struct SchemeRow {
    std::string variant, key, meaning, equation, source, used;
};

struct ReportInputs {
    std::vector<std::pair<std::string, std::string>> program;  ///< name and value, in the order shown
    std::vector<std::pair<std::string, std::string>> machine;
    std::map<std::string, std::vector<Picture>> pictures;  ///< by RunSummary::directory
    std::map<std::pair<std::string, std::string>, std::vector<Picture>> side_by_side;  ///< by scene and title
    std::map<std::string, std::string> sketches;            ///< SVG of the set-up, by scene
    std::map<std::string, std::vector<SchemeRow>> schemes;  ///< by scene
    std::map<std::string, std::string> instabilities;       ///< PNG, by StressRow::picture
    std::vector<ValidationRow> codes;                       ///< this program beside other codes
    std::string plotly;        ///< text of plotly.js; empty: the figures are static
    std::string note;          ///< one sentence on how this report was made
    bool single_file = false;  ///< all pages in index.html, without a link to another file
    std::string subject;       ///< of the title, for example "single runs"; empty: the tier of the summary
};

/// Text of the plotly.js that was installed or built with the program, empty if there is none.
std::string load_plotly();

}  // namespace wetdeck::report

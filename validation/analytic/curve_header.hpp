// SPDX-License-Identifier: BSD-3-Clause
// Header of an analytic curve as the text of a reference file (reference_data/README.md).
#pragma once

#include <map>
#include <string>

namespace wetdeck {

/// Values of the parameters of a curve, by name, with the units that the scene gives them in.
using CurveValues = std::map<std::string, double>;

/// What the header says beyond what all analytic curves have in common.
struct CurveHeader {
    const char* citation;
    const char* doi;
    std::string method;
    const char* u_data;
    const char* u_data_source;
    const char* sign;
    const char* time_origin;
    std::string note;
};

/// The header, with the names of the columns as its last line.
std::string curve_header_text(const CurveHeader& header, const char* columns);

}  // namespace wetdeck

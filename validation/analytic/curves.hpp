// SPDX-License-Identifier: BSD-3-Clause
// Analytic curves by name, so that a scene can be compared with them as with the files of reference_data/.
#pragma once

#include <string>
#include <vector>

namespace wetdeck {

struct AnalyticCurveInfo {
    std::string name;
    std::string parameters;  ///< "deadrise [speed=6.15]": names with their defaults, if they have any
    std::string meaning;
};

/// All curves.
const std::vector<AnalyticCurveInfo>& analytic_curves();

/// Whether a reference is named "analytic:...", to be computed instead of read.
bool is_analytic(const std::string& reference);

/// Checks "analytic:NAME key=value key=value ..." without computing it. Throws InputError for an unknown
/// name, an unknown, missing or repeated key, or a value out of range.
void check_analytic(const std::string& reference);

/// The curve of that name as the text of a reference file, header and columns as reference_data/README.md has
/// them, so that it carries the same provenance and passes the same checks. Throws as check_analytic().
std::string analytic_reference(const std::string& reference);

}  // namespace wetdeck

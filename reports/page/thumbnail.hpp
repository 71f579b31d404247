// SPDX-License-Identifier: BSD-3-Clause
// A figure as small as a word: curves without axes, drawn into the page itself.
#pragma once

#include <string>

#include "reports/page/figure.hpp"

namespace wetdeck::report {

/// Inline SVG of the lines and points of the figure within the ranges of its axes; the title is its text for
/// those who do not see it. Empty without a curve.
std::string thumbnail(const Figure& figure);

}  // namespace wetdeck::report

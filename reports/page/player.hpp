// SPDX-License-Identifier: BSD-3-Clause
// Field pictures: of a run one after another, or of several runs beside each other.
#pragma once

#include <string>
#include <vector>

#include "reports/page/report_inputs.hpp"

namespace wetdeck::report {

/// Markup of the pictures in a grid.
std::string picture_grid(const std::vector<Picture>& pictures);
/// The same, which the script of the page turns into a player.
std::string picture_player(const std::vector<Picture>& pictures);

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// The field pictures of a run.
#pragma once

#include <string>
#include <vector>

#include "reports/page/report_inputs.hpp"

namespace wetdeck::report {

/// Markup of the pictures in a grid, which the script of the page turns into a player.
std::string picture_player(const std::vector<Picture>& pictures);

}  // namespace wetdeck::report

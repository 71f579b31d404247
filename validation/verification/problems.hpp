// SPDX-License-Identifier: BSD-3-Clause
// Every problem with an exact solution, in the order of the report. One file each, named like its function;
// free flight is in floating_body.cpp, the square in air in square_patch.cpp.
#pragma once

#include <vector>

#include "validation/verification/problem.hpp"

namespace wetdeck::verification {

Problem kernel_moments();
Problem riemann_problem();
Problem acoustic_pulse();
Problem sponge_layer();
Problem graded_spacing();
Problem hydrostatic_tank();
Problem gravity_wave();
Problem taylor_green();
Problem layered_flow();
Problem oscillating_drop();
Problem square_patch();
Problem square_in_air();
Problem block_impact();
Problem trapped_air_piston();
Problem ritter();
Problem released_column();
Problem free_flight();
Problem floating_body();
Problem heave_decay();
Problem roll_decay();
Problem oscillating_cylinder();
Problem moving_tank();

const std::vector<Problem>& all_problems();

/// Those of these names in the order of the list; all for no name. Throws InputError for an unknown one.
std::vector<Problem> problems_named(const std::vector<std::string>& names);

}  // namespace wetdeck::verification

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/problems.hpp"

#include <algorithm>

#include "solver/core/errors.hpp"

namespace wetdeck::verification {

const std::vector<Problem>& all_problems() {
    static const std::vector<Problem> problems = {
        kernel_moments(),       riemann_problem(), acoustic_pulse(), sponge_layer(),       graded_spacing(),
        hydrostatic_tank(),     gravity_wave(),    taylor_green(),   layered_flow(),       oscillating_drop(),
        square_patch(),         square_in_air(),   block_impact(),   trapped_air_piston(), ritter(),
        released_column(),      free_flight(),     floating_body(),  heave_decay(),        roll_decay(),
        oscillating_cylinder(), moving_tank()};
    return problems;
}

std::vector<Problem> problems_named(const std::vector<std::string>& names) {
    if (names.empty()) return all_problems();
    std::string known;
    for (const Problem& problem : all_problems()) known += (known.empty() ? "" : ", ") + problem.name;
    for (const std::string& name : names) {
        const bool found = std::any_of(all_problems().begin(), all_problems().end(),
                                       [&](const Problem& problem) { return problem.name == name; });
        if (!found) throw InputError("unknown problem '" + name + "', expected some of " + known);
    }
    std::vector<Problem> chosen;
    for (const Problem& problem : all_problems()) {
        if (std::find(names.begin(), names.end(), problem.name) != names.end()) chosen.push_back(problem);
    }
    return chosen;
}

}  // namespace wetdeck::verification

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/stress/cases.hpp"

#include <algorithm>

#include "solver/core/errors.hpp"

namespace wetdeck::stress {

const std::vector<Case>& all_cases() {
    static const std::vector<Case> cases = [] {
        std::vector<Case> all;
        for (const auto group : {material_cases, entry_cases, free_surface_cases, numerical_cases})
            for (Case& member : group()) all.push_back(std::move(member));
        return all;
    }();
    return cases;
}

std::vector<Case> cases_named(const std::vector<std::string>& names) {
    if (names.empty()) return all_cases();
    std::string known;
    for (const Case& member : all_cases()) known += (known.empty() ? "" : ", ") + member.name;
    for (const std::string& name : names) {
        const bool found = std::any_of(all_cases().begin(), all_cases().end(),
                                       [&](const Case& member) { return member.name == name; });
        if (!found) throw InputError("unknown case '" + name + "', expected some of " + known);
    }
    std::vector<Case> chosen;
    for (const Case& member : all_cases())
        if (std::find(names.begin(), names.end(), member.name) != names.end()) chosen.push_back(member);
    return chosen;
}

}  // namespace wetdeck::stress

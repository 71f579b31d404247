// SPDX-License-Identifier: BSD-3-Clause
// The hard cases, in the order of the report. One file per group.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validation/stress/trial.hpp"

namespace wetdeck::stress {

struct Setting {
    std::string name;
    std::function<Trial(const Scheme&)> build;
    bool quick = false;       ///< part of the fast matrix
    std::string beyond = {};  ///< why survival cannot be asked for; empty: the case is sensible
};

/// A quantity whose limit is searched, with the default scheme.
struct Search {
    std::string name;         ///< what is run
    std::string quantity;     ///< with its unit
    double from = 1, to = 1;  ///< the setting in use, and the far end of the search
    double ratio = 1.1;       ///< how close the limit is wanted
    std::function<Trial(double)> build;
};

struct Case {
    std::string name, title;
    std::vector<Setting> settings;
    std::vector<Search> searches = {};
};

std::vector<Case> material_cases();
std::vector<Case> entry_cases();
std::vector<Case> free_surface_cases();
std::vector<Case> numerical_cases();

const std::vector<Case>& all_cases();

/// Those of these names in the order of the list; all for no name. Throws InputError for an unknown one.
std::vector<Case> cases_named(const std::vector<std::string>& names);

}  // namespace wetdeck::stress

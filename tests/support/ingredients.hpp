// SPDX-License-Identifier: BSD-3-Clause
// Every ingredient of the model that a pass over pairs computes, for tests of the passes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/physics/model.hpp"

namespace wetdeck::samples {

struct Ingredient {
    std::string name;
    std::function<void(Model&)> switch_on;
};

const std::vector<Ingredient>& ingredients();

/// Water and air with viscosities and this ingredient.
Model with(const Ingredient& ingredient);

}  // namespace wetdeck::samples

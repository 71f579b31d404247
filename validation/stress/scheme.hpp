// SPDX-License-Identifier: BSD-3-Clause
// The schemes that the hard cases are run with.
#pragma once

#include <array>
#include <string>

#include "solver/physics/model.hpp"

namespace wetdeck::stress {

enum class Scheme { standard, paper, no_dissipation };
inline constexpr std::array schemes = {Scheme::standard, Scheme::paper, Scheme::no_dissipation};

std::string name_of(Scheme scheme);

/// Changes the ingredients of a model; its materials only where the paper's scheme has air as stiff as the
/// equal-coefficient rule says. The same as the scenes' variants `paper`.
void apply(Scheme scheme, Model& model);

}  // namespace wetdeck::stress

// SPDX-License-Identifier: BSD-3-Clause
// Schemes: named sets of model choices, as data (validation/schemes/NAME.toml). A scene, or one of its
// variants, names its scheme with the key `scheme`; what the variant itself sets comes on top. A scene file
// may define schemes of its own in tables [schemes.NAME].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/physics/model.hpp"

namespace wetdeck {

/// Names of the schemes that come with the program.
std::vector<std::string> scheme_names();

/// The text of a scene file followed by the schemes that it or the overrides name and that it does not define
/// itself, so that a stored text is complete. Throws InputError with file, line and key for a scheme that
/// does not exist.
std::string with_schemes(const std::string& text, const std::string& path,
                         const std::vector<std::string>& overrides);

/// Changes a model to a scheme; an empty name changes nothing. Throws InputError for one that does not exist.
void apply_scheme(const std::string& name, Model& model);

/// The value of the last override `scheme=NAME`, or empty.
std::string scheme_in(const std::vector<std::string>& overrides);

}  // namespace wetdeck

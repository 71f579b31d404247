// SPDX-License-Identifier: BSD-3-Clause
// In which model keys a set-up differs from the scheme of its source. The list follows from the two models,
// so that no scene can state it wrongly.
#pragma once

#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// One key with another value than in the scheme of the source.
struct SchemeDifference {
    std::string key;       ///< "model.smoothing_ratio"
    std::string meaning;   ///< one line
    std::string equation;  ///< of the source, or empty
    std::string source;    ///< value in the scheme of the source
    std::string used;      ///< value in this set-up
};

/// The differences of a scene, as read for one variant, from the scheme that its key `source_scheme` names;
/// none where it names none. Throws InputError for a scheme that does not exist.
std::vector<SchemeDifference> scheme_differences(const Scene& scene);

}  // namespace wetdeck

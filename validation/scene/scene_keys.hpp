// SPDX-License-Identifier: BSD-3-Clause
// Every key of a scene file, for readers: what `wetdeck describe --keys` prints and docs/keys.md holds.
//
// Keys of the model come from the table that reads them (model_keys.hpp). A test compares the others with the
// keys that the sources ask for.
#pragma once

#include <string>
#include <vector>

namespace wetdeck {

struct SceneKey {
    std::string key;       ///< dotted; "[[probes]].name" in a list of tables
    std::string unit;      ///< "-" for a number without one, empty for texts, names and switches
    std::string fallback;  ///< default value, "required", or empty: nothing
    std::string range;     ///< what is expected
    std::string meaning;
    std::string choice;    ///< how to choose it, where that takes a rule
    std::string equation;  ///< of Yang et al. (2020), or empty
};

/// The keys of one section of the reference.
struct SceneKeySection {
    std::string title;
    std::vector<SceneKey> keys;
};

/// All keys, in the order in which a scene file has them.
std::vector<SceneKeySection> scene_keys();

/// The same as tables in Markdown.
std::string scene_keys_markdown();

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The table of the model: one row for each ingredient and number, from which follow the reading of a scene
// file,
// `--set`, the stored parameters, the identity of a run, the list of keys and what `ablate` leaves out.
//
// To add an ingredient, add its row here and its physics in solver/ (see solver/README.md).
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// A value of a key: a switch, a number or a name.
using KeyValue = std::variant<bool, double, std::string>;

/// The value as TOML has it.
std::string toml_text(const KeyValue& value);

/// How `ablate` takes an ingredient out of a scene.
struct Removal {
    std::string ingredient;                                           ///< its name for readers
    std::function<bool(const Scene&)> present;                        ///< whether the scene has it
    std::function<std::vector<std::string>(const Scene&)> overrides;  ///< KEY=VALUE that take it out
};

/// One row: a key of a scene file and the part of the set-up that it sets.
struct ModelKey {
    std::string table;                    ///< "model", "water", "air" or "execution"
    std::string key;                      ///< within its table
    std::string meaning;                  ///< one line
    std::string unit;                     ///< "-" for none; empty for names and switches
    std::string equation;                 ///< of Yang et al. (2020), or empty
    std::vector<std::string> names = {};  ///< the values of a key that takes a name
    double low = 0, high = std::numeric_limits<double>::infinity();  ///< closed range of a number
    bool odd = false;                                                ///< a whole odd number, or 0
    std::string default_note = {};  ///< where the default depends on the scene
    std::function<KeyValue(const Scene&)> get = {};
    std::function<void(Scene&, const KeyValue&)> set = {};
    std::optional<Removal> removal = std::nullopt;

    /// "table.key".
    std::string dotted() const { return table + "." + key; }
    /// "one of a, b", "true or false", "0 to 1".
    std::string expected() const;
};

/// All rows, in the order in which `ablate` takes ingredients out.
const std::vector<ModelKey>& model_keys();

/// Reads the keys of one table that the file gives. Throws InputError with file, line and key for a value out
/// of range.
void read_model_keys(const TomlTable& table, const std::string& name, Scene& scene);

/// Every key with its value in this scene, defaults included; those of [air] where the scene has air.
std::vector<std::pair<std::string, KeyValue>> parameters_of(const Scene& scene);

}  // namespace wetdeck

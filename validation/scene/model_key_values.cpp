// SPDX-License-Identifier: BSD-3-Clause
// The values of the model's keys: as a scene file gives them, and as texts.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "validation/scene/model_keys.hpp"

namespace wetdeck {
namespace {

/// The value that the table gives for a row.
KeyValue read_value(const TomlTable& table, const ModelKey& row, const KeyValue& fallback) {
    if (!row.names.empty()) return table.choice(row.key, row.names);
    if (std::holds_alternative<bool>(fallback)) return table.boolean_or(row.key, std::get<bool>(fallback));
    const double value = table.number(row.key);
    const bool in_range = value >= row.low && value <= row.high;
    const bool fits = !row.odd || value == 0 || std::fmod(value, 2) == 1;
    if (!in_range || !fits) table.fail(row.key, fmt::format("is {}, expected {}", value, row.expected()));
    return value;
}

}  // namespace

std::string toml_text(const KeyValue& value) {
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    return std::get<std::string>(value);
}

std::string ModelKey::expected() const {
    if (!names.empty()) return fmt::format("one of {}", fmt::join(names, ", "));
    if (unit.empty()) return "true or false";
    if (odd) return fmt::format("an odd number up to {}, or 0", high);
    if (std::isinf(high)) return low == 0 ? "zero or a positive number" : fmt::format("at least {}", low);
    return low > 0 && low < 1e-6 ? fmt::format("above 0 and at most {}", high)
                                 : fmt::format("{} to {}", low, high);
}

void read_model_keys(const TomlTable& table, const std::string& name, Scene& scene) {
    for (const ModelKey& row : model_keys()) {
        if (row.table == name && table.has(row.key)) row.set(scene, read_value(table, row, row.get(scene)));
    }
}

std::vector<std::pair<std::string, KeyValue>> parameters_of(const Scene& scene) {
    std::vector<std::pair<std::string, KeyValue>> parameters;
    for (const ModelKey& row : model_keys())
        if (row.table != "air" || scene.air) parameters.emplace_back(row.dotted(), row.get(scene));
    return parameters;
}

}  // namespace wetdeck

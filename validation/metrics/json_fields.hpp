// SPDX-License-Identifier: BSD-3-Clause
// Numbers in JSON, which has no NaN: what is unknown or no number is null.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace wetdeck {

inline nlohmann::json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

inline nlohmann::json numbers(const std::vector<double>& values) {
    nlohmann::json list = nlohmann::json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}

}  // namespace wetdeck

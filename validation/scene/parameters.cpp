// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/scene/axes.hpp"

namespace wetdeck {
namespace {

/// Runs what may throw an InputError about the entry.
template <class Action>
auto about(const TomlTable& table, const std::string& key, const Action& action) {
    try {
        return action();
    } catch (const InputError& error) {
        table.fail(key, error.what());
    }
}

}  // namespace

Expressions read_parameters(const TomlTable& table) {
    Expressions expressions;
    std::vector<std::string> waiting;
    for (const std::string& key : table.keys()) {
        if (table.holds_expression(key))
            waiting.push_back(key);
        else
            about(table, key, [&] { expressions.define(key, read_measured_value(table, key).number); });
    }
    while (!waiting.empty()) {
        const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](const std::string& key) {
            return about(table, key,
                         [&] { return expressions.unknown_names(table.expression(key)).empty(); });
        });
        const std::string key = ready == waiting.end() ? waiting.front() : *ready;
        about(table, key, [&] {  // throws where a name is unknown
            expressions.define(key, expressions.value(table.expression(key)));
        });
        waiting.erase(ready);
    }
    return expressions;
}

}  // namespace wetdeck

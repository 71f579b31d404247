// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "solver/core/errors.hpp"
#include "validation/scene/toml_node.hpp"

namespace wetdeck {
namespace {

/// Whether one letter added, dropped or swapped with its neighbour makes one word the other; a changed one
/// would take y_column for x_column.
bool is_slip_of(std::string given, std::string meant) {
    if (given.size() < meant.size()) std::swap(given, meant);
    if (given.size() - meant.size() > 1) return false;
    const auto [a, b] = std::mismatch(given.begin(), given.end(), meant.begin(), meant.end());
    const std::string_view rest(a, given.end()), other(b, meant.end());
    if (given.size() > meant.size()) return rest.substr(1) == other;
    return rest.size() > 1 && rest[0] == other[1] && rest[1] == other[0] && rest.substr(2) == other.substr(2);
}

/// The number of an entry of that key, computed where it is an expression; empty where it is none.
std::optional<double> number_in(const TomlTable& table, const std::string& key, const toml::node& entry,
                                const Expressions& expressions) {
    try {
        return number_in(entry, expressions);
    } catch (const InputError& error) {
        table.fail(key, error.what());
    }
}

}  // namespace

std::string TomlTable::place_of(const std::string& key) const {
    const toml::node* entry = node_->table->get(key);
    const toml::source_region& region = entry ? entry->source() : node_->table->source();
    return fmt::format("{}: key '{}{}'", place(*node_->path, region), node_->prefix, key);
}

void TomlTable::fail(const std::string& key, const std::string& message) const {
    throw InputError(fmt::format("{}: {}", place_of(key), message));
}

void TomlTable::fail_missing(const std::string& key, const std::string& expected) const {
    for (const auto& [name, value] : *node_->table) {
        const std::string given(name.str());
        if (!node_->known.count(given) && is_slip_of(given, key))
            fail(given, fmt::format("unknown; '{}' is missing, {}", key, expected));
    }
    fail(key, "missing, " + expected);
}

bool TomlTable::has(const std::string& key) const {
    node_->known.insert(key);
    return node_->table->contains(key);
}

bool TomlTable::holds_text(const std::string& key) const {
    return has(key) && node_->table->get(key)->is_string() && !holds_expression(key);
}

bool TomlTable::holds_expression(const std::string& key) const {
    return has(key) && node_->table->get(key)->is_string() &&
           is_expression(node_->table->get(key)->as_string()->get());
}

std::string TomlTable::expression(const std::string& key) const {
    return node_->table->get(key)->as_string()->get();
}

bool TomlTable::is_number(const std::string& key) const {
    return has(key) && (node_->table->get(key)->is_number() || holds_expression(key));
}

bool TomlTable::is_table(const std::string& key) const {
    return has(key) && node_->table->get(key)->is_table();
}

std::optional<double> TomlTable::optional_number(const std::string& key) const {
    if (!has(key)) return std::nullopt;
    const std::optional<double> value = number_in(*this, key, *node_->table->get(key), *node_->expressions);
    if (!value || !std::isfinite(*value)) fail(key, "expected a finite number");
    return value;
}

double TomlTable::number(const std::string& key) const {
    const std::optional<double> value = optional_number(key);
    if (!value) fail_missing(key, "expected a number");
    return *value;
}

double TomlTable::number_or(const std::string& key, double fallback) const {
    return optional_number(key).value_or(fallback);
}

double TomlTable::positive(const std::string& key) const {
    const double value = number(key);
    if (!(value > 0)) fail(key, fmt::format("is {}, expected a positive number", value));
    return value;
}

bool TomlTable::boolean_or(const std::string& key, bool fallback) const {
    if (!has(key)) return fallback;
    const std::optional<bool> value = node_->table->get(key)->value_exact<bool>();
    if (!value) fail(key, "expected true or false");
    return *value;
}

std::string TomlTable::text(const std::string& key) const {
    if (!has(key)) fail_missing(key, "expected a text");
    const std::optional<std::string> value = node_->table->get(key)->value_exact<std::string>();
    if (!value) fail(key, "expected a text in quotes");
    try {
        return node_->expressions->filled(*value);
    } catch (const InputError& error) {
        fail(key, error.what());
    }
}

std::string TomlTable::text_or(const std::string& key, const std::string& fallback) const {
    return has(key) ? text(key) : fallback;
}

std::string TomlTable::choice(const std::string& key, const std::vector<std::string>& names,
                              const std::optional<std::string>& fallback) const {
    if (fallback && !has(key)) return *fallback;
    const std::string value = text(key);
    if (std::find(names.begin(), names.end(), value) == names.end()) {
        fail(key, names.empty() ? fmt::format("is '{}', and the file defines no such name", value)
                                : fmt::format("is '{}', expected one of {}", value, fmt::join(names, ", ")));
    }
    return value;
}

std::vector<double> TomlTable::numbers(const std::string& key, std::optional<std::size_t> count) const {
    const std::string expected = count ? fmt::format("expected a list of {} numbers", *count)
                                       : std::string("expected a list of numbers");
    if (!has(key)) fail_missing(key, expected);
    const toml::array* array = node_->table->get(key)->as_array();
    if (!array || (count && array->size() != *count)) fail(key, expected);
    std::vector<double> values;
    for (const toml::node& entry : *array) {
        const std::optional<double> value = number_in(*this, key, entry, *node_->expressions);
        if (!value || !std::isfinite(*value)) fail(key, expected);
        values.push_back(*value);
    }
    return values;
}

std::vector<std::vector<double>> TomlTable::number_rows(const std::string& key, std::size_t count) const {
    const std::string expected = fmt::format("expected a list of lists of {} numbers", count);
    if (!has(key)) fail_missing(key, expected);
    const toml::array* array = node_->table->get(key)->as_array();
    if (!array) fail(key, expected);
    std::vector<std::vector<double>> rows;
    for (const toml::node& entry : *array) {
        const toml::array* row = entry.as_array();
        if (!row || row->size() != count) fail(key, expected);
        rows.emplace_back();
        for (const toml::node& cell : *row) {
            const std::optional<double> value = number_in(*this, key, cell, *node_->expressions);
            if (!value || !std::isfinite(*value)) fail(key, expected);
            rows.back().push_back(*value);
        }
    }
    return rows;
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
    if (!has(key)) return {};
    const toml::array* array = node_->table->get(key)->as_array();
    if (!array) fail(key, "expected a list of texts");
    std::vector<std::string> values;
    for (const toml::node& entry : *array) {
        const std::optional<std::string> value = entry.value_exact<std::string>();
        if (!value) fail(key, "expected a list of texts");
        values.push_back(*value);
    }
    return values;
}

std::optional<TomlTable> TomlTable::optional_table(const std::string& key) const {
    if (!has(key)) return std::nullopt;
    const toml::table* child = node_->table->get(key)->as_table();
    if (!child) fail(key, "expected a table");
    return TomlTable(
        std::make_shared<Node>(Node{child, node_->prefix + key + ".", node_->path, {}, node_->expressions}));
}

TomlTable TomlTable::table(const std::string& key) const {
    std::optional<TomlTable> child = optional_table(key);
    if (!child) fail_missing(key, "expected a table");
    return *child;
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
    if (!has(key)) return {};
    const toml::array* array = node_->table->get(key)->as_array();
    if (!array) fail(key, "expected an array of tables");
    std::vector<TomlTable> children;
    for (const toml::node& entry : *array) {
        if (!entry.is_table()) fail(key, "expected an array of tables");
        const std::string prefix = fmt::format("{}{}[{}].", node_->prefix, key, children.size());
        children.push_back(TomlTable(
            std::make_shared<Node>(Node{entry.as_table(), prefix, node_->path, {}, node_->expressions})));
    }
    return children;
}

std::string TomlTable::text_of(const std::string& key) const {
    if (!has(key)) return {};
    toml::table alone;
    alone.insert(key, *node_->table->get(key));
    std::ostringstream out;
    out << toml::toml_formatter(evaluated(alone, *node_->expressions));
    return out.str();
}

const Expressions& TomlTable::expressions() const {
    return *node_->expressions;
}

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::pair<unsigned, std::string>> lines;
    for (const auto& [key, value] : *node_->table)
        lines.emplace_back(value.source().begin.line, std::string(key.str()));
    std::sort(lines.begin(), lines.end());
    std::vector<std::string> names;
    for (auto& [line, name] : lines) names.push_back(std::move(name));
    return names;
}

void TomlTable::finish() const {
    for (const std::string& key : keys()) {
        if (node_->known.count(key)) continue;
        fail(key, fmt::format("unknown, expected one of {}", fmt::join(node_->known, ", ")));
    }
}

}  // namespace wetdeck

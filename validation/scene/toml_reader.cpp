// SPDX-License-Identifier: BSD-3-Clause
// toml++ 3.3 aborts on some malformed input where assertions are on; with NDEBUG it reports a parse error.
#ifndef NDEBUG
#define NDEBUG
#endif
#define TOML_ENABLE_FORMATTERS 1
#include "validation/scene/toml_reader.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "solver/core/errors.hpp"

namespace wetdeck {

struct TomlTable::Node {
    const toml::table* table = nullptr;
    std::string prefix;  ///< dotted path with a trailing dot, or empty
    std::shared_ptr<const std::string> path;
    std::set<std::string> known;
};

struct TomlDocument::State {
    toml::table root;
    std::string text;
    std::shared_ptr<const std::string> path;
};

namespace {

std::string place(const std::string& path, const toml::source_region& region) {
    if (region.path && *region.path != path) return *region.path;  // from the command line
    return region.begin.line > 0 ? fmt::format("{}:{}", path, region.begin.line) : path;
}

/// Moves the entries of `source`: a copy would forget where in the file they stand.
void merge(toml::table& target, toml::table& source) {
    for (auto&& [key, value] : source) {
        toml::node* existing = target.get(key.str());
        if (existing && existing->is_table() && value.is_table()) {
            merge(*existing->as_table(), *value.as_table());
        } else {
            const toml::key& name = key;  // clang 14 cannot capture a structured binding
            value.visit([&](auto& entry) { target.insert_or_assign(name.str(), std::move(entry)); });
        }
    }
}

toml::table parse(const std::string& text, const std::string& path) {
    try {
        return toml::parse(text, path);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}: {}", place(path, error.source()), error.description()));
    }
}

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

}  // namespace

// --- tables
// ---------------------------------------------------------------------------------------------------------

void TomlTable::fail(const std::string& key, const std::string& message) const {
    const toml::node* entry = node_->table->get(key);
    const toml::source_region& region = entry ? entry->source() : node_->table->source();
    throw InputError(
        fmt::format("{}: key '{}{}': {}", place(*node_->path, region), node_->prefix, key, message));
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

std::optional<double> TomlTable::optional_number(const std::string& key) const {
    if (!has(key)) return std::nullopt;
    const std::optional<double> value = node_->table->get(key)->value<double>();
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
    return *value;
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
        const std::optional<double> value = entry.value<double>();
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
            const std::optional<double> value = cell.value<double>();
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
    return TomlTable(std::make_shared<Node>(Node{child, node_->prefix + key + ".", node_->path, {}}));
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
        children.push_back(
            TomlTable(std::make_shared<Node>(Node{entry.as_table(), prefix, node_->path, {}})));
    }
    return children;
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

// --- document
// -------------------------------------------------------------------------------------------------------

TomlDocument::TomlDocument(const std::string& text, const std::string& path)
    : state_(std::make_unique<State>(
          State{parse(text, path), text, std::make_shared<const std::string>(path)})) {}
TomlDocument::~TomlDocument() = default;
TomlDocument::TomlDocument(TomlDocument&&) noexcept = default;

void TomlDocument::overlay(const std::vector<std::string>& path_to_table, Overlay entries) {
    toml::table again = parse(state_->text, *state_->path);
    toml::table* source = &again;
    for (const std::string& key : path_to_table) {
        toml::node* child = source->get(key);
        if (!child || !child->is_table())
            throw InputError(fmt::format("{}: no table '{}'", *state_->path, key));
        source = child->as_table();
    }
    if (entries == Overlay::all) return merge(state_->root, *source);
    for (auto&& [key, value] : *source) {
        toml::node* existing = state_->root.get(key.str());
        if (existing && existing->is_table() && value.is_table())
            merge(*existing->as_table(), *value.as_table());
    }
}

namespace {

/// The table that holds the last key of a dotted path, and that key.
std::pair<toml::table*, std::string> holder_of(toml::table& root, const std::string& dotted, bool create) {
    toml::table* table = &root;
    std::size_t begin = 0;
    for (std::size_t dot = dotted.find('.'); dot != std::string::npos; dot = dotted.find('.', begin)) {
        const std::string key = dotted.substr(begin, dot - begin);
        if (create && !table->contains(key)) table->insert(key, toml::table{});
        toml::node* child = table->get(key);
        if (!child || !child->is_table()) return {nullptr, ""};
        table = child->as_table();
        begin = dot + 1;
    }
    return {table, dotted.substr(begin)};
}

std::string text_of(const toml::table& table) {
    std::ostringstream out;
    out << toml::toml_formatter(table) << '\n';
    return out.str();
}

}  // namespace

std::optional<std::string> TomlDocument::rename(const std::string& old_key, const std::string& new_key,
                                                bool may_replace) {
    const auto [from, old_name] = holder_of(state_->root, old_key, false);
    if (!from || !from->contains(old_name)) return std::nullopt;
    const std::string where = place(*state_->path, from->get(old_name)->source());
    const auto [to, new_name] = holder_of(state_->root, new_key, true);
    if (!to || (to->contains(new_name) && !may_replace))
        throw InputError(
            fmt::format("{}: key '{}': is called '{}' now, and both are given", where, old_key, new_key));
    toml::table* const target = to;  // clang 14 cannot capture a structured binding
    const std::string name = new_name;
    from->get(old_name)->visit([&](auto& entry) { target->insert_or_assign(name, std::move(entry)); });
    from->erase(old_name);
    return fmt::format("{}: key '{}' is called '{}' now; the old name is read for one more release", where,
                       old_key, new_key);
}

std::string TomlDocument::nested_in(const std::vector<std::string>& path_to_table) const {
    toml::table nested = state_->root;
    for (auto key = path_to_table.rbegin(); key != path_to_table.rend(); ++key) {
        toml::table outer;
        outer.insert(*key, std::move(nested));
        nested = std::move(outer);
    }
    return text_of(nested);
}

std::string TomlDocument::array_text(const std::string& key, const std::vector<std::string>& without) const {
    const toml::array* array = state_->root.get_as<toml::array>(key);
    if (!array) return "";
    std::string all;
    for (const toml::node& entry : *array) {
        if (!entry.is_table()) continue;
        toml::table table = *entry.as_table();
        for (const std::string& name : without) table.erase(name);
        all += text_of(table);
    }
    return all;
}

namespace {

/// Position in the text of a line and a column, both from 1; columns count code points.
std::size_t byte_at(const std::string& text, const toml::source_position& position) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
    for (toml::source_index column = 1; column < position.column; ++column) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
    }
    return at;
}

void collect_texts(const toml::table& table, const std::string& wanted, const std::string& prefix,
                   const std::string& text, std::vector<TomlDocument::TextValue>& found) {
    for (const auto& [key, value] : table) {
        const std::string name = prefix + std::string(key.str());
        if (value.is_table()) {
            collect_texts(*value.as_table(), wanted, name + ".", text, found);
        } else if (value.is_string() && key.str() == wanted) {
            const toml::source_region& region = value.source();
            if (region.begin.line != region.end.line) continue;
            found.push_back({name, value.as_string()->get(), region.begin.line, byte_at(text, region.begin),
                             byte_at(text, region.end)});
        }
    }
}

}  // namespace

std::vector<TomlDocument::TextValue> TomlDocument::texts_named(const std::string& key) const {
    std::vector<TextValue> found;
    collect_texts(state_->root, key, "", state_->text, found);
    std::sort(found.begin(), found.end(),
              [](const TextValue& a, const TextValue& b) { return a.begin < b.begin; });
    return found;
}

void TomlDocument::set(const std::string& assignment) {
    const std::string where = fmt::format("option --set {}", assignment);
    const std::size_t equals = assignment.find('=');
    const bool one_line = assignment.find('\n') == std::string::npos;
    if (equals == std::string::npos || equals == 0 || !one_line)
        throw InputError(where + ": expected KEY=VALUE");
    toml::table parsed;
    try {
        parsed = toml::parse(assignment, where);
    } catch (const toml::parse_error&) {
        // a bare word is a text
        const std::string value = assignment.substr(equals + 1);
        if (value.find_first_of("\"'\\") != std::string::npos)
            throw InputError(where + ": the value is not valid TOML");
        parsed = parse(fmt::format("{}=\"{}\"", assignment.substr(0, equals), value), where);
    }
    merge(state_->root, parsed);
}

TomlTable TomlDocument::root() const {
    return TomlTable(std::make_shared<TomlTable::Node>(TomlTable::Node{&state_->root, "", state_->path, {}}));
}

std::string TomlDocument::resolved() const {
    std::ostringstream out;
    out << toml::toml_formatter(state_->root);
    return out.str();
}

}  // namespace wetdeck

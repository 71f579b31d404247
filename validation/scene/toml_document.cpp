// SPDX-License-Identifier: BSD-3-Clause
// The document of a scene file: parsing, overlays, renamed keys, overrides.
#include <algorithm>
#include <map>
#include <sstream>

#include "solver/core/errors.hpp"
#include "validation/scene/parameters.hpp"
#include "validation/scene/toml_node.hpp"

namespace wetdeck {

struct TomlDocument::State {
    toml::table root;
    std::string text;
    std::shared_ptr<const std::string> path;
};

namespace {

/// Place of an entry of an array: of the table with that name, or by its number from 0.
toml::array::iterator entry_of(toml::array& array, const std::string& key) {
    if (!array.is_array_of_tables()) {
        const bool number = !key.empty() && key.size() < 6 &&
                            std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
        const std::size_t place = number ? std::stoul(key) : array.size();
        return place < array.size() ? array.begin() + static_cast<std::ptrdiff_t>(place) : array.end();
    }
    return std::find_if(array.begin(), array.end(), [&](const toml::node& entry) {
        return entry.as_table()->get("name") && entry.as_table()->get("name")->value_or(std::string()) == key;
    });
}

void merge(toml::table& target, toml::table& source, const std::string& where);

/// Replaces or merges entries of an array, as `--set probes.gauge.centre.1=0.3` asks for.
void merge_entries(toml::array& target, toml::table& source, const std::string& where) {
    for (auto&& [key, value] : source) {
        const std::string name(key.str());
        const toml::array::iterator entry = entry_of(target, name);
        if (entry == target.end())
            throw InputError(fmt::format("{}: no entry '{}', expected {}", where, name,
                                         target.is_array_of_tables()
                                             ? "the name of one"
                                             : fmt::format("a number from 0 to {}", target.size() - 1)));
        if (entry->is_table() && value.is_table()) {
            merge(*entry->as_table(), *value.as_table(), where);
        } else if (entry->is_array() && value.is_table()) {
            merge_entries(*entry->as_array(), *value.as_table(), where);
        } else {
            value.visit([&](auto& other) { target.insert(target.erase(entry), std::move(other)); });
        }
    }
}

/// Moves the entries of `source`: a copy would forget where in the file they stand.
/// @param where  for the message where an array has no such entry
void merge(toml::table& target, toml::table& source, const std::string& where) {
    for (auto&& [key, value] : source) {
        toml::node* existing = target.get(key.str());
        if (existing && existing->is_table() && value.is_table()) {
            merge(*existing->as_table(), *value.as_table(), where);
        } else if (existing && existing->is_array() && value.is_table()) {
            merge_entries(*existing->as_array(), *value.as_table(), where);
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

}  // namespace

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
    if (entries == Overlay::all) return merge(state_->root, *source, *state_->path);
    for (auto&& [key, value] : *source) {
        toml::node* existing = state_->root.get(key.str());
        if (existing && existing->is_table() && value.is_table())
            merge(*existing->as_table(), *value.as_table(), *state_->path);
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
        all += text_of(evaluated(table, *root().node_->expressions));
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
        } else if (const toml::array* entries = value.as_array()) {
            for (std::size_t k = 0; k < entries->size(); ++k)
                if (const toml::table* entry = (*entries)[k].as_table())
                    collect_texts(*entry, wanted, fmt::format("{}[{}].", name, k), text, found);
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
    merge(state_->root, parsed, where);
}

namespace {

/// The number of a node that is an expression; empty for any other, also for a text that only looks like one.
std::optional<double> number_of_expression(const toml::node& node, const Expressions& expressions) {
    if (!node.is_string() || !is_expression(node.as_string()->get())) return std::nullopt;
    try {
        return number_in(node, expressions);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// Puts numbers in the place of all expressions below a node, where there are parameters: without them no
/// number can change behind a text.
void evaluate(toml::node& node, const Expressions& expressions) {
    if (expressions.parameters().empty()) return;
    if (toml::table* table = node.as_table()) {
        std::map<std::string, double> computed;
        for (auto&& [key, value] : *table) {
            if (const auto number = number_of_expression(value, expressions))
                computed[std::string(key.str())] = *number;
            else
                evaluate(value, expressions);
        }
        for (const auto& [key, number] : computed) table->insert_or_assign(key, number);
    } else if (toml::array* entries = node.as_array()) {
        for (std::size_t k = 0; k < entries->size(); ++k) {
            if (const auto number = number_of_expression((*entries)[k], expressions))
                entries->insert(entries->erase(entries->begin() + static_cast<std::ptrdiff_t>(k)), *number);
            else
                evaluate((*entries)[k], expressions);
        }
    }
}

}  // namespace

toml::table evaluated(const toml::table& table, const Expressions& expressions) {
    toml::table copy = table;
    evaluate(copy, expressions);
    return copy;
}

TomlTable TomlDocument::root() const {
    const auto table_with = [this](std::shared_ptr<const Expressions> expressions) {
        return TomlTable(std::make_shared<TomlTable::Node>(
            TomlTable::Node{&state_->root, "", state_->path, {}, std::move(expressions)}));
    };
    const TomlTable plain = table_with(std::make_shared<const Expressions>());
    const std::optional<TomlTable> parameters = plain.optional_table("parameters");
    if (!parameters) return plain;
    return table_with(std::make_shared<const Expressions>(read_parameters(*parameters)));
}

std::string TomlDocument::resolved() const {
    toml::table copy = state_->root;
    const TomlTable table = root();
    for (auto&& [key, value] : copy)  // variants and schemes that were not laid over stay as they are
        if (key.str() != "variants" && key.str() != "schemes") evaluate(value, *table.node_->expressions);
    std::ostringstream out;
    out << toml::toml_formatter(copy);
    return out.str();
}

}  // namespace wetdeck

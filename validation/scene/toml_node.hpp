// SPDX-License-Identifier: BSD-3-Clause
// What the tables and the document of toml_reader.hpp share. Included by toml_reader.cpp and
// toml_document.cpp alone: all of toml++ stays there.
#pragma once

// toml++ 3.3 aborts on some malformed input where assertions are on; with NDEBUG it reports a parse error.
#ifndef NDEBUG
#define NDEBUG
#endif
#define TOML_ENABLE_FORMATTERS 1
#include <fmt/format.h>

#include <toml++/toml.h>
#include <set>

#include "validation/scene/expressions.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

struct TomlTable::Node {
    const toml::table* table = nullptr;
    std::string prefix;  ///< dotted path with a trailing dot, or empty
    std::shared_ptr<const std::string> path;
    std::set<std::string> known;
    std::shared_ptr<const Expressions> expressions;  ///< of the whole document
};

/// The number of an entry, computed where it is an expression; empty where it is none. Throws InputError as
/// Expressions::value().
inline std::optional<double> number_in(const toml::node& entry, const Expressions& expressions) {
    const toml::value<std::string>* text = entry.as_string();
    return text && is_expression(text->get()) ? expressions.value(text->get()) : entry.value<double>();
}

/// A copy of a table in which every expression is replaced by its number, where the document has parameters.
toml::table evaluated(const toml::table& table, const Expressions& expressions);

/// "FILE:LINE" of an entry; "option --set KEY=VALUE" for one from the command line.
inline std::string place(const std::string& path, const toml::source_region& region) {
    if (region.path && *region.path != path) return *region.path;  // from the command line
    return region.begin.line > 0 ? fmt::format("{}:{}", path, region.begin.line) : path;
}

}  // namespace wetdeck

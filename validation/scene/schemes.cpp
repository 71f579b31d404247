// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/schemes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "solver/core/errors.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/sections.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {
namespace {

constexpr std::string_view override_key = "scheme=";

std::string read_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw EnvironmentError(fmt::format("{}: cannot be read", path.string()));
    return text.str();
}

/// A scheme that comes with the program. Throws InputError for a key that is no part of a scheme.
TomlDocument read_scheme(const std::string& name) {
    const std::filesystem::path path = scheme_directory() / (name + ".toml");
    TomlDocument scheme(read_text(path), path.string());
    const TomlTable root = scheme.root();
    root.text("description");
    for (const char* table : {"model", "water", "air", "execution"}) root.has(table);
    root.finish();
    return scheme;
}

bool is_known(const std::string& name) {
    const std::vector<std::string> known = scheme_names();
    return std::find(known.begin(), known.end(), name) != known.end();
}

}  // namespace

std::vector<std::string> scheme_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(scheme_directory()))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

std::string scheme_in(const std::vector<std::string>& overrides) {
    std::string name;
    for (const std::string& assignment : overrides)
        if (assignment.starts_with(override_key)) name = assignment.substr(override_key.size());
    std::erase_if(name, [](char c) { return c == '"' || c == '\''; });
    return name;
}

void apply_scheme(const std::string& name, Model& model) {
    if (name.empty()) return;
    if (!is_known(name))
        throw InputError(
            fmt::format("no scheme '{}', expected one of {}", name, fmt::join(scheme_names(), ", ")));
    const TomlDocument scheme = read_scheme(name);
    const TomlTable root = scheme.root();
    Scene scene;
    scene.model = model;
    read_model_keys(root.table("model"), "model", scene);
    model = scene.model;
    if (const auto air = root.optional_table("air")) read_air_law(*air, model);
}

std::string with_schemes(const std::string& text, const std::string& path,
                         const std::vector<std::string>& overrides) {
    const TomlDocument document(text, path);
    std::set<std::string> defined;
    if (const auto schemes = document.root().optional_table("schemes"))
        for (const std::string& name : schemes->keys()) defined.insert(name);
    std::string all = text;
    const auto add = [&](const std::string& name, const std::string& where) {
        if (name.empty() || !defined.insert(name).second) return;
        if (!is_known(name))
            throw InputError(fmt::format("{}: is '{}', expected one of {}, or a table [schemes.{}]", where,
                                         name, fmt::join(scheme_names(), ", "), name));
        all += (all.ends_with('\n') ? "\n" : "\n\n") + read_scheme(name).nested_in({"schemes", name});
    };
    for (const TomlDocument::TextValue& value : document.texts_named("scheme"))
        add(value.value, fmt::format("{}:{}: key '{}'", path, value.line, value.key));
    add(scheme_in(overrides), "option --set scheme");
    return all;
}

}  // namespace wetdeck

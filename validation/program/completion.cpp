// SPDX-License-Identifier: BSD-3-Clause
#include "validation/program/completion.hpp"

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/program/command_line.hpp"
#include "validation/scene/scene.hpp"
#include "validation/stress/cases.hpp"
#include "validation/verification/problems.hpp"

namespace wetdeck {
namespace {

using Words = std::vector<std::string>;

template <class List>
Words names_of(const List& list) {
    Words names;
    for (const auto& entry : list) names.push_back(entry.name);
    return names;
}

/// The variants of the scene that one of the words names.
Words variants_of_scene_in(const Words& words) {
    for (const std::string& word : words) {
        try {
            return names_of(read_scene(find_scene(word)).variants);
        } catch (const InputError&) {
        }
    }
    return {};
}

/// The values that an option accepts, known by the name of its value in the help, and an argument by its own
/// name.
/// @param words  of the line
Words values_of(const OptionInfo& option, const Words& words) {
    if (!option.choices.empty()) return option.choices;
    const std::string kind = option.positional ? option.name : option.value.substr(0, option.value.find(','));
    if (kind == "scene" || kind == "SCENE") return scene_names();
    if (kind == "VARIANT") return variants_of_scene_in({words.begin() + 1, words.end() - 1});
    if (kind == "TIER") return {"quick", "standard", "paper"};
    if (kind == "PROBLEM") return names_of(verification::all_problems());
    if (kind == "CASE") return names_of(stress::all_cases());
    return {};
}

bool has_name(const OptionInfo& option, const std::string& name) {
    return !option.positional && (option.name == name || option.name.ends_with(" " + name));
}

/// All words that may stand in place of the last one.
Words candidates(const Words& words) {
    const std::vector<CommandInfo> commands = command_list();
    const std::string name = words.size() > 1 ? words.front() : "";
    const auto command =
        std::find_if(commands.begin(), commands.end(), [&](const CommandInfo& c) { return c.name == name; });
    if (command == commands.end()) return {};
    if (words.size() > 1) {
        for (const OptionInfo& option : command->options)
            if (has_name(option, words[words.size() - 2]) && !option.value.empty())
                return values_of(option, words);
    }
    if (words.back().starts_with('-')) {
        Words names;
        for (const OptionInfo& option : command->options)
            if (!option.positional) names.push_back(option.name.substr(option.name.rfind(' ') + 1));
        return names;
    }
    if (command->name.empty()) return names_of(std::vector(commands.begin() + 1, commands.end()));
    const std::vector<OptionInfo>& options = command->options;  // positional ones first
    return !options.empty() && options.front().positional ? values_of(options.front(), words) : Words{};
}

}  // namespace

Words completions(const Words& words) {
    if (words.empty()) return {};
    // in a list, what stands before the last comma stays
    const std::size_t comma = words.back().rfind(',');
    const std::string kept = comma == std::string::npos ? "" : words.back().substr(0, comma + 1);
    Words fitting;
    for (const std::string& candidate : candidates(words))
        if ((kept + candidate).starts_with(words.back())) fitting.push_back(kept + candidate);
    return fitting;
}

}  // namespace wetdeck

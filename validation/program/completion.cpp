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

/// The variants of the scene that the line names, if it can be read.
Words variants_on(const Words& words) {
    for (const std::string& word : words) {
        try {
            return names_of(read_scene(find_scene(word)).variants);
        } catch (const InputError&) {
        }
    }
    return {};
}

Words values_of(const std::string& command, const std::string& option, const Words& words) {
    if (option == "--tier") return {"quick", "standard", "paper"};
    if (option == "--executor") return {"local", "slurm"};
    if (option == "--variant") return variants_on({words.begin() + 1, words.end() - 1});
    if (option != "--only") return {};
    if (command == "verify") return names_of(verification::all_problems());
    if (command == "stress") return names_of(stress::all_cases());
    return scene_names();
}

Words positional_values(const std::string& command) {
    if (command == "baseline") return {"write", "compare"};
    if (command == "run" || command == "ablate" || command == "describe") return scene_names();
    return {};
}

Words candidates(const Words& words) {
    const std::vector<CommandInfo> commands = command_list();
    const auto named = [&](const std::string& name) {
        return std::find_if(commands.begin(), commands.end(),
                            [&](const CommandInfo& c) { return c.name == name; });
    };
    const auto command = named(words.size() > 1 ? words.front() : "");
    if (command == commands.end()) return {};
    const auto has_name = [](const OptionInfo& option, const std::string& name) {
        return !option.positional && (option.name == name || option.name.ends_with(" " + name));
    };
    if (words.size() > 1) {
        const std::string& before = words[words.size() - 2];
        for (const OptionInfo& option : command->options)
            if (has_name(option, before) && !option.value.empty())
                return values_of(command->name, before, words);
    }
    Words all;
    if (words.back().starts_with('-')) {
        for (const OptionInfo& option : command->options)
            if (!option.positional) all.push_back(option.name.substr(option.name.rfind(' ') + 1));
    } else if (command->name.empty()) {
        all = names_of(std::vector(commands.begin() + 1, commands.end()));
    } else {
        all = positional_values(command->name);
    }
    return all;
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

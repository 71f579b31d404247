// SPDX-License-Identifier: BSD-3-Clause
#include "validation/program/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "validation/commands/commands.hpp"
#include "validation/run/exit_code.hpp"

namespace wetdeck {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done and within tolerance, 1 outside a stated tolerance, 2 bad usage or input,\n"
    "3 a run became unstable, 4 the environment failed (disk full, no permission),\n"
    "130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM.";

std::unique_ptr<CLI::App> command_line(int& exit_code) {
    auto app = std::make_unique<CLI::App>(
        "wetdeck: two-phase SPH of bodies that slam into water, checked against experiments and exact "
        "solutions",
        "wetdeck");
    app->require_subcommand(0, 1);
    add_version(*app);
    app->footer(exit_codes);  // handed down to the commands
    add_commands(*app, exit_code);
    app->footer(
        std::string(exit_codes) +
        "\nAfter a signal run, resume, suite and ablate write a checkpoint of each run and print how to\n"
        "continue (`wetdeck resume RUN_DIR`, or the same command again). A second signal ends the program\n"
        "at once; then, as after kill -9 or a power failure, a run continues from its last periodic\n"
        "checkpoint.\n"
        "\nCommands of the script ./wetdeck at the root of the sources:\n"
        "  test                        build and run all tests\n"
        "  docs                        make the API pages");
    app->callback([program = app.get()] {
        if (program->get_subcommands().empty()) fmt::print("{}", program->help());
    });
    return app;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

const std::vector<std::string> commands_of_script = {"test", "docs"};

bool is_of_script(const std::string& name) {
    return std::count(commands_of_script.begin(), commands_of_script.end(), name) > 0;
}

std::string advice(const std::string& word, const CLI::App& app) {
    if (is_of_script(word))
        return fmt::format("it is one of the script ./wetdeck at the root of the sources: ./wetdeck {}",
                           word);
    std::vector<std::string> names;
    for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
    names.insert(names.end(), commands_of_script.begin(), commands_of_script.end());
    const std::string nearest = nearest_name(word, names);
    if (nearest.empty()) return "see wetdeck --help";
    return fmt::format("did you mean '{}{}'?", is_of_script(nearest) ? "./wetdeck " : "", nearest);
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> unknown = app.remaining();
    const bool misspelt = app.get_subcommands().empty() && !unknown.empty() && unknown.front().front() != '-';
    if (!misspelt) return fmt::format("{}; see wetdeck --help", error.what());
    return fmt::format("no command '{}'; {}", unknown.front(), advice(unknown.front(), app));
}

/// The choices of a type name such as "NAME:{local,slurm}".
std::vector<std::string> choices_in(const std::string& type_name) {
    const std::size_t open = type_name.find('{'), close = type_name.find('}');
    if (open == std::string::npos || close == std::string::npos) return {};
    return CLI::detail::split(type_name.substr(open + 1, close - open - 1), ',');
}

OptionInfo describe(const CLI::Option& option) {
    OptionInfo info;
    info.positional = option.get_positional();
    info.name = info.positional ? option.get_name(true) : "--" + option.get_lnames().front();
    if (!option.get_snames().empty()) info.name = "-" + option.get_snames().front() + ", " + info.name;
    info.description = option.get_description();
    if (const std::string preset = option.get_default_str(); !preset.empty())
        info.description += fmt::format(" (default: {})", preset);
    if (option.get_items_expected_max() > 0) {
        const std::string type = option.get_type_name();  // followed by a colon and the accepted values
        info.value = type.substr(0, type.find(':'));
        info.choices = choices_in(type);
    }
    return info;
}

CommandInfo describe(const CLI::App& command) {
    CommandInfo info{command.get_name(), command.get_description(), command.get_footer(), {}};
    for (const CLI::Option* option : command.get_options()) info.options.push_back(describe(*option));
    std::stable_partition(info.options.begin(), info.options.end(),
                          [](const OptionInfo& option) { return option.positional; });
    return info;
}

/// Single edits that turn one word into the other: a letter inserted, left out or replaced, or two
/// neighbours exchanged.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            std::size_t& d = distance[i][j];
            d = i + j;  // where one of them is empty
            if (i == 0 || j == 0) continue;
            d = std::min({distance[i - 1][j] + 1, distance[i][j - 1] + 1,
                          distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (exchanged) d = std::min(d, distance[i - 2][j - 2] + 1);
        }
    }
    return distance[a.size()][b.size()];
}

}  // namespace

int run_command_line(std::vector<std::string> words) {
    int exit_code = exit_done;
    const auto app = command_line(exit_code);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    try {
        app->parse(words);
    } catch (const CLI::Success& request) {  // for the help or the version
        return app->exit(request);
    } catch (const CLI::ParseError& error) {
        print_error(usage_error(*app, error));
        return exit_usage;
    }
    return exit_code;
}

void print_error(std::string message) {
    std::replace_if(
        message.begin(), message.end(),
        [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
    fmt::print(stderr, "wetdeck: {}\n", message);
}

std::vector<CommandInfo> command_list() {
    int exit_code = 0;
    const auto app = command_line(exit_code);
    std::vector<CommandInfo> list = {describe(*app)};
    list.front().name.clear();
    for (const CLI::App* command : commands_of(*app)) list.push_back(describe(*command));
    for (CommandInfo& command : list)
        if (command.footer == exit_codes) command.footer.clear();
    list.front().footer.clear();  // the manual page has sections of its own for this
    return list;
}

std::string nearest_name(const std::string& word, const std::vector<std::string>& names) {
    std::string nearest;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& name : names) {
        const std::size_t distance = edit_distance(word, name);
        if (distance >= least) continue;
        least = distance;
        nearest = name;
    }
    return nearest;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The command line: parsing, errors of usage, and a list of commands and options for the manual page and for
// completion.
#pragma once

#include <string>
#include <vector>

namespace wetdeck {

/// Runs the command that the words behind the program's name give and returns the exit code. Help goes to
/// stdout; bad usage prints one line on stderr and returns 2. Throws what the command throws.
int run_command_line(std::vector<std::string> words);

/// "wetdeck: MESSAGE" on stderr, as one line: control characters become spaces.
void print_error(std::string message);

struct OptionInfo {
    std::string name;                  ///< "--tier", or that of a positional argument: "scene"
    std::string value;                 ///< name of its value: "DIR"; empty for a flag
    std::vector<std::string> choices;  ///< all values it accepts, where these are listed
    std::string description;
    bool positional = false;
};

struct CommandInfo {
    std::string name;
    std::string description;
    std::string footer;
    std::vector<OptionInfo> options;  ///< positional arguments first
};

/// Every command, in the order of the help; the program itself, without a name, comes first.
std::vector<CommandInfo> command_list();

/// The name that differs least from `word`; empty if none is similar.
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

}  // namespace wetdeck

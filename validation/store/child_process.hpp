// SPDX-License-Identifier: BSD-3-Clause
// Other programs, started through the shell.
#pragma once

#include <string>

namespace wetdeck {

/// One word of a shell command, in single quotes, whatever characters the text holds.
std::string shell_quoted(const std::string& text);

struct ShellResult {
    int status = 0;      ///< exit code of the command; 128 plus the signal if one ended it
    std::string output;  ///< of stdout and stderr, without trailing line ends

    bool succeeded() const { return status == 0; }
};

/// Runs a command in the shell and waits for its end. Throws EnvironmentError if no shell can be started.
ShellResult run_in_shell(const std::string& command);

/// Whether a program of this name is on the PATH.
bool program_found(const std::string& name);

}  // namespace wetdeck

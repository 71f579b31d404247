// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/child_process.hpp"

#include <stdio.h>
#include <sys/wait.h>

#include <array>

#include "solver/core/errors.hpp"

namespace wetdeck {

std::string shell_quoted(const std::string& text) {
    std::string out = "'";
    for (const char letter : text) out += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return out + "'";
}

ShellResult run_in_shell(const std::string& command) {
    FILE* pipe = ::popen(("exec 2>&1; " + command).c_str(), "r");
    if (pipe == nullptr) throw EnvironmentError("cannot start a shell for: " + command);
    ShellResult result;
    std::array<char, 512> buffer{};
    while (::fgets(buffer.data(), buffer.size(), pipe) != nullptr) result.output += buffer.data();
    const int ended = ::pclose(pipe);
    result.status = WIFSIGNALED(ended) ? 128 + WTERMSIG(ended) : WEXITSTATUS(ended);
    while (result.output.ends_with('\n')) result.output.pop_back();
    return result;
}

bool program_found(const std::string& name) {
    return run_in_shell("command -v " + shell_quoted(name)).succeeded();
}

}  // namespace wetdeck

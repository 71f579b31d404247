// SPDX-License-Identifier: BSD-3-Clause
// The program wetdeck: from words to a command, from errors to one line and an exit code (exit_code.hpp).
#include <fmt/format.h>

#include "solver/core/errors.hpp"
#include "validation/program/command_line.hpp"
#include "validation/program/completion.hpp"
#include "validation/program/manual.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/stop_signal.hpp"

int main(int argc, char** argv) {
    using namespace wetdeck;
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::string first = words.empty() ? "" : words.front();
    try {
        if (first == "--manual") {  // asked by the build
            fmt::print("{}", manual_page());
            return exit_done;
        }
        if (first == "--complete") {  // asked by the shell
            for (const std::string& word : completions({words.begin() + 1, words.end()}))
                fmt::print("{}\n", word);
            return exit_done;
        }
        return run_command_line(words);
    } catch (const Interrupted& stop) {
        print_error(stop.what());
        return stop.exit_code();
    } catch (const InputError& error) {
        print_error(error.what());
        return exit_usage;
    } catch (const std::exception& error) {
        print_error(error.what());
        return exit_environment;
    }
}

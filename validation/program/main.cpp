// SPDX-License-Identifier: BSD-3-Clause
// The program wetdeck: from words to a command, from errors to one line and an exit code (exit_code.hpp).
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "solver/core/errors.hpp"
#include "validation/program/command_line.hpp"
#include "validation/program/completion.hpp"
#include "validation/program/manual.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/stop_signal.hpp"

namespace {

/// Threads that wait turn to sleep after some ten microseconds: where other work takes the processors, the
/// default of libgomp, milliseconds, makes a run with two threads several times slower than with one. The
/// library reads the number of turns when it is loaded, so that a program without it starts itself again.
void wait_politely(char** argv) {
    if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
    setenv("GOMP_SPINCOUNT", "20000", 1);
    execv("/proc/self/exe", argv);  // where that is not possible it goes on as it is
}

}  // namespace

int main(int argc, char** argv) {
    using namespace wetdeck;
    wait_politely(argv);
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

// SPDX-License-Identifier: BSD-3-Clause
// The commands of the program. Each file NAME.cpp of this folder adds the command NAME to the command line:
// its description, its options and a callback, which CLI11 calls when the command is given. Help, manual page
// and completion are made from these descriptions.
//
// A callback runs the command and stores the program's exit code in `exit_code`. It throws what the command
// throws: InputError, EnvironmentError, Interrupted.
#pragma once

namespace CLI {
class App;
}

namespace wetdeck {

void add_suite(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_resume(CLI::App& app, int& exit_code);
void add_verify(CLI::App& app, int& exit_code);
void add_stress(CLI::App& app, int& exit_code);
void add_ablate(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_baseline(CLI::App& app, int& exit_code);
void add_list(CLI::App& app, int& exit_code);
void add_describe(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_new(CLI::App& app, int& exit_code);
void add_sections(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_peer(CLI::App& app, int& exit_code);
void add_import(CLI::App& app, int& exit_code);

/// All of them, in the order of the help.
void add_commands(CLI::App& app, int& exit_code);

/// The flag --version, which prints and ends the program.
void add_version(CLI::App& app);

}  // namespace wetdeck

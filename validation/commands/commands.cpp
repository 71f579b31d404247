// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/commands.hpp"

#include <initializer_list>

namespace wetdeck {

void add_commands(CLI::App& app, int& exit_code) {
    for (const auto add : {add_suite, add_run, add_sweep, add_resume, add_verify, add_stress, add_ablate,
                           add_bench, add_report, add_baseline, add_list, add_describe, add_check, add_new,
                           add_sections, add_export, add_peer, add_import})
        add(app, exit_code);
}

}  // namespace wetdeck

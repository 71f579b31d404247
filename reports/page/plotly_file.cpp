// SPDX-License-Identifier: BSD-3-Clause
// Where the plotting library lies: beside an installed program, or in the build folder.
#include <filesystem>

#include "reports/page/report_inputs.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck::report {

std::string load_plotly() {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const auto installed = program.parent_path().parent_path() / "share/wetdeck/plotly.min.js";
    for (const std::filesystem::path& candidate : {installed, std::filesystem::path(WETDECK_PLOTLY_FILE)}) {
        if (std::filesystem::is_regular_file(candidate, ignored)) return read_whole_file(candidate);
    }
    return {};
}

}  // namespace wetdeck::report

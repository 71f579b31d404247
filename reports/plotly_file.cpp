// SPDX-License-Identifier: BSD-3-Clause
// Where the plotting library lies: beside an installed program, or in the build folder.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "reports/report.hpp"

namespace wetdeck::report {

std::string load_plotly() {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const auto installed = program.parent_path().parent_path() / "share/wetdeck/plotly.min.js";
    for (const std::filesystem::path& candidate : {installed, std::filesystem::path(WETDECK_PLOTLY_FILE)}) {
        std::ifstream stream(candidate, std::ios::binary);
        if (stream) return {std::istreambuf_iterator<char>(stream), {}};
    }
    return {};
}

}  // namespace wetdeck::report

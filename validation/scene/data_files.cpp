// SPDX-License-Identifier: BSD-3-Clause
// Where scenes and reference data lie: beside an installed program, or in the source tree that built it.
#include <unistd.h>

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>

#include "solver/core/errors.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

fs::path program_directory() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

fs::path first_that_exists(const std::vector<fs::path>& candidates, const char* what) {
    for (const fs::path& candidate : candidates) {
        if (fs::is_directory(candidate)) return candidate;
    }
    throw EnvironmentError(
        fmt::format("the {} of this program cannot be found; set WETDECK_DATA to its directory", what));
}

std::vector<fs::path> roots(const char* in_source) {
    std::vector<fs::path> candidates;
    const fs::path leaf = fs::path(in_source).filename();
    if (const char* chosen = std::getenv("WETDECK_DATA")) candidates.push_back(fs::path(chosen) / leaf);
    candidates.push_back(program_directory().parent_path() / "share/wetdeck" / leaf);
    candidates.push_back(fs::path(WETDECK_SOURCE_ROOT) / in_source);
    return candidates;
}

}  // namespace

fs::path scene_directory() {
    return first_that_exists(roots("validation/scenes"), "scenes");
}
fs::path scheme_directory() {
    return first_that_exists(roots("validation/schemes"), "schemes");
}
fs::path reference_directory() {
    return first_that_exists(roots("reference_data"), "reference data");
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(scene_directory())) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
    }
    std::sort(names.begin(), names.end());
    return names;
}

fs::path find_scene(const std::string& name_or_path) {
    const std::vector<std::string> names = scene_names();
    if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
        return scene_directory() / (name_or_path + ".toml");
    }
    if (name_or_path.find('/') != std::string::npos || fs::path(name_or_path).extension() == ".toml")
        return name_or_path;
    throw InputError(fmt::format("no scene '{}', expected one of {} or the path of a scene file",
                                 name_or_path, fmt::join(names, ", ")));
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/case_folder.hpp"

#include <fmt/format.h>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/hash.hpp"

namespace wetdeck {

namespace fs = std::filesystem;

void write_case(const fs::path& folder, const Scene& scene, const SceneCase& written, bool replace) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw InputError(fmt::format("{}: expected a folder", folder.string()));
    if (fs::is_directory(folder, error) && !fs::is_empty(folder, error) && !replace)
        throw InputError(
            fmt::format("{}: holds files already, expected --replace or another folder", folder.string()));
    for (const auto& [name, text] : foam_files(written.foam)) {
        make_directories((folder / name).parent_path());
        atomic_write(folder / name, text);
    }
    atomic_write(folder / "DIFFERENCES.md", foam_differences(scene, written));
    fs::permissions(folder / "run.sh", fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                           fs::perms::others_read | fs::perms::others_exec);
}

std::string case_hash(const SceneCase& written) {
    std::string all;
    for (const auto& [name, text] : foam_files(written.foam)) all += name + "\n" + text;
    return fmt::format("fnv1a64:{:016x}", fnv1a(all));
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Claiming, recognising and clearing run directories.
#include "validation/store/run_directory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/hash.hpp"
#include "validation/store/live_series.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

/// Files of a run by name; anything else in the directory belongs to somebody else.
bool belongs_to_a_run(const std::filesystem::path& path) {
    std::string name = path.filename().string();
    if (name.ends_with(".tmp")) name.resize(name.size() - 4);
    return name == "run.h5" || name == "live.h5" || name == "identity" || name == "fields.pvd" ||
           name.starts_with("checkpoint_") || (name.starts_with("frame_") && name.ends_with(".vtp"));
}

void remove_run_files(const std::filesystem::path& directory) {
    std::error_code error;
    std::vector<std::filesystem::path> found;
    for (const auto& folder : {directory, directory / "fields"}) {
        if (!std::filesystem::is_directory(folder)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
            if (entry.is_regular_file() && belongs_to_a_run(entry.path())) found.push_back(entry.path());
        }
        if (error) throw environment_error(folder, "list", error.value());
    }
    for (const auto& path : found) {
        std::filesystem::remove(path, error);
        if (error) throw environment_error(path, "remove", error.value());
    }
}

}  // namespace

std::string run_identity(const std::string& scene, const std::string& variant, double particle_spacing,
                         const std::string& resolved_scene) {
    const std::string clear = fmt::format("{} {} dx {}", scene, variant, particle_spacing);
    return fmt::format("{} {:016x}", clear, fnv1a(clear + '\n' + resolved_scene));
}

std::optional<std::string> identity_in(const std::filesystem::path& directory) {
    const std::filesystem::path path = directory / "identity";
    if (!std::filesystem::exists(path)) return std::nullopt;
    errno = 0;
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line) && errno != 0) throw environment_error(path, "read", errno);
    return line;
}

bool holds_finished_run(const std::filesystem::path& directory) {
    std::error_code error;
    return std::filesystem::is_regular_file(run_file(directory), error);
}

RunDirectory::RunDirectory(std::filesystem::path directory, const std::string& identity,
                           OnConflict on_conflict, std::chrono::milliseconds patience)
    : path_(std::move(directory)) {
    make_directories(path_);
    lock_.emplace(path_, patience, DirectoryLock::Holder::this_process);
    claim(identity, on_conflict);
}

void RunDirectory::claim(const std::string& identity, OnConflict on_conflict) const {
    const std::optional<std::string> found = identity_in(path_);
    const bool finished = holds_finished_run(path_);
    const bool another = found && *found != identity;
    if (on_conflict == OnConflict::replace) {
        remove_run_files(path_);
    } else if (on_conflict == OnConflict::refuse && (finished || another)) {
        throw InputError(
            fmt::format("{}: holds {} run ({}); choose another directory, remove this one or replace the run "
                        "with --replace",
                        path_.string(), finished ? "a finished" : "another, unfinished",
                        found.value_or("of unknown identity")));
    }
    if (found != identity || on_conflict == OnConflict::replace) {
        atomic_write(path_ / "identity", identity + '\n');
    }
}

}  // namespace wetdeck

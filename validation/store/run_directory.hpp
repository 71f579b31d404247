// SPDX-License-Identifier: BSD-3-Clause
// A run's directory: who may write in it, and which run it belongs to.
//
// DIR/.lock is locked for as long as a process works in DIR (directory_lock.hpp). DIR/identity holds one line
// that tells runs apart.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "validation/store/directory_lock.hpp"

namespace wetdeck {

/// One line: scene, variant and spacing in clear and a 64-bit hash of these with everything the run resolved
/// from its scene. Equal lines mean the same run.
std::string run_identity(const std::string& scene, const std::string& variant, double particle_spacing,
                         const std::string& resolved_scene);

/// The identity that a directory claims, if any. Throws EnvironmentError if it cannot be read.
std::optional<std::string> identity_in(const std::filesystem::path& directory);

/// Whether DIR/run.h5 is there: it appears whole, when a run has ended (unstable ones included).
bool holds_finished_run(const std::filesystem::path& directory);

enum class OnConflict {
    refuse,   ///< leave another or a finished run alone
    extend,   ///< take over whatever run is there, with its files
    replace,  ///< remove what is known to be a run's: results, fields, live series, checkpoint_*, identity
};

/// The claim on a directory, held for life. Other files in it are left alone.
class RunDirectory {
  public:
    /// Makes the directory if needed, locks it and writes its identity. An interrupted run of the same
    /// identity is taken over with its files. Throws InputError if the directory holds another or a finished
    /// run (and `refuse`), EnvironmentError if the machine refuses or another process works there
    /// and goes on doing so for longer than `patience`.
    RunDirectory(std::filesystem::path directory, const std::string& identity,
                 OnConflict on_conflict = OnConflict::refuse, std::chrono::milliseconds patience = {});
    RunDirectory(const RunDirectory&) = delete;
    RunDirectory& operator=(const RunDirectory&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    void claim(const std::string& identity, OnConflict on_conflict) const;

    std::filesystem::path path_;
    std::optional<DirectoryLock> lock_;
};

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints of a run, DIR/checkpoint_<step>.h5: everything that a run needs to continue with the same bits.
//
//   /             attributes schema, step
//   /texts        one attribute per text
//   /numbers      one attribute per number
//   /arrays       one dataset per array, uncompressed: a run waits while they are written
//
// A file without its seal (seal.hpp) is not read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wetdeck {

struct Checkpoint {
    std::uint64_t step = 0;
    std::map<std::string, std::string> texts;
    std::map<std::string, double> numbers;
    std::map<std::string, std::vector<double>> arrays;

    /// Throw DataError where there is no such entry.
    const std::string& text(const std::string& name) const;
    double number(const std::string& name) const;
    const std::vector<double>& array(const std::string& name) const;
};

/// The files of the checkpoints in a directory, newest first.
std::vector<std::filesystem::path> list_checkpoints(const std::filesystem::path& run_dir);

/// Writes DIR/checkpoint_STEP.h5 whole (temporary file, fsync, rename) and then removes all but the two
/// newest. Throws EnvironmentError if the machine refuses; the checkpoints before stay.
void write_checkpoint(const std::filesystem::path& run_dir, const Checkpoint& checkpoint);

/// Throws DataError, naming the file and what is missing or damaged, and EnvironmentError if the file may not
/// be read.
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// The newest checkpoint that is whole; none if there is no file of one. Throws DataError if there are some
/// and all are damaged.
std::optional<Checkpoint> newest_checkpoint(const std::filesystem::path& run_dir);

/// Removes the checkpoints after `step`: a run that continues from there would take them for its own.
void remove_checkpoints_after(const std::filesystem::path& run_dir, std::uint64_t step);
/// Removes all but the newest.
void keep_newest_checkpoint(const std::filesystem::path& run_dir);
void remove_checkpoints(const std::filesystem::path& run_dir);

}  // namespace wetdeck

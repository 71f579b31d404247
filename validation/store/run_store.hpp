// SPDX-License-Identifier: BSD-3-Clause
// The store of one run, DIR/run.h5: everything of a RunRecord, readable by h5dump and h5py.
//
//   /meta              attributes: the fields of RunRecord, every parameter (double) and the provenance
//   (texts) /series/<name>     attributes unit, description; datasets time [s], value, and abscissa where
//   value has
//                      two dimensions (time x abscissa)
//   /cost              attributes wall_seconds, core_seconds, steps, particle_steps, peak_memory_mb
//   /cost/stage_seconds, /cost/limiting_criterion     one attribute per stage, per criterion
//
// Texts are variable-length UTF-8 and end at a NUL. A key that is already taken in /meta is stored behind
// "parameter:" or, of the provenance, "choice:".
// The file carries a seal (seal.hpp). One without, as other programs leave it that write into it, is read
// too.
#pragma once

#include <filesystem>

#include "validation/store/run_record.hpp"

namespace wetdeck {

/// DIR/run.h5.
std::filesystem::path run_file(const std::filesystem::path& run_dir);

/// Writes DIR/run.h5 whole: built in memory, temporary file, fsync, rename. Throws EnvironmentError if the
/// machine refuses, DataError for a series whose lengths disagree or whose name holds a '/'.
void write_run(const std::filesystem::path& run_dir, const RunRecord& record);

/// Reads what write_run wrote, bit for bit. `file` is the run.h5 itself. Throws DataError, naming the file
/// and what is missing or damaged, and EnvironmentError if the file may not be read.
RunRecord read_run(const std::filesystem::path& file);

}  // namespace wetdeck

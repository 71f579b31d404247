// SPDX-License-Identifier: BSD-3-Clause
// The seal of a file: sixteen bytes behind the last byte of HDF5's own data, a checksum of everything before
// them and a mark. HDF5 ignores the seal when it reads, and removes it when it writes into the file. The seal
// is checked before HDF5 opens the file: HDF5 notices a truncated file but not a flipped bit, and may crash
// or never return on one. A file without a seal is first read in a child process.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace wetdeck {

/// The seal to append to these bytes.
std::string seal_of(std::string_view bytes);

enum class Seal { whole, broken, absent };

/// Absent also where there is no such file. Throws EnvironmentError if the file may not be read.
Seal seal_in(const std::filesystem::path& file);

/// Time that a reading may take, of the processor and by the clock [s].
struct ReadingTime {
    double processor_s, wall_s;
};

/// Generous for the size of this file: an undamaged one takes a tenth of the processor time at most, and the
/// clock allows for a busy machine.
ReadingTime reading_time(const std::filesystem::path& file);

/// Calls `read`, which reads `file`, in a child process. Throws DataError if the child crashes or exceeds the
/// limit. The result of `read` and its exceptions are ignored.
void try_in_child_process(const std::filesystem::path& file, const std::function<void()>& read,
                          const ReadingTime& limit);

}  // namespace wetdeck

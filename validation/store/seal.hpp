// SPDX-License-Identifier: BSD-3-Clause
// The seal of a file: sixteen bytes behind the end of HDF5's own, a checksum of all before them and a mark.
// HDF5 ignores them, and drops them when it writes into the file. They are checked before HDF5 opens the
// file: HDF5 notices that a file is too short, but not a flipped bit, on which it can hang or crash.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace wetdeck {

/// What is to be appended to the bytes of a file.
std::string seal_of(std::string_view bytes);

enum class Seal { whole, broken, absent };

/// Absent also where there is no such file. Throws EnvironmentError if the file may not be read.
Seal seal_in(const std::filesystem::path& file);

/// For files without a seal: calls `read` in a child process and throws DataError if it crashes or does not
/// end there. Exceptions of `read` are ignored: they are thrown again when the file is read in this process.
void try_in_child(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace wetdeck

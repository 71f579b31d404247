// SPDX-License-Identifier: BSD-3-Clause
// The seal of a file: sixteen bytes behind the end of HDF5's own, a checksum of all before them and a mark.
// HDF5 ignores them, and drops them when it writes into the file. They are looked at first, as HDF5 notices a
// file that is too short but not a flipped bit, and can hang or crash on one.
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

/// For files without a seal: reads `file` in a child process, to see whether HDF5 comes back from it. Throws
/// DataError if it crashes or does not end. What `read` returns or throws there is of no interest.
void rehearse(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace wetdeck

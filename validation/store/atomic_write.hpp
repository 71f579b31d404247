// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all: temporary file, fsync, rename, fsync of the directory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "solver/core/errors.hpp"

namespace wetdeck {

/// The meaning of an errno in words; "disk full" where no space or no quota is left.
std::string system_reason(int error_number);

/// "PATH: cannot DO: REASON".
EnvironmentError environment_error(const std::filesystem::path& path, const std::string& action,
                                   int error_number);

/// The name of the file while it is written; a killed process can leave it behind.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Replaces `path` by a file of these bytes. Whatever happens, `path` then holds either the old or the new
/// bytes. Throws EnvironmentError (and removes the temporary file) if the machine refuses.
void atomic_write(const std::filesystem::path& path, std::string_view bytes);

/// The directory and its parents, made if absent. Throws EnvironmentError.
void make_directories(const std::filesystem::path& directory);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace wetdeck {

/// All bytes of a file. Throws EnvironmentError "PATH: cannot read: REASON", also where there is no such
/// file.
std::string read_whole_file(const std::filesystem::path& path);

}  // namespace wetdeck

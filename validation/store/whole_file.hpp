// SPDX-License-Identifier: BSD-3-Clause
// A file as one piece of text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace wetdeck {

/// Every byte of a file; empty if it cannot be opened.
std::optional<std::string> read_whole_file(const std::filesystem::path& path);

}  // namespace wetdeck

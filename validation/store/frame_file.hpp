// SPDX-License-Identifier: BSD-3-Clause
// One frame as the bytes of a .vtp file, and the entries of a .pvd collection; used by fields.cpp only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/store/fields.hpp"

namespace wetdeck {

/// Throws DataError if the vectors of the frame differ in length.
std::string vtp_bytes(const FieldFrame& frame);

/// `frames` with paths as they are to stand in the file.
std::string pvd_bytes(const std::vector<FrameEntry>& frames);

/// The entries of an existing .pvd, paths as they stand there. Throws DataError.
std::vector<FrameEntry> read_pvd(const std::filesystem::path& path);

}  // namespace wetdeck

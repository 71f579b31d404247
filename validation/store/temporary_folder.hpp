// SPDX-License-Identifier: BSD-3-Clause
// A folder for files that nobody needs afterwards.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "solver/core/errors.hpp"

namespace wetdeck {

/// A new folder of its own among those for temporary files; it goes, with what it holds, at the end of its
/// scope.
class TemporaryFolder {
  public:
    /// Throws EnvironmentError where no folder can be made.
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "wetdeck_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw EnvironmentError(name + ": no folder can be made");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace wetdeck

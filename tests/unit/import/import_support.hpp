// SPDX-License-Identifier: BSD-3-Clause
// A folder of files for the readers of other codes.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace wetdeck {

class ImportFolder {
  public:
    ImportFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "wetdeck-import-XXXXXX").string();
        root_ = mkdtemp(pattern.data());
    }
    ~ImportFolder() { std::filesystem::remove_all(root_); }
    ImportFolder(const ImportFolder&) = delete;
    ImportFolder& operator=(const ImportFolder&) = delete;

    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path = root_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text;
        return path.string();
    }
    std::string path(const std::string& name) const { return (root_ / name).string(); }

  private:
    std::filesystem::path root_;
};

/// The message of the error that a call ends with.
template <class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// A folder of files for the readers of other codes.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/unit/store/store_samples.hpp"

namespace wetdeck {

/// A scratch folder whose files may lie in folders of their own.
class ImportFolder {
  public:
    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << text;
        return file.string();
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

  private:
    samples::ScratchFolder folder_;
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

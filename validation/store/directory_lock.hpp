// SPDX-License-Identifier: BSD-3-Clause
// DIR/.lock is locked for as long as a process works in DIR; the system releases the lock when the process
// ends, however it ends.
#pragma once

#include <chrono>
#include <filesystem>

namespace wetdeck {

class DirectoryLock {
  public:
    enum class Holder {
        this_process,   ///< programs that it starts do not hold the lock
        with_children,  ///< while one of the programs that it has started lives, the lock is held
    };
    /// Throws EnvironmentError if the machine refuses, or if another process works in the directory, which
    /// must be there, and goes on doing so for longer than `patience`.
    DirectoryLock(const std::filesystem::path& directory, std::chrono::milliseconds patience, Holder holder);
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock&) = delete;
    DirectoryLock& operator=(const DirectoryLock&) = delete;

  private:
    int file_ = -1;
};

}  // namespace wetdeck

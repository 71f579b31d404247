// SPDX-License-Identifier: BSD-3-Clause
// Child processes that are killed, and small file systems.
#pragma once

#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/unit/store/store_samples.hpp"

namespace wetdeck::samples {

/// A forked process that runs `work(signal_ready)`; killed with SIGKILL at the latest with its scope.
class Child {
  public:
    template <typename Work>
    explicit Child(const Work& work) {
        int ends[2];
        if (::pipe(ends) != 0 || (process_ = ::fork()) < 0) throw std::runtime_error("no child process");
        if (process_ == 0) {
            ::close(ends[0]);
            try {
                work([&] { return ::write(ends[1], "x", 1) == 1; });
            } catch (...) {
                ::_exit(1);
            }
            ::_exit(0);
        }
        ::close(ends[1]);
        ready_ = ends[0];
    }
    ~Child() {
        kill();
        ::close(ready_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// False if the child ended before it said so.
    bool wait_until_ready() const {
        char byte = 0;
        return ::read(ready_, &byte, 1) == 1;
    }
    void kill() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
        process_ = -1;
    }

  private:
    pid_t process_ = -1;
    int ready_ = -1;
};

/// A file system in memory with the mount options given; `error()` says why there is none (no privilege).
class SmallFileSystem {
  public:
    explicit SmallFileSystem(const std::string& options, unsigned long flags = 0) {
        if (::mount("none", path().c_str(), "tmpfs", flags, options.c_str()) != 0) error_ = errno;
    }
    ~SmallFileSystem() {
        if (error_ == 0) ::umount2(path().c_str(), MNT_DETACH);
    }
    SmallFileSystem(const SmallFileSystem&) = delete;
    SmallFileSystem& operator=(const SmallFileSystem&) = delete;

    void grow(const std::string& options) const {
        if (::mount("none", path().c_str(), "tmpfs", MS_REMOUNT, options.c_str()) != 0)
            throw std::runtime_error("the small file system cannot be made larger");
    }
    const std::filesystem::path& path() const { return folder_; }
    std::string error() const { return error_ == 0 ? "" : std::strerror(error_); }

  private:
    ScratchFolder folder_;
    int error_ = 0;
};

}  // namespace wetdeck::samples

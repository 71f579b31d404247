// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {

DirectoryLock::DirectoryLock(const std::filesystem::path& directory, std::chrono::milliseconds patience,
                             Holder holder) {
    const int inherited = holder == Holder::with_children ? 0 : O_CLOEXEC;
    file_ = ::open((directory / ".lock").c_str(), O_RDWR | O_CREAT | inherited, 0666);
    if (file_ < 0) throw environment_error(directory, "write in the directory", errno);
    const auto end = std::chrono::steady_clock::now() + patience;
    int result = ::flock(file_, LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EWOULDBLOCK && std::chrono::steady_clock::now() < end) {
        ::usleep(20'000);
        result = ::flock(file_, LOCK_EX | LOCK_NB);
    }
    if (result == 0) return;
    const int error = errno;
    ::close(file_);
    if (error == EWOULDBLOCK) {
        throw EnvironmentError(
            directory.string() +
            ": another process is working in this directory; wait for it or choose another");
    }
    throw environment_error(directory, "lock the directory", error);
}

DirectoryLock::~DirectoryLock() {
    ::close(file_);
}

}  // namespace wetdeck

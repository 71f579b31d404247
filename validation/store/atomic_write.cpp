// SPDX-License-Identifier: BSD-3-Clause
// Durable replacement of files by POSIX calls, which tell why they fail.
#include "validation/store/atomic_write.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace wetdeck {
namespace {

class FileDescriptor {
  public:
    FileDescriptor(const std::filesystem::path& path, int flags)
        : path_(path), value_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
        if (value_ < 0) throw environment_error(path_, "open", errno);
    }
    ~FileDescriptor() {
        if (value_ >= 0) ::close(value_);
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    void write_all(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(value_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR) throw environment_error(path_, "write", errno);
            if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
        }
    }
    void sync() {
        if (::fsync(value_) != 0) throw environment_error(path_, "write to disk", errno);
    }
    /// Some network file systems report a full disk only here.
    void close() {
        const int result = ::close(value_);
        value_ = -1;
        if (result != 0 && errno != EINTR) throw environment_error(path_, "close", errno);
    }

  private:
    std::filesystem::path path_;
    int value_;
};

void write_temporary(const std::filesystem::path& path, std::string_view bytes) {
    FileDescriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
    file.write_all(bytes);
    file.sync();
    file.close();
}

/// Makes a rename in the directory durable; file systems that cannot do this say EINVAL and are left alone.
void sync_directory(const std::filesystem::path& directory) {
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) throw environment_error(directory, "open", errno);
    const int error = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (error != 0 && error != EINVAL) throw environment_error(directory, "write to disk", error);
}

}  // namespace

std::string system_reason(int error_number) {
    if (error_number == ENOSPC) return "disk full";
    if (error_number == EDQUOT) return "disk full (quota used up)";
    return std::generic_category().message(error_number);
}

EnvironmentError environment_error(const std::filesystem::path& path, const std::string& action,
                                   int error_number) {
    return EnvironmentError(path.string() + ": cannot " + action + ": " + system_reason(error_number));
}

std::filesystem::path temporary_name(const std::filesystem::path& path) {
    return path.parent_path() / (path.filename().string() + ".tmp");
}

void atomic_write(const std::filesystem::path& path, std::string_view bytes) {
    const std::filesystem::path temporary = temporary_name(path);
    try {
        write_temporary(temporary, bytes);
        if (::rename(temporary.c_str(), path.c_str()) != 0) throw environment_error(path, "replace", errno);
    } catch (const EnvironmentError&) {
        ::unlink(temporary.c_str());
        throw;
    }
    sync_directory(path.has_parent_path() ? path.parent_path() : ".");
}

void make_directories(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    // create_directories is silent about a regular file of that name.
    if (!error && !std::filesystem::is_directory(directory, error) && !error) {
        error = std::make_error_code(std::errc::not_a_directory);
    }
    if (error) throw environment_error(directory, "create the directory", error.value());
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/whole_file.hpp"

#include <cerrno>
#include <fstream>

#include "validation/store/atomic_write.hpp"

namespace wetdeck {

std::string read_whole_file(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) throw environment_error(path, "read", error.value());
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    std::string bytes(size, '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw environment_error(path, "read", errno != 0 ? errno : EIO);
    return bytes;
}

}  // namespace wetdeck

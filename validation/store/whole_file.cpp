// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/whole_file.hpp"

#include <fstream>
#include <iterator>

namespace wetdeck {

std::optional<std::string> read_whole_file(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace wetdeck

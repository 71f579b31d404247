// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/section_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr std::uintmax_t largest_file = 50'000'000;  // [bytes]

std::string extension_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace

std::string Station::title() const {
    return name.empty() ? fmt::format("station {:.6g} m", location.value_or(0))
                        : fmt::format("station {}", name);
}

bool named_as_sections(const std::filesystem::path& file) {
    const std::string extension = extension_of(file);
    return extension == ".gf" || extension == ".dxf";
}

SectionFile read_sections(const std::filesystem::path& file, const SectionOptions& options) {
    const std::string name = file.string(), extension = extension_of(file);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(fmt::format("{}: no such file of sections", name));
    if (std::filesystem::file_size(file, error) > largest_file)
        throw InputError(fmt::format("{}: larger than {} bytes, not a file of sections", name, largest_file));
    const std::string text = read_whole_file(file);
    if (options.component && extension != ".gf")
        throw InputError(fmt::format("{}: only GHS geometry files (.gf) have components", name));
    if (options.axis != 0 && extension != ".dxf")
        throw InputError(fmt::format("{}: only of a drawing (.dxf) the centre line may be elsewhere", name));
    if (extension == ".gf") return parse_ghs(name, text, options);
    if (extension == ".dxf") return parse_dxf(name, text, options);
    if (options.unit)
        throw InputError(
            fmt::format("{}: the titles of a table state its unit: expected none beside it", name));
    return parse_offsets(name, text);
}

}  // namespace wetdeck

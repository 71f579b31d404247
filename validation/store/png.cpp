// SPDX-License-Identifier: BSD-3-Clause
// PNG (ISO 15948) with colour type 3.
#include "validation/store/png.hpp"

#include <zlib.h>

#include <limits>
#include <string_view>
#include <unordered_map>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

using Bytes = std::vector<unsigned char>;

void append_number(Bytes& bytes, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<unsigned char>(value >> shift));
}

void append_chunk(Bytes& file, std::string_view type, const Bytes& data) {
    append_number(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    const auto length = static_cast<uInt>(file.size() - begin);
    append_number(file, static_cast<std::uint32_t>(crc32(0, file.data() + begin, length)));
}

unsigned char nearest(const Rgb& colour, std::span<const Rgb> palette) {
    int least = std::numeric_limits<int>::max();
    std::size_t best = 0;
    for (std::size_t k = 0; k < palette.size(); ++k) {
        int distance = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int difference = colour[c] - palette[k][c];
            distance += difference * difference;
        }
        if (distance >= least) continue;
        least = distance;
        best = k;
    }
    return static_cast<unsigned char>(best);
}

}  // namespace

std::vector<unsigned char> encode_png(std::span<const Rgb> pixels, int width, int height,
                                      std::span<const Rgb> palette) {
    std::unordered_map<std::uint32_t, unsigned char> known;
    Bytes rows;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i % static_cast<std::size_t>(width) == 0) rows.push_back(0);  // no filter
        const Rgb& p = pixels[i];
        const std::uint32_t code = std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2];
        const auto [place, is_new] = known.try_emplace(code);
        if (is_new) place->second = nearest(p, palette);
        rows.push_back(place->second);
    }
    uLongf length = compressBound(static_cast<uLong>(rows.size()));
    Bytes packed(length);
    if (compress2(packed.data(), &length, rows.data(), static_cast<uLong>(rows.size()), 9) != Z_OK)
        throw EnvironmentError("picture: zlib cannot compress it");
    packed.resize(length);

    Bytes header;
    append_number(header, static_cast<std::uint32_t>(width));
    append_number(header, static_cast<std::uint32_t>(height));
    header.insert(header.end(), {8, 3, 0, 0, 0});  // bits, palette, deflate, filters, not interlaced
    Bytes colours;
    for (const Rgb& colour : palette) colours.insert(colours.end(), colour.begin(), colour.end());
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append_chunk(file, "IHDR", header);
    append_chunk(file, "PLTE", colours);
    append_chunk(file, "IDAT", packed);
    append_chunk(file, "IEND", {});
    return file;
}

}  // namespace wetdeck

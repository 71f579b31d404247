// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/png.hpp"

#include <png.h>

#include <limits>
#include <string>
#include <unordered_map>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

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

std::vector<unsigned char> nearest_of_each(std::span<const Rgb> pixels, std::span<const Rgb> palette) {
    std::unordered_map<std::uint32_t, unsigned char> known;
    std::vector<unsigned char> indices;
    indices.reserve(pixels.size());
    for (const Rgb& p : pixels) {
        const std::uint32_t code = std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2];
        const auto [place, is_new] = known.try_emplace(code);
        if (is_new) place->second = nearest(p, palette);
        indices.push_back(place->second);
    }
    return indices;
}

}  // namespace

std::vector<unsigned char> encode_png(std::span<const Rgb> pixels, int width, int height,
                                      std::span<const Rgb> palette) {
    const std::vector<unsigned char> indices = nearest_of_each(pixels, palette);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB_COLORMAP;
    image.colormap_entries = static_cast<png_uint_32>(palette.size());
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<unsigned char> file(size);
    if (png_image_write_to_memory(&image, file.data(), &size, 0, indices.data(), 0, palette.data()) == 0)
        throw EnvironmentError(std::string("picture: libpng cannot write it: ") + image.message);
    file.resize(size);
    return file;
}

}  // namespace wetdeck

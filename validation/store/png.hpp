// SPDX-License-Identifier: BSD-3-Clause
// PNG files with a palette: a third of the size of true colour, which a page with hundred pictures needs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wetdeck {

using Rgb = std::array<std::uint8_t, 3>;

/// Rows from the top, each pixel replaced by the nearest of at most 256 colours. Throws EnvironmentError if
/// libpng refuses.
std::vector<unsigned char> encode_png(std::span<const Rgb> pixels, int width, int height,
                                      std::span<const Rgb> palette);

}  // namespace wetdeck

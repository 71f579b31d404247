// SPDX-License-Identifier: BSD-3-Clause
// Disc rasteriser.
#include "validation/store/raster.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

constexpr int supersampling = 2;
constexpr int largest_side = 16384;  // [pixels]
constexpr Rgb background{255, 255, 255};
constexpr Rgb still_air{226, 230, 235};
constexpr Rgb wall{70, 70, 74};
constexpr Rgb body{120, 60, 50};
constexpr Rgb not_a_number{150, 150, 150};

/// Linear interpolation between equidistant colours.
Rgb interpolate(std::span<const Rgb> table, double fraction) {
    if (std::isnan(fraction)) return not_a_number;
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(table.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), table.size() - 2);
    const double weight = place - static_cast<double>(left);
    Rgb colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = (1 - weight) * table[left][c] + weight * table[left + 1][c];
        colour[c] = static_cast<std::uint8_t>(std::lround(value));
    }
    return colour;
}

/// Row 0 is the bottom.
class Canvas {
  public:
    Canvas(int width, int height, const RasterOptions& options)
        : width_(width),
          height_(height),
          scale_(width / (options.x_max - options.x_min)),
          options_(options),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background) {}

    /// @param size  of the particle over the finest
    void disc(double x, double y, double size, const Rgb& colour) {
        const double centre_x = (x - options_.x_min) * scale_ - 0.5;
        const double centre_y = (y - options_.y_min) * scale_ - 0.5;
        const double radius = std::max(size * options_.particle_radius * scale_, 0.5);
        if (!(std::abs(centre_x) < 2.0 * largest_side * supersampling &&
              std::abs(centre_y) < 2.0 * largest_side * supersampling)) {
            return;  // far outside, or not a number
        }
        const int first = std::max(0, static_cast<int>(std::ceil(centre_y - radius)));
        const int last = std::min(height_ - 1, static_cast<int>(std::floor(centre_y + radius)));
        for (int row = first; row <= last; ++row) {
            const double half =
                std::sqrt(std::max(0.0, radius * radius - (row - centre_y) * (row - centre_y)));
            const int begin = std::max(0, static_cast<int>(std::ceil(centre_x - half)));
            const int end = std::min(width_, static_cast<int>(std::floor(centre_x + half)) + 1);
            if (begin < end) std::fill(at(begin, row), at(begin, row) + (end - begin), colour);
        }
    }

    /// Mean of the supersampled pixels.
    Rgb averaged(int column, int row) const {
        Rgb mean{};
        for (std::size_t c = 0; c < 3; ++c) {
            int sum = 0;
            for (int i = 0; i < supersampling * supersampling; ++i) {
                sum +=
                    *(at(column * supersampling + i % supersampling, row * supersampling + i / supersampling)
                          ->begin() +
                      c);
            }
            mean[c] = static_cast<std::uint8_t>(sum / (supersampling * supersampling));
        }
        return mean;
    }

  private:
    std::vector<Rgb>::iterator at(int column, int row) {
        return pixels_.begin() + static_cast<std::ptrdiff_t>(row) * width_ + column;
    }
    std::vector<Rgb>::const_iterator at(int column, int row) const {
        return pixels_.begin() + static_cast<std::ptrdiff_t>(row) * width_ + column;
    }

    int width_, height_;
    double scale_;  // [supersampled pixels per metre]
    const RasterOptions& options_;
    std::vector<Rgb> pixels_;
};

Rgb colour_of(const FieldFrame& frame, std::size_t i, const RasterOptions& options) {
    const double speed = std::hypot(frame.vx[i], frame.vy[i]);
    switch (frame.phase[i]) {
        case 0: {
            const double value = options.water == WaterScalar::pressure ? frame.pressure[i] : speed;
            return water_colour((value - options.water_min) / (options.water_max - options.water_min));
        }
        case 1:
            return options.air_speed_max ? air_colour(speed / *options.air_speed_max) : still_air;
        case 2:
            return wall;
        default:
            return body;
    }
}

/// Height of the picture [pixels]; throws InputError for options that describe none.
int checked_height(const RasterOptions& options) {
    const double height = options.width * (options.y_max - options.y_min) / (options.x_max - options.x_min);
    const bool sound = options.width > 0 && options.width <= largest_side && options.x_max > options.x_min &&
                       height >= 0.5 && height <= largest_side && options.particle_radius > 0 &&
                       options.water_max > options.water_min && options.air_speed_max.value_or(1) > 0;
    if (!sound) {
        throw InputError(
            "picture: expected 1 to 16384 pixels a side, a box with x_min < x_max and y_min < y_max, a "
            "positive "
            "radius and water_min < water_max");
    }
    return static_cast<int>(std::lround(height));
}

Rgb mixed(const Rgb& a, const Rgb& b) {
    Rgb colour{};
    for (std::size_t c = 0; c < 3; ++c) colour[c] = static_cast<std::uint8_t>((a[c] + b[c]) / 2);
    return colour;
}

/// Both colour maps in even steps, the plain colours, and mixtures for the edges between them.
std::vector<Rgb> palette() {
    std::vector<Rgb> colours{background,
                             still_air,
                             wall,
                             body,
                             not_a_number,
                             mixed(background, wall),
                             mixed(background, body),
                             mixed(still_air, wall)};
    for (int k = 0; k <= 100; ++k) colours.push_back(water_colour(k / 100.0));
    for (int k = 0; k <= 50; ++k) colours.push_back(air_colour(k / 50.0));
    for (int k = 0; k <= 30; ++k) {
        colours.push_back(mixed(water_colour(k / 30.0), air_colour(0.2)));
        colours.push_back(mixed(water_colour(k / 30.0), wall));
        colours.push_back(mixed(water_colour(k / 30.0), background));
    }
    return colours;
}

std::vector<unsigned char> encode(const Canvas& canvas, int width, int height) {
    std::vector<Rgb> pixels;
    for (int row = height - 1; row >= 0; --row) {  // PNG starts at the top
        for (int column = 0; column < width; ++column) pixels.push_back(canvas.averaged(column, row));
    }
    return encode_png(pixels, width, height, palette());
}

}  // namespace

Rgb water_colour(double fraction) {
    // Nine samples of viridis (CC0): lightness rises evenly, readable with any colour vision and in grey.
    static constexpr std::array<Rgb, 9> table{{{68, 1, 84},
                                               {71, 44, 122},
                                               {59, 81, 139},
                                               {44, 113, 142},
                                               {33, 144, 141},
                                               {39, 173, 129},
                                               {92, 200, 99},
                                               {170, 220, 50},
                                               {253, 231, 37}}};
    return interpolate(table, fraction);
}

Rgb air_colour(double fraction) {
    static constexpr std::array<Rgb, 3> table{{{243, 245, 248}, {176, 190, 211}, {106, 127, 166}}};
    return interpolate(table, fraction);
}

std::vector<unsigned char> render_png(const FieldFrame& frame, const RasterOptions& options) {
    const int height = checked_height(options);
    Canvas canvas(options.width * supersampling, height * supersampling, options);
    // Water over air, solids over both, whatever the order of the particles.
    const auto layer_of = [&](std::size_t i) {
        return frame.phase[i] == 1 ? 0 : frame.phase[i] == 0 ? 1 : 2;
    };
    const double finest =
        frame.spacing.empty() ? 1 : *std::min_element(frame.spacing.begin(), frame.spacing.end());
    const auto size = [&](std::size_t i) { return frame.spacing.empty() ? 1 : frame.spacing[i] / finest; };
    for (const int layer : {0, 1, 2}) {
        for (std::size_t i = 0; i < frame.x.size(); ++i) {
            if (layer_of(i) == layer)
                canvas.disc(frame.x[i], frame.y[i], size(i), colour_of(frame, i, options));
        }
    }
    return encode(canvas, options.width, height);
}

void write_png(const std::filesystem::path& path, const FieldFrame& frame, const RasterOptions& options) {
    const std::vector<unsigned char> png = render_png(frame, options);
    std::string bytes(png.begin(), png.end());
    atomic_write(path, bytes);
}

}  // namespace wetdeck

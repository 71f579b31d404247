// SPDX-License-Identifier: BSD-3-Clause
// Pictures of field frames without a display: every particle a disc, drawn at twice the size and averaged
// down.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "validation/store/fields.hpp"
#include "validation/store/png.hpp"

namespace wetdeck {

/// Perceptually uniform map from dark violet (0) through teal to yellow (1); clamped, NaN is grey.
Rgb water_colour(double fraction);

/// Single-hue map from near white (0) to slate blue (1) for the speed of the air; clamped.
Rgb air_colour(double fraction);

enum class WaterScalar { pressure, speed };

struct RasterOptions {
    int width = 1200;                                   ///< [pixels]; the height follows from the box
    double x_min = 0, x_max = 1, y_min = 0, y_max = 1;  ///< what is shown [m]
    double particle_radius = 0;  ///< of the finest particles [m]; 0.75 spacings leave no gaps
    WaterScalar water = WaterScalar::pressure;
    double water_min = 0, water_max = 1;  ///< ends of the colour map [Pa] or [m/s]
    std::optional<double> air_speed_max;  ///< [m/s]; absent: air is light grey
};

/// The picture as the bytes of a PNG file of 256 colours. Throws InputError for options that describe no
/// picture.
std::vector<unsigned char> render_png(const FieldFrame& frame, const RasterOptions& options);

/// The same, written to a file that appears whole. Throws EnvironmentError too.
void write_png(const std::filesystem::path& path, const FieldFrame& frame, const RasterOptions& options);

}  // namespace wetdeck

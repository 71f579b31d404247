// SPDX-License-Identifier: BSD-3-Clause
// Pictures of frames: size, position, order of drawing, colours.
#include "validation/store/raster.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <catch2/catch.hpp>
#include <limits>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

FieldFrame particles(const std::vector<std::array<double, 2>>& places, const std::vector<int>& phases) {
    FieldFrame frame;
    for (const auto& [x, y] : places) {
        frame.x.push_back(static_cast<float>(x));
        frame.y.push_back(static_cast<float>(y));
    }
    frame.vx = frame.vy = frame.pressure = frame.density = std::vector<float>(places.size(), 0.0F);
    frame.phase = phases;
    frame.id.resize(places.size());
    return frame;
}

RasterOptions two_by_one() {
    RasterOptions options;
    options.width = 200;
    options.x_max = 2;
    options.particle_radius = 0.1;
    return options;
}

/// A picture read back; (0, 0) is its lower left corner.
class Picture {
  public:
    Picture(const FieldFrame& frame, const RasterOptions& options) {
        const ScratchFolder folder;
        write_png(folder / "picture.png", frame, options);
        reader_->SetFileName((folder / "picture.png").c_str());
        reader_->Update();
    }
    int width() { return reader_->GetOutput()->GetDimensions()[0]; }
    int height() { return reader_->GetOutput()->GetDimensions()[1]; }
    Rgb at(int column, int row) {
        const auto* pixel =
            static_cast<unsigned char*>(reader_->GetOutput()->GetScalarPointer(column, row, 0));
        return {pixel[0], pixel[1], pixel[2]};
    }

  private:
    vtkNew<vtkPNGReader> reader_;
};

/// Lightness of a colour (CIE L*).
double lightness(const Rgb& colour) {
    const auto linear = [](std::uint8_t byte) {
        const double value = byte / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    const double luminance =
        0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
    return luminance > 0.008856 ? 116 * std::cbrt(luminance) - 16 : 903.3 * luminance;
}

const Rgb white{255, 255, 255};

}  // namespace

TEST_CASE("a coarse particle is drawn as large as it is", "[store][raster]") {
    FieldFrame frame = particles({{0.5, 0.5}, {1.5, 0.5}}, {0, 0});
    frame.spacing = {0.1F, 0.4F};
    Picture picture(frame, two_by_one());
    const Rgb nothing = picture.at(100, 2);
    CHECK(picture.at(50, 50) != nothing);
    CHECK(picture.at(50, 70) == nothing);  // 0.2 m from the fine one
    CHECK(picture.at(150, 70) != nothing);
    CHECK(picture.at(150, 95) == nothing);
}

TEST_CASE("a picture has the size of its box, and a particle lies where it is", "[store][raster]") {
    Picture picture(particles({{0.5, 0.25}}, {0}), two_by_one());
    REQUIRE(picture.width() == 200);
    REQUIRE(picture.height() == 100);
    REQUIRE(picture.at(50, 25) == water_colour(0));
    REQUIRE(picture.at(50, 33) == water_colour(0));
    REQUIRE(picture.at(50, 37) == white);
    REQUIRE(picture.at(50, 75) == white);
}

TEST_CASE("solids are drawn over water and water over air, whatever the order", "[store][raster]") {
    Picture picture(particles({{0.5, 0.5}, {0.55, 0.5}, {0.5, 0.5}}, {2, 0, 1}), two_by_one());
    const Rgb wall = picture.at(50, 50);
    REQUIRE(wall[0] < 90);
    REQUIRE(picture.at(64, 50) == water_colour(0));
    REQUIRE(lightness(picture.at(41, 50)) < lightness(white));
}

TEST_CASE("water is coloured by pressure or by speed within the range given", "[store][raster]") {
    FieldFrame frame = particles({{0.5, 0.5}}, {0});
    frame.pressure = {30};
    frame.vx = {3};
    frame.vy = {-4};
    RasterOptions options = two_by_one();
    options.water_min = 20;
    options.water_max = 40;
    REQUIRE(Picture(frame, options).at(50, 50) == water_colour(0.5));
    options.water = WaterScalar::speed;
    options.water_min = 0;
    options.water_max = 20;
    REQUIRE(Picture(frame, options).at(50, 50) == water_colour(0.25));
}

TEST_CASE("air is light grey unless it is asked for by its speed", "[store][raster]") {
    FieldFrame frame = particles({{0.5, 0.5}}, {1});
    frame.vx = {6};
    RasterOptions options = two_by_one();
    REQUIRE(lightness(Picture(frame, options).at(50, 50)) > 85);
    options.air_speed_max = 10;
    REQUIRE(Picture(frame, options).at(50, 50) == air_colour(0.6));
}

TEST_CASE("particles outside the box, at its edge or without a place do no harm", "[store][raster]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double huge = std::numeric_limits<double>::infinity();
    Picture picture(particles({{-5, 0.5}, {1e300, 0.5}, {nan, 0.5}, {huge, huge}, {2, 1}}, {0, 0, 0, 0, 0}),
                    two_by_one());
    REQUIRE(picture.at(199, 99) == water_colour(0));
    REQUIRE(picture.at(0, 50) == white);
    REQUIRE(picture.at(100, 50) == white);
}

TEST_CASE("water without a value is grey", "[store][raster]") {
    FieldFrame frame = particles({{0.5, 0.5}}, {0});
    frame.pressure = {std::numeric_limits<float>::quiet_NaN()};
    const Rgb colour = Picture(frame, two_by_one()).at(50, 50);
    REQUIRE((colour[0] == colour[1] && colour[1] == colour[2] && colour != white));
}

TEST_CASE("the colour map of water grows lighter in nearly equal steps", "[store][raster]") {
    double smallest = 1e9;
    double largest = -1e9;
    for (int i = 0; i < 16; ++i) {
        const double step = lightness(water_colour((i + 1) / 16.0)) - lightness(water_colour(i / 16.0));
        smallest = std::min(smallest, step);
        largest = std::max(largest, step);
    }
    REQUIRE(smallest > 3.0);
    REQUIRE(largest < 6.5);
    REQUIRE(water_colour(-1) == water_colour(0));
    REQUIRE(water_colour(2) == water_colour(1));
}

TEST_CASE("the colour map of air grows darker and stays lighter than half of the water's",
          "[store][raster]") {
    for (int i = 0; i < 16; ++i) {
        REQUIRE(lightness(air_colour((i + 1) / 16.0)) < lightness(air_colour(i / 16.0)));
    }
    REQUIRE(lightness(air_colour(1)) > lightness(water_colour(0.4)));
}

TEST_CASE("options that describe no picture are refused", "[store][raster]") {
    RasterOptions options = two_by_one();
    SECTION("width") {
        options.width = 0;
    }
    SECTION("too wide") {
        options.width = 1 << 20;
    }
    SECTION("box") {
        options.x_max = options.x_min;
    }
    SECTION("flat") {
        options.y_max = -1;
    }
    SECTION("radius") {
        options.particle_radius = 0;
    }
    SECTION("range") {
        options.water_max = options.water_min;
    }
    SECTION("not a number") {
        options.y_max = std::numeric_limits<double>::quiet_NaN();
    }
    REQUIRE_THROWS_AS(render_png(samples::frame(0), options), InputError);
}

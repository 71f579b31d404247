// SPDX-License-Identifier: BSD-3-Clause
// PNG files with a palette, read back by VTK.
#include "validation/store/png.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <catch2/catch.hpp>

#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;

TEST_CASE("every pixel comes back as the nearest colour of the palette, the first row on top",
          "[store][png]") {
    const std::vector<Rgb> palette{{0, 0, 0}, {255, 255, 255}, {200, 0, 0}};
    const std::vector<Rgb> pixels{{0, 0, 0},   {250, 250, 250}, {190, 5, 5},
                                  {200, 0, 0}, {10, 10, 10},    {255, 255, 255}};
    const std::vector<unsigned char> png = encode_png(pixels, 3, 2, palette);
    const samples::ScratchFolder folder;
    samples::put_bytes(folder / "a.png", {png.begin(), png.end()});
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((folder / "a.png").c_str());
    reader->Update();
    const auto at = [&](int column, int row) {  // VTK counts rows from the bottom
        const auto* p =
            static_cast<const unsigned char*>(reader->GetOutput()->GetScalarPointer(column, 1 - row, 0));
        return Rgb{p[0], p[1], p[2]};
    };
    REQUIRE(reader->GetOutput()->GetNumberOfScalarComponents() == 3);
    CHECK(at(0, 0) == palette[0]);
    CHECK(at(1, 0) == palette[1]);
    CHECK(at(2, 0) == palette[2]);
    CHECK(at(0, 1) == palette[2]);
    CHECK(at(1, 1) == palette[0]);
    CHECK(at(2, 1) == palette[1]);
}

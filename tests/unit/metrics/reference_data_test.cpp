// SPDX-License-Identifier: BSD-3-Clause
// The reference files that ship with the program, and what is known of them.
#include <catch2/catch.hpp>
#include <filesystem>

#include "validation/metrics/reference.hpp"
#include "validation/metrics/resample.hpp"

using namespace wetdeck;

namespace {

const std::filesystem::path folder = std::filesystem::path(WETDECK_SOURCE_DIR) / "reference_data";

Curve dam_break(const std::string& stem, const std::string& column) {
    return column_curve(load_reference(folder / "dam_break" / (stem + ".csv")), "T", column);
}

}  // namespace

TEST_CASE("Every reference file loads and every column of it gives a curve", "[reference_data]") {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".csv") continue;
        ++files;
        INFO(entry.path());
        const Reference reference = load_reference(entry.path());
        REQUIRE(reference.columns.size() >= 2);
        for (std::size_t i = 1; i < reference.columns.size(); ++i) {
            const std::string& abscissa = reference.columns.front().name;
            CHECK_FALSE(column_curve(reference, abscissa, reference.columns[i].name).x.empty());
        }
    }
    CHECK(files >= 42);  // 17 dam break, 5 + 4 wedges, 6 plate, 8 catamaran, 2 sinking rectangle
}

TEST_CASE("The two readings of the Buchner gauge agree on the plateau", "[reference_data]") {
    const Curve first = dam_break("buchner2002_pressure_digit1", "p_star");
    const Curve second = dam_break("buchner2002_pressure_digit2", "p_star");
    // 0.0122 by an independent script; the steep first rise, where the readings differ in time, is left out.
    CHECK(rms_difference(first, second, {2.7, 5.4}) == Approx(0.0122).margin(0.0002));
}

TEST_CASE("The delta-SPH curves keep their published distance from the experiment", "[reference_data]") {
    const Curve buchner = dam_break("buchner2002_pressure_digit2", "p_star");
    const auto [column, distance] =
        GENERATE(table<std::string, double>({{"p_H40", 0.067}, {"p_H80", 0.0465}, {"p_H320", 0.0428}}));
    CHECK(rms_difference(dam_break("marrone2011_pressure", column), buchner, {2.4, 5.3}) ==
          Approx(distance).margin(0.0005));
}

TEST_CASE("Measured fronts stay behind the shallow-water front", "[reference_data]") {
    const Curve ritter = dam_break("ritter_front", "x_over_h");
    for (const char* stem : {"lobovsky2014_front", "garoosi_front", "trixi_wcsph_h400"}) {
        const Curve front = dam_break(stem, "x_over_h");
        for (const double T : {0.5, 1.0, 1.5}) CHECK(interpolate(front, T) < interpolate(ritter, T));
    }
}

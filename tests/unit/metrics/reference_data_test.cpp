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
        CHECK(missing_recommended_keys(reference).empty());
        for (std::size_t i = 1; i < reference.columns.size(); ++i) {
            const std::string& abscissa = reference.columns.front().name;
            CHECK_FALSE(column_curve(reference, abscissa, reference.columns[i].name).x.empty());
        }
    }
    CHECK(files >= 50);  // 25 dam break, 5 + 4 wedges, 6 plate, 8 catamaran, 2 sinking rectangle
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

TEST_CASE("Wall profiles hold the means of the curves that they name, at their heights", "[reference_data]") {
    struct Row {
        const char *profile, *curves, *column;
        double height;
    };
    const std::vector<Row> rows = {
        {"openfoam_wall_profile", "openfoam_pressure", "p_010", 0.0083},
        {"openfoam_wall_profile", "openfoam_pressure", "p_050", 0.0583},
        {"openfoam_wall_profile", "openfoam_pressure", "p_100", 0.1083},
        {"openfoam_wall_profile", "openfoam_pressure", "p_160", 0.1583},
        {"openfoam_wall_profile", "openfoam_pressure", "p_190", 0.1917},
        {"openfoam_wall_profile", "openfoam_pressure", "p_267", 0.275},
        {"trixi_wall_profile", "trixi_wcsph_h400", "p_P2", 0.05},
        {"trixi_wall_profile", "trixi_wcsph_h400", "p_P4", 0.2667},
        {"lobovsky2014_wall_profile", "lobovsky2014_pressure", "P2_mean", 0.05},
        {"lobovsky2014_wall_profile", "lobovsky2014_pressure", "P4_mean", 0.2667},
        {"buchner2002_wall_profile", "buchner2002_pressure_digit2", "p_star", 0.25},
        {"marrone2011_wall_profile", "marrone2011_pressure", "p_H320", 0.25}};
    const std::vector<std::pair<std::string, Window>> windows = {{"p_2.4_2.7", {2.4, 2.7}},
                                                                 {"p_2.7_3.3", {2.7, 3.3}},
                                                                 {"p_3.3_4.2", {3.3, 4.2}},
                                                                 {"p_4.2_5.0", {4.2, 5.0}},
                                                                 {"p_5.0_5.3", {5.0, 5.3}}};
    for (const Row& row : rows) {
        const Reference profile = load_reference(folder / "dam_break" / (std::string(row.profile) + ".csv"));
        for (const auto& [column, window] : windows) {
            CAPTURE(row.profile, row.column, column);
            const double mean = average(clip(dam_break(row.curves, row.column), window));
            CHECK(interpolate(column_curve(profile, "y_over_h", column), row.height) ==
                  Approx(mean).epsilon(0.001).margin(0.0005));
        }
    }
}

TEST_CASE("Four two-dimensional codes agree on the wall pressure, and two experiments do not",
          "[reference_data]") {
    const auto at = [](const std::string& stem, const std::string& column, double height) {
        const Reference profile = load_reference(folder / "dam_break" / (stem + ".csv"));
        return interpolate(column_curve(profile, "y_over_h", column), height);
    };
    for (const char* column : {"p_2.7_3.3", "p_3.3_4.2", "p_4.2_5.0", "p_5.0_5.3"}) {
        CAPTURE(column);
        for (const double height : {0.0583, 0.1, 0.2667}) {
            CAPTURE(height);
            const double ours = at("openfoam_wall_profile", column, height);
            CHECK(at("trixi_wall_profile", column, height) == Approx(ours).margin(0.05));
            CHECK(at("decourcy2024_wall_profile", column, height) == Approx(ours).margin(0.05));
        }
        CHECK(at("lobovsky2014_wall_profile", column, 0.05) < at("openfoam_wall_profile", column, 0.0583));
        CHECK(at("lobovsky2014_wall_profile", column, 0.2667) > at("openfoam_wall_profile", column, 0.2667));
        CHECK(at("buchner2002_wall_profile", column, 0.2667) > at("openfoam_wall_profile", column, 0.2667));
    }
}

TEST_CASE("Measured fronts stay behind the shallow-water front", "[reference_data]") {
    const Curve ritter = dam_break("ritter_front", "x_over_h");
    for (const char* stem : {"lobovsky2014_front", "garoosi_front", "trixi_wcsph_h400"}) {
        const Curve front = dam_break(stem, "x_over_h");
        for (const double T : {0.5, 1.0, 1.5}) CHECK(interpolate(front, T) < interpolate(ritter, T));
    }
}

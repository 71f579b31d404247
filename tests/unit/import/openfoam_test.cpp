// SPDX-License-Identifier: BSD-3-Clause
// What OpenFOAM writes, quirk by quirk.
#include <catch2/catch.hpp>
#include <cmath>

#include "import_support.hpp"
#include "solver/core/errors.hpp"
#include "validation/import/formats.hpp"
#include "validation/import/openfoam_files.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;

namespace {

const std::string force_head =
    "# Force       \n# CofR          : (0 0 0)\n#\n# Time          \t(total_x total_y total_z)\t(pressure_x "
    "pressure_y pressure_z)\t(viscous_x viscous_y viscous_z)\n";

/// A row whose upward force is `fy`.
std::string force_row(const std::string& time, double fy) {
    return time + "\t(0 " + std::to_string(fy) + " 0)\t(0 " + std::to_string(fy - 1) + " 0)\t(0 1 0)\n";
}

const RecordColumn& column(const CodeRecord& record, const std::string& name) {
    for (const RecordColumn& found : record.columns)
        if (found.name == name) return found;
    throw InputError("no column " + name);
}

}  // namespace

TEST_CASE("Forces are read with their parts and axes, in N, positive as the format defines") {
    ImportFolder folder;
    folder.write("postProcessing/hull/0/force.dat", force_head + force_row("0.1", 5) + force_row("0.2", 7));
    for (const char* path : {"", "postProcessing", "postProcessing/hull", "postProcessing/hull/0",
                             "postProcessing/hull/0/force.dat"}) {
        const CodeRecord record = read_openfoam({folder.path(path)});
        CHECK(record.time == std::vector<double>{0.1, 0.2});
        CHECK(column(record, "force_y").values == std::vector<double>{5, 7});
        CHECK(column(record, "force_pressure_y").values == std::vector<double>{4, 6});
        CHECK(column(record, "force_viscous_y").values == std::vector<double>{1, 1});
        CHECK(column(record, "force_y").unit == "N");
        CHECK_THAT(column(record, "force_y").sign, Contains("fluid on the patch"));
    }
}

TEST_CASE("Of folders of start times that overlap the later start wins") {
    ImportFolder folder;
    folder.write("postProcessing/hull/0/force.dat", force_head + force_row("0.1", 1) + force_row("0.2", 1) +
                                                        force_row("0.3", 1) + force_row("0.9", 1));
    folder.write("postProcessing/hull/0.15/force.dat",
                 force_head + force_row("0.25", 2) + force_row("0.3", 2));
    const CodeRecord record = read_openfoam({folder.path("postProcessing/hull")});
    CHECK(record.time == std::vector<double>{0.1, 0.25, 0.3});  // 0.2 and 0.9 are of a run that was given up
    CHECK(column(record, "force_y").values == std::vector<double>{1, 2, 2});
    REQUIRE(record.notes.size() == 1);
    CHECK_THAT(record.notes.front(), Contains("3 rows of an earlier run dropped"));
}

TEST_CASE("Folders of start times are ordered as numbers, not as names") {
    ImportFolder folder;
    folder.write("postProcessing/hull/10/force.dat", force_head + force_row("10.5", 2));
    folder.write("postProcessing/hull/9/force.dat", force_head + force_row("9.5", 1) + force_row("10.5", 1));
    CHECK(column(read_openfoam({folder.path("postProcessing/hull")}), "force_y").values ==
          std::vector<double>{1, 2});
}

TEST_CASE("force_START.dat is newer than force.dat in the same folder") {
    ImportFolder folder;
    folder.write("postProcessing/hull/0/force.dat", force_head + force_row("0.1", 1) + force_row("0.2", 1));
    folder.write("postProcessing/hull/0/force_0.dat", force_head + force_row("0.1", 2) + force_row("0.2", 2));
    CHECK(column(read_openfoam({folder.path("")}), "force_y").values == std::vector<double>{2, 2});
}

TEST_CASE("Rows of a repeated time become their mean") {
    ImportFolder folder;
    folder.write("postProcessing/hull/0/force.dat",
                 force_head + force_row("0.1", 1) + force_row("0.1", 3) + force_row("0.2", 5));
    const CodeRecord record = read_openfoam({folder.path("")});
    CHECK(column(record, "force_y").values == std::vector<double>{2, 5});
    REQUIRE(record.notes.size() == 1);
    CHECK_THAT(record.notes.front(), Contains("1 rows of a repeated time"));
}

TEST_CASE("Probes: the places of the head, scalars and vectors, missing values") {
    ImportFolder folder;
    const std::string head =
        "# Probe 0 (1 0 0.5)\n# Probe 1 (9 9 0.5)  # Not Found\n#       Probe             0             1\n# "
        "       "
        "Time\n";
    folder.write("postProcessing/gauges/0/p", head + "   0.1   12.5   -1e+300\n   0.2   13.5   -1e+300\n");
    folder.write(
        "postProcessing/gauges/0/U",
        head +
            "   0.1   (1 2 3)   (-1e+300 -1e+300 -1e+300)\n   0.2   (4 5 6)   (-1e+300 -1e+300 -1e+300)\n");
    const CodeRecord record = read_openfoam({folder.path("")});
    CHECK(column(record, "p_0").values == std::vector<double>{12.5, 13.5});
    CHECK(column(record, "p_0").unit == "Pa");
    CHECK_THAT(column(record, "p_0").sensor, Contains("(1 0 0.5)"));
    CHECK(std::isnan(column(record, "p_1").values[0]));
    CHECK_THAT(column(record, "p_1").sensor, Contains("outside the mesh"));
    CHECK(column(record, "U_0_z").values == std::vector<double>{3, 6});
    CHECK(std::isnan(column(record, "U_1_x").values[1]));
}

TEST_CASE("Forces and probes of several function objects have the name of each in front") {
    ImportFolder folder;
    const std::string a = folder.write("postProcessing/bow/0/force.dat", force_head + force_row("0.1", 1));
    const std::string b = folder.write("postProcessing/stern/0/force.dat", force_head + force_row("0.2", 2));
    CHECK_THAT(message_of([&] { read_openfoam({folder.path("")}); }), Contains("several function objects"));
    const CodeRecord record = read_openfoam({a, b});
    CHECK(column(record, "bow.force_y").values[0] == 1);
    CHECK(std::isnan(column(record, "bow.force_y").values[1]));
    CHECK(column(record, "stern.force_y").values[1] == 2);
}

TEST_CASE("Damaged and half-written files are named with their line") {
    ImportFolder folder;
    const auto wrong = [&](const std::string& text) {
        const std::string path = folder.write("postProcessing/hull/0/force.dat", text);
        return message_of([&] { read_openfoam({path}); });
    };
    CHECK_THAT(wrong(force_head + force_row("0.1", 1) + "0.2\t(0 1"),
               Contains("force.dat:6: the last line has no end"));
    CHECK_THAT(wrong(force_head + force_row("0.1", 1) + "0.2\t(0 1 0)\t(0\n"),
               Contains("force.dat:6: a bracket"));
    CHECK_THAT(wrong(force_head + force_row("0.1", 1) + "0.2\t(0 1 0)\n"),
               Contains("force.dat:6: holds 4 numbers"));
    CHECK_THAT(wrong(force_head + "0.1\t(0 x 0)\t(0 1 0)\t(0 0 0)\n"),
               Contains("force.dat:5: 'x' is no number"));
    CHECK_THAT(wrong(force_head + force_row("0.2", 1) + force_row("0.1", 1)),
               Contains("force.dat:6: time 0.1 after 0.2"));
    CHECK_THAT(wrong(""), Contains("force.dat:1: the file is empty"));
    CHECK_THAT(wrong(force_head), Contains("holds no rows"));
    CHECK_THAT(message_of([&] { read_openfoam({folder.path("nothing")}); }),
               Contains("no such file or folder"));
}

TEST_CASE("The case around the files tells version, phases and layer") {
    ImportFolder folder;
    const std::string path =
        folder.write("postProcessing/hull/0/force.dat", force_head + force_row("0.1", 1));
    folder.write("log.interFoam", "Build  : OPENFOAM=1912 patch=200626\n");
    folder.write("constant/transportProperties", "FoamFile\n{\n}\nphases (water air);\n");
    folder.write("constant/polyMesh/points", "4\n(\n(0 0 0)\n(1 0 0)\n(2 1 0.25)\n(3 2 0.25)\n)\n");
    const CodeRecord record = read_openfoam({path});
    CHECK(record.version == "v1912");
    CHECK(record.phase == "two-phase");
    REQUIRE(record.layer);
    CHECK(*record.layer == Approx(0.25));
}

TEST_CASE("A mesh of several layers has no layer") {
    CHECK_FALSE(layer_of_points("(\n(0 0 0)\n(1 1 1)\n(2 2 2)\n)\n"));
    CHECK_FALSE(layer_of_points(""));
}

// SPDX-License-Identifier: BSD-3-Clause
// What particle codes write, quirk by quirk.
#include <catch2/catch.hpp>
#include <cmath>

#include "import_support.hpp"
#include "validation/import/formats.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;

TEST_CASE("DualSPHysics: gauges between semicolons or commas, units in brackets") {
    ImportFolder folder;
    for (const char* text : {"time [s];force [N];forcex [N]\n0;1;2\n0.1;3;4\n",
                             "time [s],force [N],forcex [N]\n0,1,2\n0.1,3,4\n",
                             "Time [s];force [N];forcex [N];\n0;1;2;\n0.1;3;4;\n"}) {
        const CodeRecord record = read_dualsphysics({folder.write("GaugesForce.csv", text)});
        REQUIRE(record.columns.size() == 2);
        CHECK(record.time == std::vector<double>{0, 0.1});
        CHECK(record.time_unit == "s");
        CHECK(record.columns[0].name == "force");
        CHECK(record.columns[0].unit == "N");
        CHECK(record.columns[1].values == std::vector<double>{2, 4});
    }
}

TEST_CASE("DualSPHysics: a number of parts in front of the time, and words, are no values") {
    ImportFolder folder;
    const CodeRecord record = read_dualsphysics({folder.write(
        "FloatingInfo_mk60.csv",
        "part;time [s];predictor;fvel.z [m/s];pitch [deg]\n0;0;True;-1;0\n1;0.1;False;-2;9\n")});
    CHECK(record.time == std::vector<double>{0, 0.1});
    REQUIRE(record.columns.size() == 3);  // part, fvel.z, pitch
    CHECK(record.columns[1].name == "fvel.z");
    CHECK(record.columns[2].unit == "deg");
}

TEST_CASE("DualSPHysics: the largest single-precision number stands for nothing found") {
    ImportFolder folder;
    const CodeRecord record =
        read_dualsphysics({folder.write("GaugesMaxZ.csv", "time [s];zmax [m]\n0;-3.40282e+38\n0.1;0.5\n")});
    CHECK(std::isnan(record.columns[0].values[0]));
    CHECK(record.columns[0].values[1] == 0.5);
}

TEST_CASE("DualSPHysics: files of a continued run in any order, the later start wins") {
    ImportFolder folder;
    const std::string first = folder.write("a/g.csv", "time [s];force [N]\n0;1\n0.1;1\n0.2;1\n");
    const std::string later = folder.write("b/g.csv", "time [s];force [N]\n0.1;2\n0.2;2\n");
    const CodeRecord record = read_dualsphysics({later, first});
    CHECK(record.columns[0].values == std::vector<double>{1, 2, 2});
    CHECK_THAT(message_of([&] {
                   read_dualsphysics({first, first});
               }),
               Contains("two of the files start at the time 0"));
}

TEST_CASE("DualSPHysics: the version of Run.out beside the file") {
    ImportFolder folder;
    const std::string path = folder.write("out/g.csv", "time [s];force [N]\n0;1\n");
    CHECK(read_dualsphysics({path}).version.empty());
    folder.write("out/Run.out", "<<DualSPHysics v5.4.350 (26-11-2024)>>\n");
    CHECK(read_dualsphysics({path}).version == "v5.4.350");
}

TEST_CASE("SPHinXsys: quoted and unquoted titles, headers in the middle start a new run") {
    ImportFolder folder;
    for (const char* title : {"run_time", "\"run_time\""}) {
        const std::string head = std::string(title) + "   \"Pressure[0]\"   \"Pressure[1]\"   \n";
        const CodeRecord record = read_sphinxsys({folder.write(
            "Observer_Pressure.dat", head + "0   1.0   2.0   \n0.1   1.0   2.0   \n0.2   1.0   2.0   \n" +
                                         head + "0.1   5.0   6.0   \n0.2   5.0   6.0   \n")});
        REQUIRE(record.columns.size() == 2);
        CHECK(record.columns[0].name == "Pressure_0");
        CHECK(record.columns[0].unit.empty());
        CHECK(record.time == std::vector<double>{0, 0.1, 0.2});
        CHECK(record.columns[0].values == std::vector<double>{1, 5, 5});
    }
}

TEST_CASE("SPHinXsys: a header at the end of the file, of a run without steps, changes nothing") {
    ImportFolder folder;
    const std::string path =
        folder.write("F.dat", "\"run_time\"   \"Force\"   \n0   1   \n\"run_time\"   \"Force\"   \n");
    CHECK_THAT(message_of([&] { read_sphinxsys({path}); }),
               Contains("F.dat:3: the file ends without numbers"));
}

TEST_CASE("SPHinXsys: times of six digits repeat and become one row") {
    ImportFolder folder;
    const CodeRecord record =
        read_sphinxsys({folder.write("F.dat", "run_time   \"Force\"   \n1.23457   1   \n1.23457   3   \n")});
    CHECK(record.time == std::vector<double>{1.23457});
    CHECK(record.columns[0].values == std::vector<double>{2});
}

TEST_CASE("TrixiParticles: columns of a CSV, series of a JSON, version of the JSON beside") {
    ImportFolder folder;
    const std::string csv =
        folder.write("values.csv", "time,force_rigid_body_1,p_fluid_1\n0.0,1.0,\n0.1,2.0,4.0\n");
    CodeRecord record = read_trixiparticles({csv});
    CHECK(record.version.empty());
    CHECK(record.columns[0].name == "force_rigid_body_1");
    CHECK(std::isnan(record.columns[1].values[0]));
    const std::string file = folder.write("values.json", R"({
"meta": {"solver_name": "TrixiParticles.jl", "solver_version": "v0.2.3"},
"force_rigid_body_1": {"type": "series", "values": [1.0, null], "time": [0.0, 0.1]},
"place_fluid_1": {"type": "series", "values": [[1, 2], [1, 2]], "time": [0.0, 0.1]}})");
    record = read_trixiparticles({file});
    CHECK(record.version == "v0.2.3");
    REQUIRE(record.columns.size() == 1);
    CHECK(record.columns[0].values[0] == 1);
    CHECK(std::isnan(record.columns[0].values[1]));
    CHECK_THAT(record.notes.at(0), Contains("place_fluid_1"));
    CHECK(read_trixiparticles({csv}).version == "v0.2.3");
    const std::string cut = folder.write("cut.json", "{\n\"a\": {\n");
    CHECK_THAT(message_of([&] { read_trixiparticles({cut}); }), Contains("cut.json:3: no sound JSON"));
}

TEST_CASE("Plain columns with and without titles") {
    ImportFolder folder;
    CodeRecord record = read_plain({folder.write("a.csv", "t [ms],F [kN]\n0,1\n1,2\n")});
    CHECK(record.time_unit == "ms");
    CHECK(record.columns[0].unit == "kN");
    record = read_plain({folder.write("b.txt", "# time force\n0 1 5\n1 2 6\n")});
    CHECK(record.time_unit.empty());
    CHECK(record.columns[1].name == "column_3");
    CHECK(record.columns[1].values == std::vector<double>{5, 6});
}

TEST_CASE("Damaged tables are named with their line") {
    ImportFolder folder;
    const auto wrong = [&](auto read, const std::string& text) {
        const std::string path = folder.write("f.csv", text);
        return message_of([&] { read({path}); });
    };
    CHECK_THAT(wrong(read_dualsphysics, "time [s];a [m]\n0;1\n0.1;"),
               Contains("f.csv:3: the last line has no end"));
    CHECK_THAT(wrong(read_dualsphysics, "time [s];a [m];b [m]\n0;1;2\n0.1\n"),
               Contains("f.csv:3: holds 1 cells, expected 3"));
    CHECK_THAT(wrong(read_dualsphysics, "time [s];a [m]\n0;1\ntime [s];a [m]\n"),
               Contains("f.csv:3: a second line of titles"));
    CHECK_THAT(wrong(read_dualsphysics, "0;1\n"), Contains("f.csv:1: expected a line of titles"));
    CHECK_THAT(wrong(read_dualsphysics, "time [s];a [m]\n"),
               Contains("f.csv:1: the file ends without numbers"));
    CHECK_THAT(wrong(read_dualsphysics, "time [s];a [m]\nx;1\n"), Contains("f.csv:2: 'x' is no number"));
    CHECK_THAT(wrong(read_sphinxsys, "run_time \"a\"\n0 1\nrun_time \"b\"\n0 1\n"),
               Contains("f.csv:3: other titles"));
    CHECK_THAT(wrong(read_sphinxsys, "run_time \"a\"\n0.2 1\n0.1 1\n"),
               Contains("f.csv:3: time 0.1 after 0.2"));
    CHECK_THAT(wrong(read_trixiparticles, "time,a\n0.0,x,1\n"), Contains("f.csv:2: holds 3 cells"));
}

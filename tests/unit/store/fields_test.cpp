// SPDX-License-Identifier: BSD-3-Clause
// Field files: what ParaView needs, exact reading back, and a collection that is always whole.
#include "validation/store/fields.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

std::vector<double> times_in(const std::filesystem::path& folder) {
    std::vector<double> times;
    for (const FrameEntry& entry : list_frames(folder)) times.push_back(entry.time);
    return times;
}

void write_frames(const std::filesystem::path& folder, const std::vector<double>& times) {
    FieldWriter writer(folder);
    for (const double time : times) writer.write(samples::frame(time));
}

}  // namespace

TEST_CASE("a frame comes back bit for bit", "[store][fields]") {
    const ScratchFolder folder;
    const FieldFrame frame = samples::frame(0.1 + 0.2);
    FieldWriter(folder).write(frame);
    REQUIRE(samples::same(read_frame(folder / "fields/frame_000000.vtp"), frame));
}

TEST_CASE("spacings that differ come back, and of equal ones nothing is written", "[store][fields]") {
    const ScratchFolder folder;
    FieldFrame frame = samples::frame(1);
    for (std::size_t i = 0; i < frame.x.size(); ++i)
        frame.spacing.push_back(0.01F * static_cast<float>(i % 5 + 1));
    FieldWriter(folder / "graded").write(frame);
    CHECK(read_frame(folder / "graded/fields/frame_000000.vtp").spacing == frame.spacing);
    FieldWriter(folder / "equal").write(samples::frame(1));
    CHECK(read_frame(folder / "equal/fields/frame_000000.vtp").spacing.empty());
    frame.spacing.pop_back();
    CHECK_THROWS_AS(FieldWriter(folder / "wrong").write(frame), DataError);
}

TEST_CASE("a frame without particles comes back", "[store][fields]") {
    const ScratchFolder folder;
    FieldWriter(folder).write(samples::frame(1, 0));
    REQUIRE(samples::same(read_frame(folder / "fields/frame_000000.vtp"), samples::frame(1, 0)));
}

TEST_CASE("a frame says where it comes from", "[store][fields]") {
    const ScratchFolder folder;
    FieldFrame frame = samples::frame(1.5);
    frame.provenance = "tank two-phase dx 0.01: wetdeck 0, commit abc1234";
    FieldWriter(folder).write(frame);
    REQUIRE(read_frame(folder / "fields/frame_000000.vtp").provenance == frame.provenance);
    REQUIRE(samples::bytes_of(folder / "fields/frame_000000.vtp").find("Name=\"Provenance\"") !=
            std::string::npos);
}

TEST_CASE("frames are written as bookworm's ParaView can read and draws them", "[store][fields]") {
    const ScratchFolder folder;
    FieldWriter(folder).write(samples::frame(1.5));
    const std::string text = samples::bytes_of(folder / "fields/frame_000000.vtp");
    REQUIRE(text.find("<AppendedData") == std::string::npos);
    REQUIRE(text.find("format=\"appended\"") == std::string::npos);
    for (const char* part :
         {"format=\"binary\"", "header_type=\"UInt64\"", "vtkZLibDataCompressor", "NumberOfVerts=\"400\"",
          "<PointData Scalars=\"pressure\"", "Name=\"velocity\" NumberOfComponents=\"3\"",
          "Name=\"TimeValue\"", "type=\"Int64\" Name=\"id\"", "type=\"Int32\" Name=\"phase\"",
          "Name=\"density\"", "type=\"Int32\" Name=\"connectivity\""}) {
        INFO(part);
        REQUIRE(text.find(part) != std::string::npos);
    }
}

TEST_CASE("the collection lists all frames with exact times after every frame", "[store][fields]") {
    const ScratchFolder folder;
    FieldWriter writer(folder);
    REQUIRE(list_frames(folder).empty());
    std::vector<double> times;
    for (const double time : {0.0, 0.1 + 0.2, 1e-7, 1.0 / 3}) {
        writer.write(samples::frame(time));
        times.push_back(time);
        REQUIRE(times_in(folder) == times);
    }
    for (const FrameEntry& entry : list_frames(folder)) {
        REQUIRE(read_frame(entry.path).time == entry.time);
    }
    REQUIRE_THAT(samples::bytes_of(folder / "fields.pvd"),
                 Catch::Contains("file=\"fields/frame_000003.vtp\"") && Catch::EndsWith("</VTKFile>\n"));
    REQUIRE(samples::names_in(folder / "fields").size() == 4);
    REQUIRE(samples::names_in(folder).size() == 2);
}

TEST_CASE("a collection that goes on keeps the frames up to the checkpoint", "[store][fields]") {
    const ScratchFolder folder;
    write_frames(folder, {0, 1, 2, 3});
    samples::put_bytes(folder / "fields/frame_000009.vtp.tmp", "interrupted");
    FieldWriter writer(folder, 1.5);
    REQUIRE(times_in(folder) == std::vector<double>{0, 1});
    REQUIRE(samples::names_in(folder / "fields").size() == 2);
    writer.write(samples::frame(1.75));
    REQUIRE(times_in(folder) == std::vector<double>{0, 1, 1.75});
    REQUIRE(read_frame(list_frames(folder).back().path).time == 1.75);
}

TEST_CASE("a collection that starts anew forgets the frames of before", "[store][fields]") {
    const ScratchFolder folder;
    write_frames(folder, {0, 1, 2});
    const FieldWriter writer(folder);
    REQUIRE(times_in(folder).empty());
    REQUIRE(samples::names_in(folder / "fields").empty());
}

TEST_CASE("a collection that goes on ends where a frame was lost", "[store][fields]") {
    const ScratchFolder folder;
    write_frames(folder, {0, 1, 2});
    std::filesystem::remove(folder / "fields/frame_000001.vtp");
    const FieldWriter writer(folder, 10);
    REQUIRE(times_in(folder) == std::vector<double>{0});
}

TEST_CASE("a frame whose vectors differ in length is refused", "[store][fields]") {
    const ScratchFolder folder;
    FieldFrame frame = samples::frame(0);
    frame.phase.pop_back();
    FieldWriter writer(folder);
    REQUIRE_THROWS_AS(writer.write(frame), DataError);
    REQUIRE(list_frames(folder).empty());
}

TEST_CASE("missing, cut and foreign frames are refused by name", "[store][fields]") {
    const ScratchFolder folder;
    write_frames(folder, {0});
    const auto path = folder / "fields/frame_000000.vtp";
    const std::string whole = samples::bytes_of(path);
    SECTION("missing") {
        std::filesystem::remove(path);
    }
    SECTION("empty") {
        samples::put_bytes(path, "");
    }
    SECTION("cut") {
        samples::put_bytes(path, whole.substr(0, static_cast<std::size_t>(GENERATE(0.1, 0.5, 0.9, 0.999) *
                                                                          double(whole.size()))));
    }
    SECTION("foreign") {
        samples::put_bytes(path, "not a field");
    }
    SECTION("without density") {
        std::string changed = whole;
        changed.replace(changed.find("\"density\""), 9, "\"dentist\"");
        samples::put_bytes(path, changed);
    }
    REQUIRE_THROWS_AS(read_frame(path), DataError);
    REQUIRE_THROWS_WITH(read_frame(path), Catch::StartsWith(path.string() + ": "));
}

TEST_CASE("a damaged collection is refused by name", "[store][fields]") {
    const ScratchFolder folder;
    write_frames(folder, {0, 1});
    const std::string whole = samples::bytes_of(folder / "fields.pvd");
    SECTION("cut") {
        samples::put_bytes(folder / "fields.pvd", whole.substr(0, whole.size() - 30));
    }
    SECTION("foreign") {
        samples::put_bytes(folder / "fields.pvd", "<html></html>");
    }
    SECTION("empty") {
        samples::put_bytes(folder / "fields.pvd", "");
    }
    REQUIRE_THROWS_AS(list_frames(folder), DataError);
}

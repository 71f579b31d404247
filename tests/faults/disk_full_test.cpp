// SPDX-License-Identifier: BSD-3-Clause
// A full disk: the message says so, and what was whole before stays whole.
#include <catch2/catch.hpp>
#include <random>

#include "solver/core/errors.hpp"
#include "tests/faults/fault_support.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/live_series.hpp"
#include "validation/store/raster.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;

namespace {

/// 256 KiB; tests end early, with a warning, where mounting is not permitted.
#define REQUIRE_SMALL_DISK(disk)                                                        \
    const samples::SmallFileSystem disk("size=256k");                                   \
    if (!disk.error().empty()) {                                                        \
        WARN("not tested: no small file system can be mounted here: " << disk.error()); \
        return;                                                                         \
    }

RunRecord large_record() {
    RunRecord record = samples::record(100'000);
    std::mt19937_64 random(1);  // does not compress
    for (double& value : record.series["front"].value) value = static_cast<double>(random());
    return record;
}

}  // namespace

TEST_CASE("an atomic write on a full disk says so and keeps the old file", "[faults]") {
    REQUIRE_SMALL_DISK(disk);
    atomic_write(disk.path() / "file", "old");
    const std::string large(1'000'000, 'x');
    REQUIRE_THROWS_AS(atomic_write(disk.path() / "file", large), EnvironmentError);
    REQUIRE_THROWS_WITH(atomic_write(disk.path() / "file", large),
                        Catch::Contains("file.tmp: cannot write: disk full"));
    REQUIRE(samples::bytes_of(disk.path() / "file") == "old");
    REQUIRE(samples::names_in(disk.path()).size() == 1);
}

TEST_CASE("a run that does not fit says so and keeps the run stored before", "[faults]") {
    REQUIRE_SMALL_DISK(disk);
    const RunRecord small = samples::record(10);
    write_run(disk.path(), small);
    REQUIRE_THROWS_AS(write_run(disk.path(), large_record()), EnvironmentError);
    REQUIRE_THROWS_WITH(write_run(disk.path(), large_record()), Catch::Contains("disk full"));
    REQUIRE(samples::same(read_run(run_file(disk.path())), small));
    REQUIRE(samples::names_in(disk.path()).size() == 1);
}

TEST_CASE("live series on a full disk say so and keep the rows before", "[faults]") {
    REQUIRE_SMALL_DISK(disk);
    const samples::ScratchFolder notes;
    // In a child, as HDF5 1.10 leaks the chunk that it could not write, which leak checkers would report.
    const samples::Child child([&](const auto& signal_ready) {
        std::size_t appended = 0;
        std::string message;
        {
            LiveSeries live(disk.path(), {{"a", "m", ""}, {"b", "m", ""}, {"c", "m", ""}});
            try {
                for (; appended < 100'000; ++appended) {
                    const auto value = static_cast<double>(appended);
                    live.append(value, std::vector<double>{value, value, value});
                }
            } catch (const EnvironmentError& error) {
                message = error.what();
            }
            live.flush();
        }
        samples::put_bytes(notes / "message", message);
        samples::put_bytes(notes / "appended", std::to_string(appended));
        signal_ready();
    });
    REQUIRE(child.wait_until_ready());
    REQUIRE_THAT(samples::bytes_of(notes / "message"),
                 Catch::Contains("live.h5") && Catch::Contains("disk full"));
    const std::size_t appended = std::stoul(samples::bytes_of(notes / "appended"));
    REQUIRE(appended > 5000);
    const Series column = read_live(disk.path()).at("b");
    REQUIRE(column.time.size() + 200 > appended);
    bool gapless = true;
    for (std::size_t i = 0; i < column.time.size(); ++i) gapless = gapless && column.value[i] == double(i);
    REQUIRE(gapless);
}

TEST_CASE("fields on a full disk say so, and the frames before stay listed and whole", "[faults]") {
    REQUIRE_SMALL_DISK(disk);
    FieldWriter writer(disk.path());
    std::string message;
    std::size_t written = 0;
    try {
        for (; written < 1000; ++written) writer.write(samples::frame(static_cast<double>(written)));
    } catch (const EnvironmentError& error) {
        message = error.what();
    }
    REQUIRE_THAT(message, Catch::Contains("disk full"));
    REQUIRE(written > 2);
    const std::vector<FrameEntry> frames = list_frames(disk.path());
    REQUIRE(frames.size() == written);
    for (const FrameEntry& entry : frames) {
        REQUIRE(samples::same(read_frame(entry.path), samples::frame(entry.time)));
    }
}

TEST_CASE("a picture on a full disk says so", "[faults]") {
    REQUIRE_SMALL_DISK(disk);
    try {
        atomic_write(disk.path() / "filler", std::string(255 * 1024, 'x'));
    } catch (const EnvironmentError&) {
        FAIL("the filler must fit");
    }
    RasterOptions options;
    options.particle_radius = 0.05;
    REQUIRE_THROWS_WITH(write_png(disk.path() / "p.png", samples::frame(0), options),
                        Catch::Contains("disk full"));
}

TEST_CASE("a claim on a full disk says so", "[faults]") {
    REQUIRE_SMALL_DISK(disk);
    std::filesystem::create_directory(disk.path() / "run");
    std::ofstream filler(disk.path() / "filler");
    while (filler << std::string(1024, 'x') << std::flush) {
    }
    REQUIRE_THROWS_WITH(RunDirectory(disk.path() / "run", "identity"), Catch::Contains("disk full"));
}

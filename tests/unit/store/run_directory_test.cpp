// SPDX-License-Identifier: BSD-3-Clause
// Claims on run directories, and files that appear whole.
#include "validation/store/run_directory.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

const std::string coarse = run_identity("wedge", "two-phase", 0.02, "speed = 4.0");
const std::string fine = run_identity("wedge", "two-phase", 0.01, "speed = 4.0");

}  // namespace

TEST_CASE("identities tell scene, variant, spacing and resolved text apart, and nothing else", "[store]") {
    REQUIRE(coarse == run_identity("wedge", "two-phase", 0.02, "speed = 4.0"));
    REQUIRE(coarse != fine);
    REQUIRE(coarse != run_identity("plate", "two-phase", 0.02, "speed = 4.0"));
    REQUIRE(coarse != run_identity("wedge", "paper", 0.02, "speed = 4.0"));
    REQUIRE(coarse != run_identity("wedge", "two-phase", 0.02, "speed = 4.1"));
    REQUIRE_THAT(coarse, Catch::StartsWith("wedge two-phase dx 0.02 "));
}

TEST_CASE("a claim makes the directory and leaves the identity", "[store]") {
    const ScratchFolder folder;
    const auto directory = folder / "runs/wedge/dx0.02";
    REQUIRE_FALSE(identity_in(directory));
    const RunDirectory run(directory, coarse);
    REQUIRE(run.path() == directory);
    REQUIRE(identity_in(directory) == coarse);
    REQUIRE_FALSE(holds_finished_run(directory));
}

TEST_CASE("a second claim on a directory in use is refused, and granted afterwards", "[store]") {
    const ScratchFolder folder;
    {
        const RunDirectory run(folder, coarse);
        REQUIRE_THROWS_AS(RunDirectory(folder, coarse), EnvironmentError);
        REQUIRE_THROWS_WITH(RunDirectory(folder, coarse, OnConflict::replace),
                            Catch::Contains("another process is working"));
    }
    REQUIRE_NOTHROW(RunDirectory(folder, coarse));
}

TEST_CASE("a refused claim does not keep the lock", "[store]") {
    const ScratchFolder folder;
    { const RunDirectory run(folder, coarse); }
    REQUIRE_THROWS_AS(RunDirectory(folder, fine), InputError);
    REQUIRE_NOTHROW(RunDirectory(folder, coarse));
}

TEST_CASE("an interrupted run is taken over with its files", "[store]") {
    const ScratchFolder folder;
    { const RunDirectory run(folder, coarse); }
    samples::put_bytes(folder / "live.h5", "rows");
    const RunDirectory run(folder, coarse);
    REQUIRE(samples::bytes_of(folder / "live.h5") == "rows");
}

TEST_CASE("a directory of another run is refused with what it holds and what to do", "[store]") {
    const ScratchFolder folder;
    { const RunDirectory run(folder, coarse); }
    REQUIRE_THROWS_WITH(RunDirectory(folder, fine), Catch::Contains("another, unfinished run (" + coarse) &&
                                                        Catch::Contains("choose another directory"));
    REQUIRE(identity_in(folder) == coarse);
}

TEST_CASE("a directory with a finished run is refused, whoever it belongs to", "[store]") {
    const ScratchFolder folder;
    SECTION("the same") {
        const RunDirectory run(folder, coarse);
    }
    SECTION("unknown") {}
    write_run(folder, samples::record(3));
    REQUIRE(holds_finished_run(folder));
    REQUIRE_THROWS_AS(RunDirectory(folder, coarse), InputError);
    REQUIRE_THROWS_WITH(RunDirectory(folder, coarse), Catch::Contains("holds a finished run"));
    REQUIRE(holds_finished_run(folder));
}

TEST_CASE("replacing removes the files of a run and no others", "[store]") {
    const ScratchFolder folder;
    { const RunDirectory run(folder, fine); }
    std::filesystem::create_directory(folder / "fields");
    for (const char* name : {"run.h5", "run.h5.tmp", "live.h5", "fields.pvd", "checkpoint_000010.h5",
                             "fields/frame_000000.vtp", "notes.txt", "fields/mine.png"}) {
        samples::put_bytes(folder / name, "x");
    }
    const RunDirectory run(folder, coarse, OnConflict::replace);
    REQUIRE(identity_in(folder) == coarse);
    std::vector<std::string> left = samples::names_in(folder);
    std::sort(left.begin(), left.end());
    REQUIRE(left == std::vector<std::string>{".lock", "fields", "identity", "notes.txt"});
    REQUIRE(samples::names_in(folder / "fields") == std::vector<std::string>{"mine.png"});
}

TEST_CASE("an atomic write replaces the bytes and leaves no temporary file", "[store]") {
    const ScratchFolder folder;
    const std::string bytes("a\0b\n", 4);
    atomic_write(folder / "file", "old and longer");
    atomic_write(folder / "file", bytes);
    REQUIRE(samples::bytes_of(folder / "file") == bytes);
    REQUIRE(samples::names_in(folder) == std::vector<std::string>{"file"});
}

TEST_CASE("an atomic write that cannot replace its target removes its temporary file", "[store]") {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "target/inside");
    REQUIRE_THROWS_AS(atomic_write(folder / "target", "x"), EnvironmentError);
    REQUIRE(samples::names_in(folder) == std::vector<std::string>{"target"});
}

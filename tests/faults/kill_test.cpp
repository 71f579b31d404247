// SPDX-License-Identifier: BSD-3-Clause
// kill -9 at bad moments: what is on disk afterwards is whole, or clearly refused.
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "solver/core/errors.hpp"
#include "tests/faults/fault_support.hpp"
#include "validation/store/fields.hpp"
#include "validation/store/live_series.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;
using samples::Child;
using samples::ScratchFolder;

namespace {

const std::vector<LiveColumn> columns = {{"force", "N/m", "on the body"}};

void append(LiveSeries& live, int row) {
    live.append(row, std::vector<double>{-3.0 * row});
}

bool is_gapless(const Series& force) {
    bool gapless = true;
    for (std::size_t i = 0; i < force.time.size(); ++i) {
        gapless = gapless && force.time[i] == double(i) && force.value[i] == -3.0 * double(i);
    }
    return gapless;
}

/// Spreads kills over the time a child works.
void sleep_for_attempt(int attempt) {
    std::this_thread::sleep_for(std::chrono::microseconds(700 * attempt));
}

}  // namespace

TEST_CASE("a killed run keeps every block of its live series that was flushed", "[faults]") {
    const ScratchFolder folder;
    Child child([&](const auto& signal_ready) {
        LiveSeries live(folder, columns, 8);
        for (int row = 0; row < 1005; ++row) append(live, row);
        signal_ready();
        ::pause();
    });
    REQUIRE(child.wait_until_ready());
    child.kill();
    const Series force = read_live(folder).at("force");
    REQUIRE(force.time.size() == 1000);  // 125 blocks; five rows were still in memory
    REQUIRE(is_gapless(force));
}

TEST_CASE("live series can be read by another process while the run goes on", "[faults]") {
    const ScratchFolder folder;
    const Child child([&](const auto& signal_ready) {
        LiveSeries live(folder, columns, 8);
        for (int row = 0; row < 24; ++row) append(live, row);
        signal_ready();
        ::pause();
    });
    REQUIRE(child.wait_until_ready());
    REQUIRE(read_live(folder).at("force").time.size() == 24);
}

TEST_CASE("a run killed while it writes its live series leaves rows without gaps or a clear refusal",
          "[faults]") {
    int read = 0;
    for (int attempt = 0; attempt < 15; ++attempt) {
        const ScratchFolder folder;
        Child child([&](const auto& signal_ready) {
            LiveSeries live(folder, columns, 8);
            signal_ready();
            for (int row = 0;; ++row) append(live, row);
        });
        REQUIRE(child.wait_until_ready());
        sleep_for_attempt(attempt);
        child.kill();
        try {
            const Series force = read_live(folder).at("force");
            REQUIRE(is_gapless(force));
            ++read;
        } catch (const DataError&) {  // killed inside a flush
        }
        REQUIRE_NOTHROW(LiveSeries(folder, columns, 8));  // the next run can go on either way
    }
    REQUIRE(read > 0);
}

TEST_CASE("a kill while a run is stored leaves no run or a whole one", "[faults]") {
    const RunRecord record = samples::record(50'000);
    for (int attempt = 0; attempt < 25; ++attempt) {
        const ScratchFolder folder;
        Child child([&](const auto& signal_ready) {
            signal_ready();
            write_run(folder, record);
            ::pause();
        });
        REQUIRE(child.wait_until_ready());
        sleep_for_attempt(attempt);
        child.kill();
        if (holds_finished_run(folder)) REQUIRE(samples::same(read_run(run_file(folder)), record));
    }
}

TEST_CASE("a kill while a stored run is replaced leaves the old or the new one", "[faults]") {
    const RunRecord old = samples::record(20'000);
    const RunRecord replacement = samples::record(50'000);
    for (int attempt = 0; attempt < 15; ++attempt) {
        const ScratchFolder folder;
        write_run(folder, old);
        Child child([&](const auto& signal_ready) {
            signal_ready();
            write_run(folder, replacement);
        });
        REQUIRE(child.wait_until_ready());
        sleep_for_attempt(2 * attempt);
        child.kill();
        const RunRecord found = read_run(run_file(folder));
        REQUIRE((samples::same(found, old) || samples::same(found, replacement)));
    }
}

TEST_CASE("a kill while fields are written leaves a collection of whole frames", "[faults]") {
    std::size_t most = 0;
    // longer and longer: on a busy machine the first frame may take its time
    for (int attempt = 0; attempt < 15 || (most == 0 && attempt < 150); ++attempt) {
        const ScratchFolder folder;
        Child child([&](const auto& signal_ready) {
            FieldWriter writer(folder);
            signal_ready();
            for (int i = 0;; ++i) writer.write(samples::frame(i));
        });
        REQUIRE(child.wait_until_ready());
        sleep_for_attempt(5 * attempt);
        child.kill();
        const std::vector<FrameEntry> frames = list_frames(folder);
        for (const FrameEntry& entry : frames) {
            REQUIRE(samples::same(read_frame(entry.path), samples::frame(entry.time)));
        }
        most = std::max(most, frames.size());
    }
    REQUIRE(most > 0);
}

TEST_CASE("a directory is locked against other processes until its owner dies", "[faults]") {
    const ScratchFolder folder;
    Child child([&](const auto& signal_ready) {
        const RunDirectory run(folder, "identity");
        signal_ready();
        ::pause();
    });
    REQUIRE(child.wait_until_ready());
    REQUIRE_THROWS_WITH(RunDirectory(folder, "identity"), Catch::Contains("another process is working"));
    child.kill();
    REQUIRE_NOTHROW(RunDirectory(folder, "identity"));
}

// SPDX-License-Identifier: BSD-3-Clause
// Damaged files do not reach HDF5: a broken seal is refused first, and a file without a seal is first read in
// a child process, here with stand-ins for the reader.
#include <dlfcn.h>
#include <hdf5.h>
#include <signal.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_store.hpp"
#include "validation/store/seal.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {
int files_opened = 0;
}

/// Stands before the function of HDF5 in this program, and counts.
extern "C" hid_t H5Fopen(const char* name, unsigned flags, hid_t access) {
    static const auto original = reinterpret_cast<decltype(&H5Fopen)>(::dlsym(RTLD_NEXT, "H5Fopen"));
    ++files_opened;
    return original(name, flags, access);
}

namespace {

/// Files that HDF5 opens while `read` is at work.
template <class Read>
int opened_by(const Read& read) {
    files_opened = 0;
    read();
    return files_opened;
}

/// Changes one bit of every byte of the file in turn; each file is refused before HDF5 opens it.
template <class Read>
void expect_refusal_before_hdf5(const std::filesystem::path& file, std::size_t stride, const Read& read) {
    REQUIRE(opened_by(read) > 0);  // the counter counts
    const std::string whole = samples::bytes_of(file);
    const std::size_t seal_begin = whole.size() - seal_of("").size();
    for (std::size_t place = 0; place < seal_begin + sizeof(std::uint64_t); place += stride) {
        std::string bytes = whole;
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << place % 8));
        samples::put_bytes(file, bytes);
        CHECK(opened_by([&] { REQUIRE_THROWS_AS(read(), DataError); }) == 0);
    }
}

std::string refusal_of(const std::function<void()>& reader, const ReadingTime& limit) {
    try {
        try_in_child_process("run.h5", reader, limit);
    } catch (const DataError& error) {
        return error.what();
    }
    return "no refusal";
}

constexpr ReadingTime no_limit = {100, 100};

}  // namespace

TEST_CASE("a run with a broken seal is refused before HDF5 opens it", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(10));
    expect_refusal_before_hdf5(run_file(folder), 31, [&] { read_run(run_file(folder)); });
}

TEST_CASE("a checkpoint with a broken seal, or without one, is refused before HDF5 opens it", "[store]") {
    const ScratchFolder folder;
    Checkpoint checkpoint;
    checkpoint.step = 3;
    checkpoint.arrays["x"] = {1, 2, 3};
    write_checkpoint(folder, checkpoint);
    const std::filesystem::path file = list_checkpoints(folder).front();
    const auto read = [&] { read_checkpoint(file); };
    SECTION("broken") {
        expect_refusal_before_hdf5(file, 31, read);
    }
    SECTION("absent") {
        std::string bytes = samples::bytes_of(file);
        samples::put_bytes(file, bytes.substr(0, bytes.size() - seal_of("").size()));
        CHECK(opened_by([&] { REQUIRE_THROWS_AS(read(), DataError); }) == 0);
    }
}

TEST_CASE("a run without a seal is opened only once the child process has read it", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(10));
    const std::string bytes = samples::bytes_of(run_file(folder));
    samples::put_bytes(run_file(folder), bytes.substr(0, bytes.size() - seal_of("").size()));
    CHECK(opened_by([&] { read_run(run_file(folder)); }) == 1);  // the child counts for itself
}

TEST_CASE("a reader that crashes in the child process gives one clear message", "[store]") {
    const char* message = "run.h5: damaged, HDF5 crashes while reading it";
    CHECK(refusal_of([] { std::abort(); }, no_limit) == message);
    CHECK(refusal_of([] { ::raise(SIGSEGV); }, no_limit) == message);
    CHECK(refusal_of([] { ::_exit(3); }, no_limit) == message);
}

TEST_CASE("a reader that spins or sleeps past its limit gives one clear message", "[store]") {
    const char* message = "run.h5: damaged, HDF5 does not finish reading it";
    const auto start = std::chrono::steady_clock::now();
    CHECK(refusal_of(
              [] {
                  for (volatile bool endless = true; endless;) {
                  }
              },
              {0.05, 100}) == message);
    CHECK(refusal_of([] { ::sleep(100); }, {100, 0.05}) == message);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(50));
}

TEST_CASE("a reader that returns, or throws, in the child process is left to the parent", "[store]") {
    CHECK(refusal_of([] {}, no_limit) == "no refusal");
    CHECK(refusal_of([] { throw DataError("refused by the reader itself"); }, no_limit) == "no refusal");
}

TEST_CASE("the time allowed for reading grows with the file", "[store]") {
    const ScratchFolder folder;
    const ReadingTime none = reading_time(folder / "none");
    samples::put_bytes(folder / "large", std::string(std::size_t{1} << 23, ' '));
    const ReadingTime large = reading_time(folder / "large");
    CHECK(none.processor_s == Approx(0.5));
    CHECK(large.processor_s == Approx(1.5));
    CHECK(large.wall_s > none.wall_s);
    CHECK(none.wall_s > 60);
}

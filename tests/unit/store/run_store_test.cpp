// SPDX-License-Identifier: BSD-3-Clause
// run.h5: exact round trip, and nothing but a whole file is accepted.
#include "validation/store/run_store.hpp"

#include <hdf5_hl.h>

#include <catch2/catch.hpp>
#include <functional>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/store/hdf5_values.hpp"
#include "validation/store/seal.hpp"

using namespace wetdeck;
using samples::ScratchFolder;

namespace {

RunRecord round_trip(const RunRecord& record) {
    const ScratchFolder folder;
    write_run(folder, record);
    return read_run(run_file(folder));
}

/// What read_run says after `change` has been made to a sound file.
void expect_refusal(const std::function<void(const hdf5::Node&)>& change, const std::string& message) {
    const ScratchFolder folder;
    write_run(folder, samples::record(10));
    change(hdf5::open_file(run_file(folder), hdf5::Access::append));
    REQUIRE_THROWS_WITH(read_run(run_file(folder)),
                        Catch::Contains(run_file(folder).string()) && Catch::Contains(message));
    REQUIRE_THROWS_AS(read_run(run_file(folder)), DataError);
}

}  // namespace

TEST_CASE("a run comes back from its file bit for bit", "[store]") {
    const RunRecord record = samples::record();
    REQUIRE(samples::same(round_trip(record), record));
}

TEST_CASE("a record of nothing comes back as nothing", "[store]") {
    REQUIRE(samples::same(round_trip(RunRecord{}), RunRecord{}));
}

TEST_CASE("the comparison of records notices a change of one bit", "[store]") {
    const RunRecord record = samples::record();
    RunRecord changed = record;
    changed.series["front"].value[7] = std::nextafter(changed.series["front"].value[7], 2.0);
    REQUIRE_FALSE(samples::same(changed, record));
}

TEST_CASE("a scene text of a megabyte and a thousand parameters fit", "[store]") {
    RunRecord record = samples::record(3);
    while (record.scene_text.size() < 1'000'000) record.scene_text += "# überlanger Kommentar\n";
    for (int i = 0; i < 1000; ++i) record.parameters["group.key_" + std::to_string(i)] = i / 3.0;
    REQUIRE(samples::same(round_trip(record), record));
}

TEST_CASE("readers of netCDF find the coordinates of each series", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(10));
    const hdf5::Node file = hdf5::open_file(run_file(folder), hdf5::Access::read);
    const hid_t value = H5Dopen2(file.id(), "/series/front/value", H5P_DEFAULT);
    const hid_t time = H5Dopen2(file.id(), "/series/front/time", H5P_DEFAULT);
    REQUIRE(value >= 0);
    CHECK(H5DSis_attached(value, time, 0) > 0);
    H5Dclose(time);
    H5Dclose(value);
}

TEST_CASE("keys that are taken in the file survive", "[store]") {
    RunRecord record = samples::record(3);
    record.parameters["particle_spacing"] = 0.25;
    record.parameters["model.air"] = 1;
    record.parameters["choice:odd"] = 2;
    record.parameters[""] = 3;
    record.provenance["variant"] = "another";
    record.provenance["model.air"] = "yes";
    record.provenance["parameter:odd"] = "odd";
    REQUIRE(samples::same(round_trip(record), record));
}

TEST_CASE("writing a run again replaces the file and leaves nothing else", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(5));
    write_run(folder, samples::record(7));
    REQUIRE(read_run(run_file(folder)).series.at("front").time.size() == 7);
    REQUIRE(samples::names_in(folder) == std::vector<std::string>{"run.h5"});
}

TEST_CASE("a series whose lengths disagree is not written", "[store]") {
    const ScratchFolder folder;
    RunRecord record = samples::record(5);
    record.series["front"].value.pop_back();
    REQUIRE_THROWS_WITH(write_run(folder, record), Catch::Contains("front: 4 values for 5 times"));
    REQUIRE(samples::names_in(folder).empty());
}

TEST_CASE("a series name with a slash is not written", "[store]") {
    const ScratchFolder folder;
    RunRecord record = samples::record(5);
    record.series["a/b"] = {};
    REQUIRE_THROWS_WITH(write_run(folder, record), Catch::Contains("'a/b' cannot be a name"));
}

TEST_CASE("a missing run file is a data error that names it", "[store]") {
    const ScratchFolder folder;
    REQUIRE_THROWS_AS(read_run(run_file(folder)), DataError);
    REQUIRE_THROWS_WITH(read_run(run_file(folder)), run_file(folder).string() + ": no such file");
}

TEST_CASE("a run file cut anywhere is refused", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record());
    const std::string whole = samples::bytes_of(run_file(folder));
    const double part = GENERATE(0.0, 0.001, 0.1, 0.5, 0.9, 0.999);
    samples::put_bytes(run_file(folder),
                       whole.substr(0, static_cast<std::size_t>(part * double(whole.size()))));
    REQUIRE_THROWS_AS(read_run(run_file(folder)), DataError);
    REQUIRE_THROWS_WITH(read_run(run_file(folder)), Catch::Contains("truncated or not an HDF5 file"));
}

TEST_CASE("garbage instead of a run file is refused", "[store]") {
    const ScratchFolder folder;
    samples::put_bytes(run_file(folder), std::string(5000, 'x'));
    REQUIRE_THROWS_WITH(read_run(run_file(folder)), Catch::Contains("truncated or not an HDF5 file"));
}

TEST_CASE("a directory instead of a run file is refused", "[store]") {
    const ScratchFolder folder;
    REQUIRE_THROWS_AS(read_run(folder), std::runtime_error);
}

TEST_CASE("a flipped bit is noticed wherever it is", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(20000));
    const std::string whole = samples::bytes_of(run_file(folder));
    const double part = GENERATE(0.0, 0.1, 0.5, 0.9, 0.99);
    const auto place = static_cast<std::size_t>(part * double(whole.size()));
    std::string bytes = whole;
    bytes[place] = static_cast<char>(bytes[place] ^ 0x10);
    samples::put_bytes(run_file(folder), bytes);
    REQUIRE_THROWS_WITH(read_run(run_file(folder)), Catch::Contains("the checksum does not match"));
    REQUIRE_THROWS_AS(read_run(run_file(folder)), DataError);
}

TEST_CASE("a run file that another program has written to is read", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(10));
    {
        const hdf5::Node file = hdf5::open_file(run_file(folder), hdf5::Access::append);
        const hdf5::Node meta = open_group(file, "meta");
        H5Adelete(meta.id(), "scene");
        write_attribute(meta, "scene", std::string("another"));
    }
    REQUIRE(seal_in(run_file(folder)) == Seal::absent);
    REQUIRE(read_run(run_file(folder)).scene == "another");
}

TEST_CASE("damaged samples of a file without a seal are noticed", "[store]") {
    const ScratchFolder folder;
    write_run(folder, samples::record(20000));
    std::string bytes = samples::bytes_of(run_file(folder));
    bytes.resize(bytes.size() - seal_of(bytes).size());
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);  // inside a deflated chunk
    samples::put_bytes(run_file(folder), bytes);
    REQUIRE_THROWS_WITH(read_run(run_file(folder)), Catch::Contains("/series/front"));
}

TEST_CASE("a run file that lacks a part says which", "[store]") {
    expect_refusal([](const auto& file) { H5Ldelete(file.id(), "/cost", H5P_DEFAULT); },
                   "/cost: the group is");
    expect_refusal([](const auto& file) { H5Ldelete(file.id(), "/series/front/time", H5P_DEFAULT); },
                   "/series/front/time: the dataset is missing");
    expect_refusal([](const auto& file) { H5Adelete_by_name(file.id(), "/meta", "status", H5P_DEFAULT); },
                   "/meta attribute status: the attribute is missing");
}

TEST_CASE("a run file with a wrong type or value says where", "[store]") {
    expect_refusal(
        [](const auto& file) {
            const hdf5::Node meta = open_group(file, "meta");
            H5Adelete(meta.id(), "status");
            write_attribute(meta, "status", std::string("splendid"));
        },
        "run status is 'splendid', expected ok, unstable or failed");
    expect_refusal(
        [](const auto& file) {
            const hdf5::Node cost = open_group(file, "cost");
            H5Adelete(cost.id(), "steps");
            write_attribute(cost, "steps", std::string("many"));
        },
        "/cost attribute steps: expected one integer");
    expect_refusal(
        [](const auto& file) {
            const hdf5::Node meta = open_group(file, "meta");
            H5Adelete(meta.id(), "schema");
            write_attribute(meta, "schema", std::uint64_t{99});
        },
        "schema 99, this program reads 1");
    expect_refusal(
        [](const auto& file) {
            const hdf5::Node front = open_group(open_group(file, "series"), "front");
            H5Ldelete(front.id(), "value", H5P_DEFAULT);
            write_array(front, "value", std::vector<double>(9));
        },
        "/series/front: value does not match");
}

TEST_CASE("the words of the status are those of the summary", "[store]") {
    REQUIRE(to_string(RunStatus::ok) == "ok");
    REQUIRE(to_string(RunStatus::unstable) == "unstable");
    REQUIRE(to_string(RunStatus::failed) == "failed");
    REQUIRE(run_status_from("failed") == RunStatus::failed);
    REQUIRE_THROWS_AS(run_status_from("Failed"), DataError);
}

// SPDX-License-Identifier: BSD-3-Clause
// Checkpoint files: every bit comes back, the two newest stay, damage is noticed.
#include "validation/store/checkpoint.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/store/atomic_write.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::ScratchFolder;

namespace {

Checkpoint checkpoint_at(std::uint64_t step) {
    Checkpoint checkpoint;
    checkpoint.step = step;
    checkpoint.texts = {{"scene_text", "# Δx\n[water]\n"}, {"empty", ""}};
    checkpoint.numbers = {{"time", 0.1 * static_cast<double>(step)}, {"tiny", 5e-324}};
    checkpoint.arrays["none"] = {};
    checkpoint.arrays["solver.fluid"] = {1.0, -0.0, std::nan(""), 1e300};
    for (int i = 0; i < 3000; ++i) checkpoint.arrays["long"].push_back(std::sin(i));
    return checkpoint;
}

bool same(const Checkpoint& a, const Checkpoint& b) {
    bool equal = a.step == b.step && a.texts == b.texts && a.numbers == b.numbers &&
                 a.arrays.size() == b.arrays.size();
    for (const auto& [name, values] : a.arrays) {
        const auto other = b.arrays.find(name);
        equal = equal && other != b.arrays.end() && samples::same_bits(values, other->second);
    }
    return equal;
}

void truncate(const std::filesystem::path& file, double share) {
    const auto size = static_cast<double>(std::filesystem::file_size(file));
    std::filesystem::resize_file(file, static_cast<std::uintmax_t>(share * size));
}

}  // namespace

TEST_CASE("a checkpoint comes back bit by bit", "[store]") {
    const ScratchFolder folder;
    REQUIRE_FALSE(newest_checkpoint(folder));
    write_checkpoint(folder, checkpoint_at(7));
    REQUIRE(same(newest_checkpoint(folder).value(), checkpoint_at(7)));
}

TEST_CASE("the two newest checkpoints are kept, and nothing else of them", "[store]") {
    const ScratchFolder folder;
    for (const std::uint64_t step : {0, 9, 10, 1000}) write_checkpoint(folder, checkpoint_at(step));
    REQUIRE(samples::names_in(folder).size() == 2);
    const std::vector<std::filesystem::path> files = list_checkpoints(folder);
    REQUIRE(read_checkpoint(files.at(0)).step == 1000);
    REQUIRE(read_checkpoint(files.at(1)).step == 10);
    remove_checkpoints(folder);
    REQUIRE(samples::names_in(folder).empty());
}

TEST_CASE("a truncated checkpoint is passed over for the one before", "[store]") {
    const ScratchFolder folder;
    write_checkpoint(folder, checkpoint_at(10));
    write_checkpoint(folder, checkpoint_at(20));
    const double share = GENERATE(0.0, 0.01, 0.5, 0.9, 0.999);
    truncate(list_checkpoints(folder).front(), share);
    REQUIRE_THROWS_AS(read_checkpoint(list_checkpoints(folder).front()), DataError);
    REQUIRE(newest_checkpoint(folder).value().step == 10);
    // Going on from there, the damaged one must not count as newer than what is written next.
    remove_checkpoints_after(folder, 10);
    REQUIRE(list_checkpoints(folder).size() == 1);
}

TEST_CASE("checkpoints that are all damaged are an error that names the directory", "[store]") {
    const ScratchFolder folder;
    write_checkpoint(folder, checkpoint_at(10));
    truncate(list_checkpoints(folder).front(), 0.5);
    const std::filesystem::path path = folder;
    REQUIRE_THROWS_WITH(newest_checkpoint(folder),
                        Contains(path.string() + ": no checkpoint can be read") && Contains("truncated"));
}

TEST_CASE("a flipped bit anywhere in a checkpoint is noticed", "[store]") {
    const ScratchFolder folder;
    write_checkpoint(folder, checkpoint_at(10));
    const std::filesystem::path file = list_checkpoints(folder).front();
    const std::string bytes = samples::bytes_of(file);
    for (std::size_t place = 0; place < bytes.size(); place += 97) {
        std::string damaged = bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ (1 << place % 8));
        samples::put_bytes(file, damaged);
        REQUIRE_THROWS_AS(read_checkpoint(file), DataError);
    }
}

TEST_CASE("the half-written file of a killed process is no checkpoint", "[store]") {
    const ScratchFolder folder;
    samples::put_bytes(temporary_name(folder / "checkpoint_000000000001.h5"), "half");
    REQUIRE_FALSE(newest_checkpoint(folder));
}

TEST_CASE("an entry that a checkpoint lacks is named", "[store]") {
    const Checkpoint checkpoint = checkpoint_at(1);
    REQUIRE_THROWS_WITH(checkpoint.text("a"), Contains("lacks 'a'"));
    REQUIRE_THROWS_WITH(checkpoint.number("b"), Contains("lacks 'b'"));
    REQUIRE_THROWS_AS(checkpoint.array("c"), DataError);
}

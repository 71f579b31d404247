// SPDX-License-Identifier: BSD-3-Clause
// Seeds and found cases of the fuzz targets: each is read or refused, without a crash, in the ordinary build.
#include <catch2/catch.hpp>

#include "tests/fuzz/targets.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;

TEST_CASE("every case of the fuzz targets is read or refused", "[fuzz]") {
    const std::filesystem::path cases = std::filesystem::path(WETDECK_SOURCE_DIR) / "tests/fuzz/cases";
    for (const auto& [name, target] : fuzz::targets()) {
        int seeds = 0;
        for (const auto& entry : std::filesystem::directory_iterator(cases / name)) {
            INFO(entry.path().string());
            const std::string bytes = samples::bytes_of(entry.path());
            const bool read = target(bytes);
            if (entry.path().filename().string().starts_with("seed_")) REQUIRE(read);
            seeds += read;
        }
        REQUIRE(seeds > 0);  // else the target does not reach the reader
    }
}

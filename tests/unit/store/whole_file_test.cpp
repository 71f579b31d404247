// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/whole_file.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;

TEST_CASE("A file is read whole, zero bytes and line ends included", "[whole_file]") {
    const samples::ScratchFolder folder;
    const std::string bytes("a\r\n\0b\n", 6);
    samples::put_bytes(folder / "file", bytes);
    CHECK(read_whole_file(folder / "file") == bytes);
    samples::put_bytes(folder / "empty", "");
    CHECK(read_whole_file(folder / "empty").empty());
}

TEST_CASE("A file that cannot be read is named with the reason", "[whole_file]") {
    const samples::ScratchFolder folder;
    CHECK_THROWS_WITH(read_whole_file(folder / "none"),
                      Catch::Contains("none: cannot read") && Catch::Contains("No such file"));
    CHECK_THROWS_AS(read_whole_file(folder), EnvironmentError);
}

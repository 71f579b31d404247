// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/whole_file.hpp"

#include <catch2/catch.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/store/hash.hpp"

using namespace wetdeck;

TEST_CASE("a file comes back with all its bytes", "[store]") {
    const samples::ScratchFolder folder;
    for (const std::string& bytes : {std::string(), std::string("a\0\r\n\xff", 5)}) {
        samples::put_bytes(folder / "a", bytes);
        CHECK(read_whole_file(folder / "a") == bytes);
    }
}

TEST_CASE("a file that cannot be read is named with the reason", "[store]") {
    const samples::ScratchFolder folder;
    CHECK_THROWS_WITH(read_whole_file(folder / "none"),
                      (folder / "none").string() + ": cannot read: No such file or directory");
    CHECK_THROWS_AS(read_whole_file(folder), EnvironmentError);
}

TEST_CASE("the hashes are those of the definition", "[store]") {
    CHECK(fnv1a("") == 0xcbf29ce484222325U);
    CHECK(fnv1a("foobar") == 0x85944171f73967e8U);  // published test vector
    CHECK(fnv1a_of_words("") == 0xcbf29ce484222325U);
    CHECK(fnv1a_of_words("12345678") != fnv1a_of_words("12345679"));
    CHECK(fnv1a_of_words("1234567") == fnv1a_of_words(std::string("1234567\0", 8)));
}

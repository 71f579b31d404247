// SPDX-License-Identifier: BSD-3-Clause
// Files that are no scenes at all.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;
using Catch::Contains;
using samples::refusal;
using samples::ScratchFolder;

TEST_CASE("malformed TOML is refused with file and line") {
    REQUIRE_THAT(refusal("schema = 1\nname = \"open\ntitle = 3\n"), Catch::StartsWith("small.toml:2: "));
    REQUIRE_THAT(refusal("schema = 1\nschema = 2\n"), Catch::StartsWith("small.toml:2: "));
    REQUIRE_THAT(refusal("[tank\nsize = 1\n"), Catch::StartsWith("small.toml:1: "));
    REQUIRE_THAT(refusal("x = [1, 2\n"), Catch::StartsWith("small.toml:"));
    REQUIRE_THAT(refusal("\xff\xfe = 1\n"), Catch::StartsWith("small.toml:1: "));
}

TEST_CASE("input on which assertions of the parser fail is refused and stops nothing") {
    REQUIRE_THAT(refusal("[[[[phase]]\ngamm] "), Catch::StartsWith("small.toml:1: "));
    REQUIRE_THAT(refusal("\xee\x80\x80 = 1\n"), Catch::StartsWith("small.toml"));  // U+E000, private use
    REQUIRE_THAT(refusal("[water]\na\xef\xa3\xbf = 1\n"), Catch::StartsWith("small.toml"));  // U+F8FF
}

TEST_CASE("every beginning of a scene file is refused or taken, and stops nothing") {
    std::size_t taken = 0;
    for (std::size_t length = 0; length < samples::small_scene.size(); length += 7) {
        if (refusal(samples::small_scene.substr(0, length)).empty()) ++taken;
    }
    REQUIRE(taken < samples::small_scene.size() / 7 / 2);  // the end of a file holds optional parts only
}

TEST_CASE("brackets nested without end are refused") {
    REQUIRE_THAT(refusal("x = " + std::string(100'000, '[')), Catch::StartsWith("small.toml"));
}

TEST_CASE("an empty file is refused") {
    REQUIRE_THAT(refusal(""), Contains("key 'variants': missing, expected a table"));
}

TEST_CASE("a huge file is refused before it is read") {
    const ScratchFolder folder;
    samples::put_bytes(folder / "huge.toml", std::string(1'000'001, '#'));
    REQUIRE_THROWS_AS(read_scene(folder / "huge.toml"), InputError);
    REQUIRE_THROWS_WITH(read_scene(folder / "huge.toml"),
                        (folder / "huge.toml").string() + ": larger than 1000000 bytes, not a scene file");
}

TEST_CASE("a folder, a device or a missing file is no scene file") {
    const ScratchFolder folder;
    const std::filesystem::path folder_path = folder;
    for (const std::filesystem::path& path :
         {folder_path, folder / "missing.toml", std::filesystem::path("/dev/zero")}) {
        REQUIRE_THROWS_AS(read_scene(path), InputError);
        REQUIRE_THROWS_WITH(read_scene(path), path.string() + ": no such scene file");
    }
}

TEST_CASE("a scene is found by name or by path, and the names are listed for any other") {
    REQUIRE(find_scene("dam_break") == scene_directory() / "dam_break.toml");
    REQUIRE(find_scene("own/file.toml") == "own/file.toml");
    REQUIRE_THROWS_AS(find_scene("dam_brake"), InputError);
    REQUIRE_THROWS_WITH(find_scene("dam_brake"), Contains("no scene 'dam_brake', expected one of") &&
                                                     Contains("dam_break") &&
                                                     Contains("or the path of a scene file"));
}

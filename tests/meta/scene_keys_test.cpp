// SPDX-License-Identifier: BSD-3-Clause
// The reference of the keys of a scene file against what the program reads.
#include "validation/scene/scene_keys.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "validation/scene/probe.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/whole_file.hpp"

using namespace wetdeck;
namespace fs = std::filesystem;

namespace {

/// The parts of all keys: "probes[].name" has probes and name.
std::set<std::string> described_names() {
    std::set<std::string> names;
    for (const SceneKeySection& section : scene_keys()) {
        for (const SceneKey& key : section.keys) {
            std::istringstream parts(std::regex_replace(key.key, std::regex("\\[\\]"), ""));
            for (std::string part; std::getline(parts, part, '.');) names.insert(part);
        }
    }
    return names;
}

/// The sources that read scene files; the outline of a body and a curve are files of their own.
std::vector<fs::path> readers() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(WETDECK_SOURCE_DIR) / "validation/scene"))
        if (entry.path().extension() == ".cpp" && entry.path().filename() != "scene_keys.cpp")
            files.push_back(entry.path());
    return files;
}

}  // namespace

TEST_CASE("every key that the readers of a scene ask for is in the reference", "[scene_keys]") {
    const std::set<std::string> names = described_names();
    const std::regex asks(
        R"re((?:number|number_or|positive|optional_number|boolean_or|text|text_or|choice|numbers|number_rows|texts|table|optional_table|tables|point|point_or|window|interval|variants)\((?:table, )?"([a-z_]+)")re");
    std::set<std::string> asked;
    for (const fs::path& file : readers()) {
        const std::string source = read_whole_file(file);
        for (std::sregex_iterator found(source.begin(), source.end(), asks), end; found != end; ++found)
            asked.insert((*found)[1]);
    }
    CHECK(asked.size() > 100);
    for (const std::string& name : asked) {
        INFO(name);
        CHECK(names.contains(name));
    }
}

TEST_CASE("every key of the reference is read by some source, and says what it is", "[scene_keys]") {
    std::string sources;
    for (const fs::path& file : readers()) sources += read_whole_file(file);
    for (const std::string& name : described_names()) {
        INFO(name);
        const bool free_name = name == "NAME" || name == "TIER" || name == "VARIANT";
        CHECK((free_name || sources.find("\"" + name + "\"") != std::string::npos));
    }
    std::set<std::string> keys;
    for (const SceneKeySection& section : scene_keys()) {
        CHECK_FALSE(section.keys.empty());
        for (const SceneKey& key : section.keys) {
            INFO(key.key);
            CHECK(keys.insert(key.key).second);
            CHECK(key.range.size() >= 1);
            CHECK(key.meaning.size() > 1);
        }
    }
}

TEST_CASE("every key of a probe's type is in the reference", "[scene_keys]") {
    const std::set<std::string> names = described_names();
    for (const ProbeType& type : probe_types()) {
        for (const char* key : type.keys) CHECK(names.contains(key));
        for (const char* key : type.optional_keys) CHECK(names.contains(key));
    }
}

// SPDX-License-Identifier: BSD-3-Clause
// Where a result comes from.
#include "validation/store/provenance.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <vector>

using namespace wetdeck;

TEST_CASE("times are written in UTC to the second", "[store]") {
    using std::chrono::system_clock;
    REQUIRE(utc_text(system_clock::from_time_t(0)) == "1970-01-01T00:00:00.000Z");
    REQUIRE(utc_text(system_clock::from_time_t(1'717'156'800)) == "2024-05-31T12:00:00.000Z");
    REQUIRE(utc_text(system_clock::from_time_t(7) + std::chrono::milliseconds(58)) ==
            "1970-01-01T00:00:07.058Z");
}

TEST_CASE("provenance names program, build, machine and start", "[store]") {
    const auto start = std::chrono::system_clock::from_time_t(1'717'156'800);
    std::map<std::string, std::string> entries;
    collect_provenance("AVX2", 3, start).add_to(entries);
    for (const char* key :
         {"program_version", "commit", "compiler", "build_type", "libraries", "cpu", "host"}) {
        INFO(key);
        REQUIRE_FALSE(entries.at(key).empty());
    }
    REQUIRE(entries.at("simd") == "AVX2");
    REQUIRE(entries.at("threads") == "3");
    REQUIRE(entries.at("start_time") == "2024-05-31T12:00:00.000Z");
    REQUIRE(std::stoi(entries.at("cores")) > 0);
    REQUIRE_THAT(entries.at("libraries"), Catch::Contains("HDF5 1."));
}

TEST_CASE("provenance gives away neither host name nor folders", "[store]") {
    char name[256] = {};
    REQUIRE(::gethostname(name, sizeof name - 1) == 0);
    std::map<std::string, std::string> entries;
    collect_provenance("AVX2", 3).add_to(entries);
    for (const auto& [key, text] : entries) {
        INFO(key << " = " << text);
        REQUIRE(text.find(std::string("/home/")) == std::string::npos);
        REQUIRE(text != name);
    }
}

TEST_CASE("peak memory covers what was touched and agrees with the kernel's own account", "[store]") {
    const std::vector<char> block(100'000'000, 'x');
    const double peak = peak_rss_mb();
    REQUIRE(peak > 1e-6 * static_cast<double>(block.size()));
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word && word != "VmHWM:") {
    }
    double kibibytes = 0;
    REQUIRE(status >> kibibytes);
    REQUIRE(peak == Approx(kibibytes * 1024 / 1e6).epsilon(0.05));
}

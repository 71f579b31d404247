// SPDX-License-Identifier: BSD-3-Clause
// The table of probe types: each type reads the keys that its row names and records a series of its unit.
#include "validation/scene/probe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/recorders.hpp"
#include "validation/store/whole_file.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;
using Catch::EndsWith;

namespace {

/// A square body just above the water, 0.12 m wide, in the frame of its lower left corner.
const std::string with_body = small_scene + R"toml(
[body]
place = [0.1, 0.24]
outline = [[0.0, 0.0], [0.12, 0.0], [0.12, 0.12], [0.0, 0.12]]
free = []
)toml";

/// A value of each key that fits the scene; of x and width, a strip of water; of centre, a point of the body.
const std::map<std::string, std::string> values{{"body", "\"body\""},
                                                {"centre", "[0.12, 0.06]"},
                                                {"direction", "\"left\""},
                                                {"x_range", "[0.1, 0.3]"},
                                                {"y_range", "[0.0, 0.1]"},
                                                {"diameter", "0.04"},
                                                {"from", "[0.0, 0.0]"},
                                                {"to", "[0.12, 0.0]"},
                                                {"points", "3"},
                                                {"length", "0.08"},
                                                {"x", "0.2"},
                                                {"width", "0.08"},
                                                {"low", "0.1"},
                                                {"high", "0.3"}};

std::string value_of(const ProbeType& type, const std::string& key) {
    const bool on_wall = std::string(type.name) == "wall_pressure" && key == "centre";
    return on_wall ? "[1.0, 0.06]" : values.at(key);
}

std::string probe_text(const ProbeType& type, const std::string& left_out = "") {
    std::string text = fmt::format("[[probes]]\nname = \"new\"\ntype = \"{}\"\n", type.name);
    for (const auto& keys : {type.keys, type.optional_keys}) {
        for (const std::string key : keys)
            if (key != left_out) text += fmt::format("{} = {}\n", key, value_of(type, key));
    }
    return text;
}

}  // namespace

TEST_CASE("names of probe types are unique and each row is complete", "[probe]") {
    std::set<std::string> names;
    for (const ProbeType& type : probe_types()) {
        INFO(type.name);
        CHECK(names.insert(type.name).second);
        CHECK(std::string(type.records).size() > 10);
        CHECK_FALSE(std::string(type.unit).empty());
        CHECK(type.read != nullptr);
        for (const std::string key : type.keys) CHECK(values.contains(key));
        for (const std::string key : type.optional_keys) CHECK(values.contains(key));
    }
}

TEST_CASE("a probe of each type is read from the keys of its row and no others", "[probe]") {
    for (const ProbeType& type : probe_types()) {
        INFO(type.name);
        CHECK(refusal(with_body + probe_text(type)) == "");
        for (const std::string key : type.optional_keys) {
            CHECK(refusal(with_body + probe_text(type, key)) == "");
        }
        for (const std::string key : type.keys) {
            CHECK_THAT(refusal(with_body + probe_text(type, key)),
                       Contains(fmt::format("key 'probes[3].{}': missing", key)));
        }
        std::set<std::string> known(type.keys.begin(), type.keys.end());
        known.insert(type.optional_keys.begin(), type.optional_keys.end());
        known.insert({"name", "note", "type"});
        CHECK_THAT(refusal(with_body + probe_text(type) + "colour = 1\n"),
                   EndsWith(fmt::format("key 'probes[3].colour': unknown, expected one of {}",
                                        fmt::join(known, ", "))));
    }
}

TEST_CASE("a probe of each type records finite values of its unit", "[probe]") {
    for (const ProbeType& type : probe_types()) {
        INFO(type.name);
        const Scene scene = parse_scene(with_body + probe_text(type), "small.toml");
        const Probe& probe = scene.probes.back();
        CHECK(probe.series.name == "new");
        CHECK(probe.series.unit == type.unit);
        CHECK_FALSE(probe.series.description.empty());
        if (probe.check) CHECK_NOTHROW(probe.check(0.04));
        std::vector<double> recorded;
        probe.sample(assemble(scene, 0.04, 1), recorded);
        CHECK(recorded.size() == std::max<std::size_t>(1, probe.series.abscissa.size()));
        for (const double value : recorded) CHECK(std::isfinite(value));
    }
}

TEST_CASE("the recorders sample probes, bodies and fluid in the order of their list", "[probe]") {
    const Scene scene = parse_scene(with_body + probe_text(probe_types().back()), "small.toml");
    const Recorders recorders(scene, 0.04);
    const Simulation simulation = assemble(scene, 0.04, 1);
    std::vector<double> first, repeated;
    recorders.sample(simulation, 0, first);
    std::size_t columns = 0, body_y = 0;
    for (const SeriesInfo& info : recorders.list()) {
        if (info.name == "body_y") body_y = columns;
        columns += std::max<std::size_t>(1, info.abscissa.size());
    }
    REQUIRE(first.size() == columns);
    CHECK(first[body_y] == simulation.bodies()[0].position.y());
    repeated = first;
    repeated.back() = 0.125;  // momentum_error, taken at every 16th sample
    recorders.sample(simulation, 1, repeated);
    CHECK(repeated.back() == 0.125);
    recorders.sample(simulation, 16, repeated);
    CHECK(repeated.back() == first.back());
}

TEST_CASE("the list of probes in the documentation is that of the table", "[probe]") {
    const std::string text = read_whole_file(std::string(WETDECK_SOURCE_DIR) + "/validation/README.md");
    for (const ProbeType& type : probe_types()) {
        std::string keys;
        for (const std::string key : type.keys) keys += (keys.empty() ? "`" : ", `") + key + "`";
        std::string optional;
        for (const std::string key : type.optional_keys)
            optional += (optional.empty() ? "optional `" : ", `") + key + "`";
        if (!keys.empty() && !optional.empty()) keys += "; ";
        keys += optional;
        const std::string row =
            fmt::format("| `{}` | {} | {} | {} |\n", type.name, type.records, type.unit, keys);
        CHECK_THAT(text, Contains(row));
    }
}

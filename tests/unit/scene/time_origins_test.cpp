// SPDX-License-Identifier: BSD-3-Clause
// [time_origins]: numbers, contacts by name, crossings of a level, and what is refused.
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/metrics/time_origin.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/recorders.hpp"

using namespace wetdeck;
using namespace wetdeck::samples;
using Catch::Contains;

namespace {

const std::string bodies = R"toml(
[body]
position = [0.5, 0.24]
outline = [[0.0, 0.0], [0.12, 0.0], [0.12, 0.12], [0.0, 0.12]]
free = ["y"]
mass = 10.0

[body_2]
position = [0.1, 0.3]
outline = [[0.0, 0.06], [0.06, 0.0], [0.12, 0.06], [0.06, 0.12]]
free = []
)toml";

/// The small scene with bodies, [time_origins] and one quantity that counts from an origin.
std::string scene_with(const std::string& origins, const std::string& x_origin) {
    return small_scene + bodies + "\n[time_origins]\n" + origins +
           "\n[[quantities]]\nname = \"q\"\nmetric = \"mean\"\nseries = \"body_y\"\n" +
           (x_origin.empty() ? "" : "x_origin = \"" + x_origin + "\"\n");
}

const QuantitySpec& quantity_of(const Scene& scene) {
    return scene.analysis.quantities.back();
}

}  // namespace

TEST_CASE("an origin is a number, a contact of a body or the crossing of a level", "[origin]") {
    struct Row {
        std::string origins, x_origin, series;
        double level;
    };
    const std::vector<Row> rows = {
        {"contact = 0.25", "contact", "", 0.25},
        {"contact = \"10.5 ms\"", "contact", "", 0.0105},
        {"contact = \"geometric_contact\"", "contact", "body_clearance", 0},
        {"contact = \"geometric_contact_2\"", "contact", "body_clearance_2", 0},
        {"contact = \"first_contact\"", "contact", "body_water_gap", 0},
        {"", "first_contact", "body_water_gap", 0},
        {"first_contact = \"first_contact\"", "first_contact", "body_water_gap", 0},
        {"", "first_contact_2", "body_water_gap_2", 0},
        {"", "geometric_contact", "body_clearance", 0},
        {"down = { series = \"body_y\", crosses = 0.25 }", "down", "body_y", 0.25},
        {"down = { series = \"body_y_2\", crosses = 1, direction = \"falling\" }", "down", "body_y_2", 1},
        {"arrival = { series = \"front\", crosses = 0.9, direction = \"rising\" }", "arrival", "front", 0.9},
        {"hit = { series = \"gauge\", crosses = 500.0 }", "hit", "gauge", 500},
    };
    for (const Row& row : rows) {
        CAPTURE(row.origins, row.x_origin);
        const Scene scene = parse_scene(scene_with(row.origins, row.x_origin), "small.toml");
        const QuantitySpec& q = quantity_of(scene);
        CHECK(q.origin == row.x_origin);
        CHECK(q.event.has_value() == !row.series.empty());
        if (!q.event) CHECK(q.x_offset == Approx(row.level));
        if (q.event) CHECK(q.event->series == row.series);
        if (q.event) CHECK(q.event->level == row.level);
    }
}

TEST_CASE("origins that no run could find are refused", "[origin]") {
    struct Row {
        std::string origins, x_origin, key, message;
    };
    const std::vector<Row> rows = {
        {"contact = \"wet_contact\"", "contact", "time_origins.contact",
         "is 'wet_contact', expected one of first_contact, first_contact_2, geometric_contact, "},
        {"contact = \"first_contact_3\"", "contact", "time_origins.contact",
         "is 'first_contact_3', expected one of"},
        {"contact = true", "contact", "time_origins.contact",
         "expected a number [s], the name of a contact, or"},
        {"contact = [0.1]", "contact", "time_origins.contact",
         "expected a number [s], the name of a contact, or"},
        {"first_contact = 0.1", "first_contact", "time_origins.first_contact",
         "that each run finds, expected another"},
        {"a = { series = \"body_z\", crosses = 1 }", "a", "time_origins.a.series",
         "is 'body_z', expected one of"},
        {"a = { series = \"body_y\" }", "a", "time_origins.a.crosses", "missing, expected a number"},
        {"a = { crosses = 1 }", "a", "time_origins.a.series", "missing, expected a text"},
        {"a = { series = \"body_y\", crosses = \"1\" }", "a", "time_origins.a.crosses",
         "expected a finite number"},
        {"a = { series = \"body_y\", crosses = 1, direction = \"down\" }", "a", "time_origins.a.direction",
         "is 'down', expected one of rising, falling"},
        {"a = { series = \"body_y\", crosses = 1, when = 1 }", "a", "time_origins.a.when",
         "unknown, expected one of"},
        {"a = 1", "b", "quantities[1].x_origin", "is 'b', expected one of a, first_contact, "},
    };
    for (const Row& row : rows) {
        CAPTURE(row.origins);
        CHECK_THAT(refusal(scene_with(row.origins, row.x_origin)),
                   Contains("key '" + row.key + "': ") && Contains(row.message));
    }
    CHECK_THAT(
        refusal(small_scene + "[time_origins]\ncontact = \"first_contact\"\n"),
        Contains(
            "key 'time_origins.contact': is 'first_contact', a contact of a body, and the scene has no"));
}

TEST_CASE("an instant that the run finds is no place along a profile", "[origin]") {
    const std::string profile =
        "\n[[probes]]\nname = \"p\"\ntype = \"free_surface\"\nlow = 0.1\nhigh = 0.3\npoints = 3\n";
    std::string text =
        replaced(scene_with("", "first_contact"), "\n[time_origins]", profile + "\n[time_origins]");
    text = replaced(text, "series = \"body_y\"\nx_origin", "series = \"p\"\ninstant = 0.1\nx_origin");
    CHECK_THAT(refusal(text),
               Contains("key 'quantities[1].x_origin': is 'first_contact', an instant that the run"));
    text = replaced(text, "[time_origins]\n", "[time_origins]\na = { series = \"p\", crosses = 1 }\n");
    CHECK_THAT(refusal(text), Contains("key 'time_origins.a.series': 'p' is a profile"));
}

TEST_CASE("contacts by hand are checked in the variants that use them", "[origin]") {
    const std::string origins =
        "contact = 0.1\ncontact_late = 0.2\nother_contact = 0.3\ngate = 0.4\n"
        "contact_found = \"first_contact\"";
    const std::string text = scene_with(origins, "contact") + "variants = [\"two-phase\"]\n" +
                             "[[quantities]]\nname = \"r\"\nmetric = \"mean\"\nseries = \"body_y\"\n"
                             "x_origin = \"contact_late\"\nvariants = [\"single-phase\"]\n";
    using Names = std::vector<std::string>;
    CHECK(parse_scene(text, "small.toml").analysis.stated_contacts == Names{"contact", "other_contact"});
    CHECK(parse_scene(text, "small.toml", "single-phase").analysis.stated_contacts ==
          Names{"contact_late", "other_contact"});
}

TEST_CASE("every run records how far each body is from the level and from the water", "[origin]") {
    const Scene scene = parse_scene(scene_with("", ""), "small.toml", "single-phase");
    const Recorders recorders(scene, 0.02);
    std::vector<double> values;
    recorders.sample(assemble(scene, 0.02, 1), 0, values);
    std::map<std::string, double> value;
    for (std::size_t k = 0; k < values.size(); ++k) value[recorders.list()[k].name] = values[k];
    CHECK(value.at("body_clearance") == Approx(0.04));
    CHECK(value.at("body_clearance_2") == Approx(0.1));
    CHECK(value.at("body_water_gap_2") == Approx(std::hypot(0.11, 0.01) - 0.01).margin(1e-9));
    // from the upper right particle of the water, which ends at x = 0.4, to the corner of the first body
    CHECK(value.at("body_water_gap") == Approx(std::hypot(0.11, 0.05) - 0.01).margin(1e-9));
}

TEST_CASE("the clearance of a body counts from the water below it where levels differ", "[origin]") {
    const Scene scene = parse_scene(scene_with("", ""), "small.toml", "single-phase",
                                    {"water.boxes=[[0.0, 0.0, 0.4, 0.2], [0.4, 0.0, 1.0, 0.1]]",
                                     "air.boxes=[[0.4, 0.1, 1.0, 0.2], [0.0, 0.2, 1.0, 0.48]]"});
    const Recorders recorders(scene, 0.02);
    std::vector<double> values;
    recorders.sample(assemble(scene, 0.02, 1), 0, values);
    const std::vector<SeriesInfo>& list = recorders.list();
    const auto clearance = [&](const char* name) {
        const auto found =
            std::find_if(list.begin(), list.end(), [&](const SeriesInfo& s) { return s.name == name; });
        REQUIRE(found != list.end());
        return values.at(static_cast<std::size_t>(found - list.begin()));
    };
    CHECK(clearance("body_clearance") == Approx(0.14));
    CHECK(clearance("body_clearance_2") == Approx(0.1));
}

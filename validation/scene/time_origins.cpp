// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/time_origins.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "validation/metrics/time_origin.hpp"
#include "validation/scene/axes.hpp"

namespace wetdeck {
namespace {

std::map<std::string, TimeOrigin> contacts_of_bodies(const Scene& scene) {
    std::map<std::string, TimeOrigin> found;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        const auto named = [body](const char* name) { return body_series_name(name, body); };
        const std::string& name = scene.bodies[body].name;
        found[named("geometric_contact")].event = geometric_contact(name, named("body_clearance"));
        found[named("first_contact")].event = first_contact(name, named("body_water_gap"));
    }
    return found;
}

std::vector<std::string> names_of(const std::map<std::string, TimeOrigin>& origins) {
    std::vector<std::string> names;
    for (const auto& [name, origin] : origins) names.push_back(name);
    return names;
}

/// { series = "body_y", crosses = 1.05 }
OriginEvent read_crossing(const TomlTable& table, const Scene& scene,
                          const std::vector<std::string>& series) {
    using Crossing = OriginEvent::Crossing;
    OriginEvent event;
    event.series = table.choice("series", series);
    event.level = table.number("crosses");
    const std::string direction = table.choice("direction", {"rising", "falling"}, "");
    if (!direction.empty()) event.crossing = direction == "rising" ? Crossing::rising : Crossing::falling;
    event.meaning = fmt::format("crossing of {:.6g} by {}", event.level, event.series);
    for (const Probe& probe : scene.probes) {
        if (probe.series.name == event.series && !probe.series.abscissa.empty())
            table.fail("series",
                       fmt::format("'{}' is a profile, expected a series of one value", event.series));
    }
    table.finish();
    return event;
}

/// "10.2 ms", not the name of a contact.
bool is_quantity(const std::string& text) {
    return !text.empty() && text.find_first_of("0123456789+-.") == 0;
}

TimeOrigin read_one(const TomlTable& table, const std::string& name,
                    const std::map<std::string, TimeOrigin>& of_bodies) {
    if (table.is_number(name) || (table.holds_text(name) && is_quantity(table.text(name)))) {
        const MeasuredValue value = read_measured_value(table, name);
        return {value.number, std::nullopt, value.unit};
    }
    if (!table.holds_text(name))
        table.fail(name, "expected a number [s], the name of a contact, or a table { series, crosses }");
    if (of_bodies.empty())
        table.fail(
            name, fmt::format("is '{}', a contact of a body, and the scene has no [body]", table.text(name)));
    return of_bodies.at(table.choice(name, names_of(of_bodies)));
}

}  // namespace

std::map<std::string, TimeOrigin> read_time_origins(const TomlTable& root, const Scene& scene,
                                                    const std::vector<std::string>& series) {
    const std::map<std::string, TimeOrigin> of_bodies = contacts_of_bodies(scene);
    std::map<std::string, TimeOrigin> origins = of_bodies;
    const std::optional<TomlTable> table = root.optional_table("time_origins");
    if (!table) return origins;
    for (const std::string& name : table->keys()) {
        const bool itself = table->holds_text(name) && table->text(name) == name;
        if (of_bodies.contains(name) && !itself)
            table->fail(name, "is the name of a contact that each run finds, expected another name");
        origins[name] = table->is_table(name)
                            ? TimeOrigin{0, read_crossing(table->table(name), scene, series)}
                            : read_one(*table, name, of_bodies);
    }
    return origins;
}

std::vector<OriginEvent> geometric_contacts(const Scene& scene) {
    std::vector<OriginEvent> events;
    const std::map<std::string, TimeOrigin> of_bodies = contacts_of_bodies(scene);
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        events.push_back(*of_bodies.at(body_series_name("geometric_contact", body)).event);
    return events;
}

void read_x_origin(const TomlTable& table, const std::map<std::string, TimeOrigin>& origins,
                   SeriesScaling& scaling) {
    if (!table.has("x_origin")) return;
    scaling.origin = table.choice("x_origin", names_of(origins));
    const TimeOrigin& origin = origins.at(scaling.origin);
    scaling.x_offset = origin.typed;
    scaling.event = origin.event;
    if (origin.event && table.has("instant"))
        table.fail("x_origin",
                   fmt::format("is '{}', an instant that the run finds; beside 'instant' the abscissa is "
                               "a place: expected an origin that is a number",
                               scaling.origin));
}

std::vector<std::string> stated_contacts(const AnalysisSpec& analysis, const std::set<std::string>& used) {
    std::set<std::string> here;
    for (const QuantitySpec& quantity : analysis.quantities) here.insert(quantity.origin);
    for (const ComparisonSpec& comparison : analysis.comparisons) here.insert(comparison.origin);
    std::vector<std::string> names;
    for (const auto& [name, origin] : analysis.origins) {
        const bool instant = origin.unit.empty() || origin.unit == "s";
        const bool about_contact = instant && name.find("contact") != std::string::npos;
        if (about_contact && !origin.event && (here.contains(name) || !used.contains(name)))
            names.push_back(name);
    }
    return names;
}

}  // namespace wetdeck

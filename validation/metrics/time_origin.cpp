// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/time_origin.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace wetdeck {
namespace {

using nlohmann::json;

constexpr const char* record_key = "time_origins";

const char* verb(OriginEvent::Crossing crossing) {
    return crossing == OriginEvent::Crossing::falling  ? "falls through"
           : crossing == OriginEvent::Crossing::rising ? "rises through"
                                                       : "crosses";
}

/// Whether the event happens between two samples whose values less the level are `before` and `after`.
bool happens(OriginEvent::Crossing crossing, double before, double after) {
    const bool falls = before > 0 && after <= 0, rises = before < 0 && after >= 0;
    if (crossing == OriginEvent::Crossing::falling) return falls;
    return crossing == OriginEvent::Crossing::rising ? rises : falls || rises;
}

/// Whether it happens at the first sample, `value` above the level.
bool happens_at_start(const OriginEvent& event, double value) {
    constexpr double rounding = 1e-9;
    const bool beyond = event.crossing == OriginEvent::Crossing::falling && value < 0;
    return std::abs(value) <= rounding * std::max(1.0, std::abs(event.level)) ||
           (event.counts_at_start && beyond);
}

json to_json(const TimeOrigin& origin) {
    if (!origin.event) return origin.typed;
    const OriginEvent& e = *origin.event;
    return {{"series", e.series},
            {"level", e.level},
            {"spacings", e.spacings},
            {"crossing", static_cast<int>(e.crossing)},
            {"counts_at_start", e.counts_at_start},
            {"meaning", e.meaning}};
}

TimeOrigin from_json(const json& stored) {
    if (stored.is_number()) return {stored.get<double>(), std::nullopt};
    return {0, OriginEvent{stored.at("series"), stored.at("level"), stored.at("spacings"),
                           static_cast<OriginEvent::Crossing>(stored.at("crossing").get<int>()),
                           stored.at("counts_at_start"), stored.at("meaning")}};
}

/// The origin of that name as the run was started with it: an option --set may have changed the file's.
std::optional<TimeOrigin> recorded_origin(const RunRecord& record, const std::string& name) {
    const json all = json::parse(provenance_entry(record, record_key), nullptr, false);
    if (!all.is_object() || !all.contains(name)) return std::nullopt;
    return from_json(all.at(name));
}

/// The contact of one body that is nearest to a stated time, of those that the run found.
struct NearestContact {
    std::optional<FoundOrigin> found;
    const OriginEvent* event = nullptr;
    std::string problems;
};

NearestContact nearest_contact(const AnalysisSpec& spec, const RunRecord& record, double stated) {
    NearestContact nearest;
    for (const OriginEvent& event : spec.contacts) {
        FoundOrigin found = find_event(record, event);
        if (!found.problem.empty()) {
            nearest.problems += (nearest.problems.empty() ? "" : "; ") + found.problem;
        } else if (!nearest.found || std::abs(found.time - stated) < std::abs(nearest.found->time - stated)) {
            nearest.found = std::move(found);
            nearest.event = &event;
        }
    }
    return nearest;
}

bool has_series_of(const AnalysisSpec& spec, const RunRecord& record) {
    for (const OriginEvent& event : spec.contacts)
        if (record.series.contains(event.series)) return true;
    return false;
}

/// Whether the run ended before the stated instant: then it has nothing to say about it.
bool ended_before(const AnalysisSpec& spec, const RunRecord& record, double stated) {
    for (const OriginEvent& event : spec.contacts) {
        const auto series = record.series.find(event.series);
        if (series != record.series.end() && !series->second.time.empty() &&
            series->second.time.back() > stated)
            return false;
    }
    return true;
}

}  // namespace

OriginEvent geometric_contact(const std::string& body, const std::string& clearance_series) {
    return {clearance_series, 0, 0, OriginEvent::Crossing::falling, false, "geometric contact of " + body};
}

OriginEvent first_contact(const std::string& body, const std::string& gap_series) {
    return {gap_series, 0, contact_gap, OriginEvent::Crossing::falling, true, "first wet contact of " + body};
}

FoundOrigin find_event(const RunRecord& record, const OriginEvent& event) {
    const auto entry = record.series.find(event.series);
    if (entry == record.series.end())
        return {0, 0,
                fmt::format("{} needs the series '{}', which this run does not hold", event.meaning,
                            event.series)};
    const Series& series = entry->second;
    const double level = event.level + event.spacings * record.particle_spacing;
    if (series.columns() != 1 || series.time.size() != series.value.size() || series.time.empty())
        return {0, 0, fmt::format("{}: series '{}' is empty or a profile", event.meaning, event.series)};
    if (happens_at_start(event, series.value.front() - level)) return {series.time.front(), 0, ""};
    for (std::size_t i = 1; i < series.time.size(); ++i) {
        const double before = series.value[i - 1] - level, after = series.value[i] - level;
        if (!happens(event.crossing, before, after)) continue;
        const double interval = series.time[i] - series.time[i - 1];
        return {series.time[i - 1] + interval * before / (before - after), interval, ""};
    }
    return {0, 0,
            fmt::format(
                "the run found no {}: '{}' never {} {:.6g}, from {:.6g} at the start to {:.6g} at {:.6g} s",
                event.meaning, event.series, verb(event.crossing), level, series.value.front(),
                series.value.back(), series.time.back())};
}

FoundOrigin find_origin(const RunRecord& record, const SeriesScaling& scaling) {
    if (scaling.origin.empty()) return {scaling.x_offset, 0, ""};
    const TimeOrigin origin =
        recorded_origin(record, scaling.origin).value_or(TimeOrigin{scaling.x_offset, scaling.event});
    return origin.event ? find_event(record, *origin.event) : FoundOrigin{origin.typed, 0, ""};
}

std::string origins_text(const std::map<std::string, TimeOrigin>& origins) {
    json all = json::object();
    for (const auto& [name, origin] : origins) all[name] = to_json(origin);
    return all.dump();
}

std::vector<std::string> doubtful_origins(const AnalysisSpec& spec, const RunRecord& record) {
    std::vector<std::string> doubts;
    if (!has_series_of(spec, record)) return doubts;
    for (const std::string& name : spec.stated_contacts) {
        const auto declared = spec.origins.find(name);
        TimeOrigin origin = declared == spec.origins.end() ? TimeOrigin{} : declared->second;
        if (const auto recorded = recorded_origin(record, name)) origin = *recorded;
        if (origin.event) continue;
        const NearestContact nearest = nearest_contact(spec, record, origin.typed);
        if (!nearest.found) {
            if (!ended_before(spec, record, origin.typed))
                doubts.push_back(fmt::format("time_origins.{} is {:.6g} s by hand, but {}", name,
                                             origin.typed, nearest.problems));
            continue;
        }
        const double difference = std::abs(nearest.found->time - origin.typed);
        if (difference <= std::max(nearest.found->interval, spec.sample_interval)) continue;
        doubts.push_back(fmt::format(
            "time_origins.{} is {:.6g} s by hand, but the run found the {} at {:.6g} s: {:.3g} s apart, more "
            "than "
            "the sample interval of {:.3g} s; {} = \"geometric_contact\" takes what each run finds",
            name, origin.typed, nearest.event->meaning, nearest.found->time, difference, spec.sample_interval,
            name));
    }
    return doubts;
}

}  // namespace wetdeck

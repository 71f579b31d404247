// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/asked_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "validation/metrics/resample.hpp"
#include "validation/metrics/units.hpp"
#include "validation/scene/expected_motion.hpp"

namespace wetdeck {
namespace {

/// What one quantity or comparison asks of the time of a run.
struct Asked {
    std::string name;
    const SeriesScaling& scaling;
    const SeriesUnits& units;
    std::optional<Window> window;
    std::optional<double> abscissa;  ///< of a metric at one place of the scaled abscissa
    bool whole_window = false;
};

std::vector<Asked> all_asked(const AnalysisSpec& spec) {
    std::vector<Asked> all;
    for (const QuantitySpec& q : spec.quantities) {
        const bool at = std::string(q.metric->name) == "value_at";
        all.push_back({fmt::format("quantity '{}'", q.name), q, q.units, q.window,
                       at ? q.threshold : std::nullopt, q.metric->needs.whole_window});
    }
    for (const ComparisonSpec& c : spec.comparisons)
        all.push_back({fmt::format("comparison '{}'", c.title), c, c.units,
                       c.align_peaks ? std::nullopt : c.window, std::nullopt, false});
    return all;
}

/// The instant of a profile, or the end of the interval over which it is averaged.
std::optional<double> last_instant(const SeriesScaling& scaling) {
    if (!scaling.instant) return std::nullopt;
    return *scaling.instant + scaling.interval;
}

/// Where the abscissa is zero on the clock of the run: as stated, or the contact that the motion of the body
/// lets expect; none for another event.
std::optional<double> expected_origin(const Scene& scene, const SeriesScaling& scaling) {
    if (!scaling.event) return scaling.x_offset;
    for (const BodySpec& spec : scene.bodies) {
        const bool contact = scaling.event->meaning == "geometric contact of " + spec.name ||
                             scaling.event->meaning == "first wet contact of " + spec.name;
        const std::optional<WaterEntry> entry = contact ? water_entry(scene, spec) : std::nullopt;
        if (entry) return entry->time;
    }
    return std::nullopt;
}

std::optional<std::string> unreached(const Asked& asked, const Scene& scene) {
    const double end_time = scene.end_time, end = (1 + 1e-9) * end_time;
    const SeriesScaling& scaling = asked.scaling;
    if (const double last = last_instant(scaling).value_or(0); last > end)
        return fmt::format("{} is taken {} {:.6g} s, after the end of the run at {:.6g} s", asked.name,
                           scaling.interval > 0 ? "up to" : "at the instant", last, end_time);
    const std::optional<double> origin = expected_origin(scene, scaling);
    if (asked.units.x.series != "s" || !origin) return std::nullopt;
    const std::string about = scaling.event ? "about " : "";
    if (*origin > end)
        return fmt::format("{} counts from {}, at {}{:.6g} s, after the end of the run at {:.6g} s",
                           asked.name, scaling.origin, about, *origin, end_time);
    const auto on_clock = [&](double x) { return *origin + x * scaling.x_scale; };
    if (asked.abscissa && on_clock(*asked.abscissa) > end)
        return fmt::format("{} is taken at {}{:.6g} s, after the end of the run at {:.6g} s", asked.name,
                           about, on_clock(*asked.abscissa), end_time);
    if (!asked.window) return std::nullopt;
    const double from = on_clock(asked.window->begin), to = on_clock(asked.window->end);
    if (asked.whole_window && from < -(1 - required_coverage) * (to - from))
        return fmt::format("{} has the window {}{:.6g} to {:.6g} s, before the start of the run", asked.name,
                           about, from, to);
    const double reached = (end - from) / (to - from);
    if (reached > (asked.whole_window ? required_coverage : 0)) return std::nullopt;
    return fmt::format("{} has the window {}{:.6g} to {:.6g} s, {} the end of the run at {:.6g} s",
                       asked.name, about, from, to, reached > 0 ? "beyond" : "after", end_time);
}

/// Where a scale with a unit leaves a unit that has no name, such as 1/m^2 of pressures over forces.
std::optional<std::string> nameless_quotient(const std::string& name, const AxisUnits& axis) {
    if (axis.scale_unit.empty() || axis.series.empty()) return std::nullopt;
    const Unit left = unit_named(axis.series) / unit_named(axis.scale_unit);
    if (si_name(left.powers).find("^-") == std::string::npos) return std::nullopt;
    return fmt::format("{}: values in {} over scales.{} in {} are in {}: is this scale meant?", name,
                       axis.series, axis.scale, axis.scale_unit, si_name(left.powers));
}

}  // namespace

std::vector<std::string> unreached_times(const Scene& scene) {
    std::vector<std::string> found;
    for (const Asked& asked : all_asked(scene.analysis))
        if (auto text = unreached(asked, scene)) found.push_back(std::move(*text));
    return found;
}

std::vector<AskedTime> asked_times(const Scene& scene) {
    std::vector<AskedTime> all;
    for (const Asked& asked : all_asked(scene.analysis)) {
        const SeriesScaling& scaling = asked.scaling;
        std::optional<double> last = last_instant(scaling);
        const bool of_time = asked.units.x.series == "s" && !scaling.event;
        if (!last && of_time && asked.window) last = scaling.x_offset + asked.window->end * scaling.x_scale;
        if (!last && of_time) last = scene.end_time;
        if (last) all.push_back({asked.name, asked.units.y.series, std::min(*last, scene.end_time)});
    }
    return all;
}

std::vector<std::string> doubtful_scales(const Scene& scene) {
    std::map<std::string, std::string> unit_of;  // of the first use, by scale
    std::map<std::string, std::string> found;    // one sentence a scale
    const auto add = [&](const AxisUnits& axis) {
        if (axis.scale.empty() || !axis.scale_unit.empty() || axis.series.empty() || axis.series == "-")
            return;
        const auto [use, is_new] = unit_of.emplace(axis.scale, axis.series);
        if (is_new || same_dimension(unit_named(use->second), unit_named(axis.series))) return;
        found.emplace(axis.scale,
                      fmt::format("scales.{} is a plain number and divides values in {} and in {}: give it a "
                                  "unit, as in \"0.6 m\"",
                                  axis.scale, use->second, axis.series));
    };
    std::vector<std::string> sentences, nameless;
    for (const Asked& asked : all_asked(scene.analysis)) {
        for (const AxisUnits& axis : {asked.units.x, asked.units.y}) {
            add(axis);
            if (auto text = nameless_quotient(asked.name, axis)) nameless.push_back(std::move(*text));
        }
    }
    for (auto& [scale, text] : found) sentences.push_back(std::move(text));
    sentences.insert(sentences.end(), nameless.begin(), nameless.end());
    return sentences;
}

}  // namespace wetdeck

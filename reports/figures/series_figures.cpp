// SPDX-License-Identifier: BSD-3-Clause
// Series that the scene does not compare with a reference: loads and motion of bodies over time, and profiles
// over an abscissa (the pressure along a face).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

constexpr std::size_t profiles_shown = 6;

bool sound(const Series& series) {
    return series.time.size() > 1 && series.value.size() == series.time.size() * series.columns() &&
           std::all_of(series.value.begin(), series.value.end(), [](double v) { return std::isfinite(v); });
}

bool constant(const Series& series) {
    return std::all_of(series.value.begin(), series.value.end(),
                       [&](double v) { return v == series.value.front(); });
}

/// Rows at equal intervals from the first nonzero row to the last.
std::vector<std::size_t> shown_rows(const Series& series) {
    const std::size_t columns = series.columns(), rows = series.time.size();
    const auto nonzero =
        std::find_if(series.value.begin(), series.value.end(), [](double v) { return v != 0; });
    const auto first = static_cast<std::size_t>(nonzero - series.value.begin()) / columns;
    std::vector<std::size_t> out;
    if (first >= rows) return out;
    for (std::size_t k = 1; k <= profiles_shown; ++k) {
        const std::size_t row = first + k * (rows - 1 - first) / profiles_shown;
        if (out.empty() || out.back() != row) out.push_back(row);
    }
    return out;
}

std::string caption_of(const std::string& name, const Series& series) {
    return series.description.empty() ? "" : fmt::format("{}: {}.", series_words(name), series.description);
}

Figure profile_figure(const RunSummary& run, const std::string& name, const Series& series,
                      std::size_t variant) {
    Figure figure;
    figure.name = fmt::format("{}-{}-{}", run.record.scene, run.record.variant, name);
    figure.identifier = name;
    figure.title = fmt::format("{}: {}", run_name(run), series_words(name));
    figure.caption = caption_of(name, series);
    figure.x = {"position along the profile", "m", false, {}};
    figure.y = {series_words(name), series.unit, false, {}};
    const std::vector<std::size_t> rows = shown_rows(series);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto begin = series.value.begin() + static_cast<std::ptrdiff_t>(rows[k] * series.columns());
        const auto end = begin + static_cast<std::ptrdiff_t>(series.columns());
        figure.series.push_back(line("t = " + number(series.time[rows[k]], 4) + " s",
                                     {series.abscissa, {begin, end}}, run_colour(variant, k, rows.size())));
    }
    return figure;
}

/// One series of the variants at their finest spacings.
Figure history_figure(const Runs& finest, const std::string& name) {
    Figure figure;
    const RunRecord& first = finest.front()->record;
    figure.name = fmt::format("{}-{}", first.scene, name);
    figure.identifier = name;
    figure.title = fmt::format("{}: {}", first.scene, series_words(name));
    figure.x = {"time", "s", false, {}};
    for (std::size_t v = 0; v < finest.size(); ++v) {
        const auto found = finest[v]->record.series.find(name);
        if (found == finest[v]->record.series.end() || !sound(found->second) || constant(found->second))
            continue;
        figure.y = {series_words(name), found->second.unit, false, {}};
        figure.caption = caption_of(name, found->second);
        const RunRecord& record = finest[v]->record;
        figure.series.push_back(
            line(fmt::format("{}, dx = {}", record.variant, spacing_text(record.particle_spacing)),
                 {found->second.time, found->second.value}, variant_colour(v)));
    }
    return figure;
}

/// The series of a body that are shown: loads and motion, not work, impulses or driving accelerations.
bool of_interest(const std::string& name) {
    static const std::set<std::string> names{
        "body_x",       "body_y",       "body_angle",  "body_velocity_x",     "body_velocity_y",
        "body_force_x", "body_force_y", "body_torque", "body_acceleration_y", "body_angular_velocity"};
    const std::size_t suffix = name.find_last_not_of("0123456789");
    const bool numbered = suffix + 1 < name.size() && name[suffix] == '_';
    return names.count(numbered ? name.substr(0, suffix) : name) != 0;
}

/// One series of a variant at all its spacings, for series that no comparison shows.
Figure spacing_figure(const Runs& runs_of_variant, const std::string& name) {
    Figure figure;
    const RunRecord& finest = runs_of_variant.back()->record;
    figure.name = fmt::format("{}-{}-{}", finest.scene, finest.variant, name);
    figure.identifier = name;
    figure.title = fmt::format("{}, {}: {}, by spacing", finest.scene, finest.variant, series_words(name));
    figure.x = {"time", "s", false, {}};
    for (std::size_t k = 0; k < runs_of_variant.size(); ++k) {
        const RunRecord& record = runs_of_variant[k]->record;
        const auto found = record.series.find(name);
        if (found == record.series.end() || !sound(found->second) || constant(found->second)) continue;
        figure.y = {series_words(name), found->second.unit, false, {}};
        figure.caption = caption_of(name, found->second);
        figure.series.push_back(line("dx = " + spacing_text(record.particle_spacing),
                                     {found->second.time, found->second.value},
                                     run_colour(0, k, runs_of_variant.size())));
    }
    return figure;
}

bool compared(const Runs& runs, const std::string& series) {
    return std::any_of(runs.begin(), runs.end(), [&](const RunSummary* run) {
        return std::any_of(run->comparisons.begin(), run->comparisons.end(),
                           [&](const ComparisonResult& c) { return c.quantity == series && c.available; });
    });
}

}  // namespace

std::vector<Figure> history_figures(const AnalysisSpec& scene, const Runs& runs) {
    const Runs finest = finest_of_each(runs);
    const std::set<std::string> probes(scene.probes.begin(), scene.probes.end());
    std::set<std::string> names;
    for (const RunSummary* run : finest) {
        for (const auto& [name, series] : run->record.series) {
            const bool shown = of_interest(name) || probes.contains(name);
            if (shown && series.columns() == 1 && !compared(runs, name)) names.insert(name);
        }
    }
    std::vector<Figure> figures;
    for (const std::string& name : names) {
        Figure figure = history_figure(finest, name);
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    const Runs first = with_variant(runs, runs.front()->record.variant);
    std::set<std::string> over_spacings = probes;
    over_spacings.insert({"body_x", "body_y", "body_force_y", "body_acceleration_y"});
    for (const std::string& name : over_spacings) {
        if (names.count(name) == 0 || first.size() < 2) continue;
        Figure figure = spacing_figure(first, name);
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

std::vector<Figure> profile_figures(const Runs& runs) {
    const Runs finest = finest_of_each(runs);
    std::vector<Figure> figures;
    for (std::size_t v = 0; v < finest.size(); ++v) {
        for (const auto& [name, series] : finest[v]->record.series) {
            if (series.columns() < 2 || !sound(series)) continue;
            Figure figure = profile_figure(*finest[v], name, series, v);
            if (!figure.series.empty()) figures.push_back(std::move(figure));
        }
    }
    return figures;
}

}  // namespace wetdeck::report

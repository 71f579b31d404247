// SPDX-License-Identifier: BSD-3-Clause
#include "reports/figures/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "reports/figures/reference_names.hpp"
#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 18> known_series{{
    {"body_force_x", "horizontal force"},
    {"body_force_y", "vertical force"},
    {"body_torque", "moment"},
    {"body_x", "horizontal position"},
    {"body_y", "vertical position"},
    {"body_angle", "angle"},
    {"body_velocity_x", "horizontal velocity"},
    {"body_velocity_y", "vertical velocity"},
    {"body_angular_velocity", "angular velocity"},
    {"body_acceleration_y", "vertical acceleration"},
    {"body_work", "work of the body"},
    {"energy_kinetic", "kinetic energy"},
    {"energy_potential", "potential energy"},
    {"energy_compression", "energy of compression"},
    {"momentum_x", "horizontal momentum"},
    {"momentum_y", "vertical momentum"},
    {"density_error_max", "density error"},
    {"particles_outside", "particles outside the tank"},
}};

bool ends_with_number(const std::string& name, std::size_t& underscore) {
    underscore = name.rfind('_');
    return underscore != std::string::npos && underscore + 1 < name.size() &&
           name.find_first_not_of("0123456789", underscore + 1) == std::string::npos;
}

/// "15 ms", "0.75 s"; on a scaled axis the number alone.
std::string instant(double value, const SeriesScaling& scaling, const std::string& unit) {
    if (scaling.x_scale != 1) return number(value, 4) + " on the scaled axis";
    if (unit != "s") return number_with_unit(value, unit, 4);
    return value != 0 && std::abs(value) < 0.1 ? number_with_unit(1000 * value, "ms", 4)
                                               : number_with_unit(value, "s", 4);
}

std::string abscissa_unit(const QuantitySpec& spec) {
    return spec.units.x.series.empty() ? "s" : spec.units.x.series;
}

std::string after_origin(const QuantitySpec& spec) {
    return spec.origin.empty() ? "" : " after " + spaced(spec.origin);
}

/// What the metric takes, of the series in words.
std::string taken(const QuantitySpec& spec, const std::string& series) {
    const std::string metric = spec.metric == nullptr ? "" : spec.metric->name;
    const double threshold = spec.threshold.value_or(0);
    if (metric == "maximum") return "largest " + series;
    if (metric == "minimum") return "smallest " + series;
    if (metric == "time_of_maximum") return "time of the largest " + series;
    if (metric == "standard_deviation") return "scatter of the " + series;
    if (metric == "slope" || metric == "proportion") return "slope of the " + series;
    if (metric == "first_crossing")
        return fmt::format("time at which the {} reaches {}", series, number(threshold, 4));
    if (metric == "value_at")
        return fmt::format("{} at {}{}", series, instant(threshold, spec, abscissa_unit(spec)),
                           after_origin(spec));
    if (metric == "rms_difference") return "rms difference of the " + series;
    if (metric == "largest_difference") return "largest difference of the " + series;
    if (metric == "change") return "change of the " + series;
    const bool force = spec.series.find("force") != std::string::npos;
    if (metric == "integral") return (force ? "impulse of the " : "integral of the ") + series;
    if (metric == "first_peak_integral")
        return (force ? "impulse of the first peak of the " : "integral of the first peak of the ") + series;
    return metric + " " + series;  // mean
}

bool others_differ_by_window(const AnalysisSpec& scene, const QuantitySpec& spec) {
    return std::any_of(scene.quantities.begin(), scene.quantities.end(), [&](const QuantitySpec& other) {
        return other.name != spec.name && other.metric == spec.metric && other.series == spec.series &&
               other.threshold == spec.threshold && other.reference == spec.reference;
    });
}

std::string of_quantity(const AnalysisSpec& scene, const QuantitySpec& spec) {
    std::string out = taken(spec, series_words(scene, spec.series));
    if (!spec.reference.empty()) {
        for (const ComparisonSpec& c : scene.comparisons) {
            if (c.reference != spec.reference) continue;
            return out + " to " + reference_name(c.title, c.reference);
        }
        return out + " to " + spaced(spec.reference);
    }
    if (spec.window && others_differ_by_window(scene, spec)) {
        const SeriesScaling& scaling = spec;
        out += fmt::format(", from {} to {}", number(spec.window->begin, 4),
                           instant(spec.window->end, scaling, abscissa_unit(spec)));
    }
    return out;
}

const QuantitySpec* find_quantity(const AnalysisSpec& scene, const std::string& name) {
    const auto found = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                    [&](const QuantitySpec& spec) { return spec.name == name; });
    return found == scene.quantities.end() ? nullptr : &*found;
}

/// The comparison that a row's value is taken from, if it is one.
const ComparisonSpec* find_comparison(const AnalysisSpec& scene, const std::string& title,
                                      const std::string& name) {
    const auto found =
        std::find_if(scene.comparisons.begin(), scene.comparisons.end(), [&](const ComparisonSpec& spec) {
            return spec.title == title &&
                   (name.rfind(spec.quantity + ": ", 0) == 0 || name.rfind(title + ": ", 0) == 0);
        });
    return found == scene.comparisons.end() ? nullptr : &*found;
}

/// As inside a sentence; abbreviations stay.
std::string lower_first(std::string text) {
    if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

/// "gauge pressure" of "Gauge pressure, AUTHOR (YEAR)" and of "Gauge pressure against ...".
std::string lead_of(const std::string& title) {
    return lower_first(title.substr(0, std::min(title.find(", "), title.find(" against "))));
}

/// "kN/m" of "F [kN/m]", else the label.
std::string unit_in(const std::string& label) {
    const std::size_t open = label.rfind('['), close = label.rfind(']');
    if (open == std::string::npos || close == std::string::npos || close < open) return label;
    const std::string unit = label.substr(open + 1, close - open - 1);
    if (unit != "-" || open == 0) return unit;
    return label.substr(0, std::min(label.find(", "), label.find_last_not_of(' ', open - 1) + 1));
}

}  // namespace

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string series_words(const std::string& series) {
    static const std::string filtered = "_filtered";
    if (series.ends_with(filtered))
        return series_words(series.substr(0, series.size() - filtered.size())) + ", filtered";
    for (const auto& [name, words] : known_series)
        if (series == name) return words;
    std::size_t underscore = 0;
    if (series.rfind("body_", 0) == 0 && ends_with_number(series, underscore))
        return series_words(series.substr(0, underscore)) + " of body " + series.substr(underscore + 1);
    return spaced(series);
}

std::string series_words(const AnalysisSpec& scene, const std::string& series) {
    const std::string words = series_words(series);
    if (words != spaced(series)) return words;
    std::string begin;
    for (const ComparisonSpec& spec : scene.comparisons) {
        if (spec.quantity != series) continue;
        const std::string lead = lead_of(spec.title);
        if (!begin.empty() && lead != begin) return words;
        begin = lead;
    }
    return begin.empty() ? words : begin;
}

std::string quantity_words(const AnalysisSpec& scene, const std::string& name) {
    if (const QuantitySpec* spec = find_quantity(scene, name)) return of_quantity(scene, *spec);
    static const std::string curve = "curve of ";
    if (name.rfind(curve, 0) == 0) return curve + "the " + series_words(scene, name.substr(curve.size()));
    const std::size_t colon = name.rfind(": ");
    if (colon == std::string::npos) return spaced(name);
    const std::string of = name.substr(0, colon), feature = name.substr(colon + 2);
    if (const std::size_t against = feature.find(" against "); against != std::string::npos)
        return feature.substr(0, against) + " of the " + series_words(scene, of);
    const std::size_t comma = of.rfind(", ");  // a title that ends with the name of its reference
    const bool named = comma != std::string::npos && of.find('_', comma) != std::string::npos;
    return feature + " of the " + lower_first(named ? of.substr(0, comma) : of);
}

AnalysisSpec scene_named(const Summary& summary, const std::string& name) {
    for (const AnalysisSpec& scene : summary.scenes)
        if (scene.scene == name) return scene;
    AnalysisSpec scene;
    scene.scene = name;
    return scene;
}

std::string quantity_words(const Summary& summary, const std::string& scene, const std::string& name) {
    return quantity_words(scene_named(summary, scene), name);
}

std::string scene_words(const Summary& summary, const std::string& scene) {
    const std::string title = scene_named(summary, scene).title;
    return title.empty() ? scene : title;
}

std::string scene_label(std::string name) {
    return spaced(std::move(name));
}

std::string unit_words(const AnalysisSpec& scene, const ValidationRow& row) {
    if (row.unit != "-" && !row.unit.empty()) return row.unit;
    const ComparisonSpec* compared = find_comparison(scene, row.against, row.quantity);
    const QuantitySpec* spec = find_quantity(scene, row.quantity);
    const bool of_series =
        spec != nullptr && spec->metric != nullptr && spec->metric->dimension == Dimension::series;
    for (const ComparisonSpec& c : scene.comparisons) {
        if (compared == nullptr && of_series && c.quantity == spec->series && c.y_scale == spec->y_scale)
            compared = &c;
    }
    return compared == nullptr || compared->y_label.empty() ? "-" : unit_in(compared->y_label);
}

std::string verdict_words(const AnalysisSpec& scene, const ValidationRow& row) {
    const bool too = row.verdict.rfind("too ", 0) == 0;
    if (!too && row.verdict != "higher" && row.verdict != "lower") return row.verdict;
    const std::string unit = unit_words(scene, row);
    const bool larger = (row.error > 0) == (row.reference >= 0);
    if (unit == "s") return row.error > 0 ? (too ? "too late" : "later") : (too ? "too early" : "earlier");
    if (unit == "m/s") return larger ? (too ? "too fast" : "faster") : (too ? "too slow" : "slower");
    if (row.reference >= 0) return row.verdict;
    return larger ? (too ? "too large" : "larger in magnitude")
                  : (too ? "too small" : "smaller in magnitude");
}

}  // namespace wetdeck::report

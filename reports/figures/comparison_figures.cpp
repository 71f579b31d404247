// SPDX-License-Identifier: BSD-3-Clause
// Simulated curves over references, by spacing and by variant.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "reports/figures/figures.hpp"
#include "reports/figures/reference_names.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

/// Comparisons that share axes: the same series with the same scales. Where the scales are unknown the labels
/// of the axes decide.
struct AxesKey {
    std::string quantity;
    double x_scale, y_scale, x_offset, y_offset;
    bool aligned;
    std::string x_label, y_label;
    std::string taken = {};  ///< of a profile: the instant or the interval

    bool operator==(const AxesKey&) const = default;

    /// Of figures: the aligned ones stand beside those of the same series over time.
    std::string name() const { return quantity + (aligned ? "-aligned" : ""); }
    std::string title(const AnalysisSpec& scene) const {
        return series_words(scene, quantity) + (aligned ? ", aligned on the peaks" : "") + taken;
    }
};

std::string taken_at(const SeriesScaling& scaling) {
    if (!scaling.instant) return "";
    const double begin = *scaling.instant;
    if (scaling.interval == 0) return ", at " + number(begin, 4) + " s";
    return fmt::format(", mean over {} to {} s", number(begin, 4), number(begin + scaling.interval, 4));
}

constexpr double unknown_scale = 0;

AxesKey axes_of(const AnalysisSpec& scene, const ComparisonResult& c) {
    for (const ComparisonSpec& spec : scene.comparisons) {
        if (spec.title == c.title && spec.quantity == c.quantity && spec.reference == c.reference) {
            return {c.quantity,
                    spec.x_scale,
                    spec.y_scale,
                    spec.x_offset,
                    spec.y_offset,
                    spec.align_peaks,
                    spec.event ? spec.origin : "",
                    "",
                    taken_at(spec)};
        }
    }
    return {c.quantity, unknown_scale, unknown_scale, 0, 0, false, c.x_label, c.y_label};
}

/// The comparisons of one run that share a figure.
using Group = std::vector<const ComparisonResult*>;

Group group_of(const AnalysisSpec& scene, const RunSummary& run, const AxesKey& key) {
    Group group;
    for (const ComparisonResult& c : run.comparisons) {
        if (axes_of(scene, c) == key) group.push_back(&c);
    }
    return group;
}

std::vector<AxesKey> keys_of(const AnalysisSpec& scene, const Runs& runs) {
    std::vector<AxesKey> keys;
    for (const RunSummary* run : runs) {
        for (const ComparisonResult& c : run->comparisons) {
            const AxesKey key = axes_of(scene, c);
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
        }
    }
    return keys;
}

/// The longest simulated curve; none where a run ended before its second sample.
const Curve* longest(const Group& group) {
    const Curve* out = nullptr;
    for (const ComparisonResult* c : group) {
        if (out == nullptr || c->simulated.x.size() > out->x.size()) out = &c->simulated;
    }
    return out != nullptr && out->x.size() > 1 ? out : nullptr;
}

/// Measurements differ in their markers, other simulations in their greys: `place` counts within a kind.
PlotSeries reference_series(const ComparisonResult& c, std::size_t place) {
    static constexpr std::array<const char*, 3> greys{"#7d868e", "#b4bbc1", "#5d6470"};
    PlotSeries s;
    s.data = c.measured;
    s.colour = "#111111";
    s.marker = static_cast<Marker>(place % 4);
    s.point_size = 5;
    if (c.kind == ReferenceKind::experiment) {
        s.style = Style::points;
        s.label = reference_name(c.title, c.reference) + " (experiment)";
    } else if (c.kind == ReferenceKind::analytic) {
        s.style = Style::dashed;
        s.label = reference_name(c.title, c.reference) + " (analytic)";
    } else if (c.kind == ReferenceKind::peer_simulation) {
        s.colour = greys[place % greys.size()];
        s.width = 1.1;
        s.label = reference_name(c.title, c.reference) + " (peer simulation)";
    } else {
        s.style = Style::points;
        s.colour = "#8e44ad";
        s.filled = false;
        s.label =
            reference_name(c.title, c.reference) + " (" + (c.kind ? name_of(c.kind) : "unknown kind") + ")";
    }
    return s;
}

void add_spread(PlotSeries& s, const StandardUncertainty& uncertainty) {
    for (const double value : s.data.y) {
        s.low.push_back(value - uncertainty.of(value));
        s.high.push_back(value + uncertainty.of(value));
    }
}

/// Draws bands and other simulations behind the simulations, measurements in front of them.
std::vector<PlotSeries> with_references(const Group& group, std::vector<PlotSeries> simulations) {
    std::vector<PlotSeries> behind;
    std::vector<PlotSeries> in_front;
    std::map<std::optional<ReferenceKind>, std::size_t> places;
    for (const ComparisonResult* c : group) {
        PlotSeries s = reference_series(*c, places[c->kind]++);
        if (c->kind == ReferenceKind::experiment && c->reference_uncertainty) {
            const bool few = s.data.x.size() <= 60;
            PlotSeries spread = s;
            add_spread(spread, *c->reference_uncertainty);
            if (few) {
                s = spread;
            } else {
                spread.style = Style::band;
                spread.colour = "#6b7681";
                spread.label = reference_name(c->title, c->reference) + ", one standard uncertainty";
                behind.push_back(std::move(spread));
            }
        }
        (c->kind == ReferenceKind::peer_simulation ? behind : in_front).push_back(std::move(s));
    }
    std::move(simulations.begin(), simulations.end(), std::back_inserter(behind));
    std::move(in_front.begin(), in_front.end(), std::back_inserter(behind));
    return behind;
}

/// In SI units where the scale is one; otherwise the label has to define the numbers.
Axis scaled_axis(const std::string& label, double scale, const std::string& si_unit) {
    return {label.empty() ? "value" : label, scale == 1 ? si_unit : "scaled", false, {}};
}

std::string unit_of_series(const Runs& runs, const std::string& name) {
    for (const RunSummary* run : runs) {
        const auto found = run->record.series.find(name);
        if (found != run->record.series.end()) return found->second.unit;
    }
    return "SI";
}

std::string error_text(const Group& group) {
    std::string out;
    for (const ComparisonResult* c : group) {
        if (!c->available) continue;
        out += fmt::format("{}{} {}", out.empty() ? "" : "; ", reference_name(c->title, c->reference),
                           number_with_unit(c->nrmse, "-"));
    }
    return out;
}

/// The interval of all comparisons of the group, if they agree.
std::optional<Window> common_window(const Group& group) {
    const auto& first = group.front()->window;
    const bool same =
        first && std::all_of(group.begin(), group.end(), [&](const ComparisonResult* c) {
            return c->window && c->window->begin == first->begin && c->window->end == first->end;
        });
    return same ? first : std::nullopt;
}

/// Axes with the labels of the first comparison: the scales of all are the same.
Figure curve_figure(const AnalysisSpec& scene, const AxesKey& key, const Runs& runs) {
    Figure figure;
    for (const RunSummary* run : runs) {
        const Group group = group_of(scene, *run, key);
        if (group.empty()) continue;
        figure.x = scaled_axis(group.front()->x_label, key.x_scale, "s");
        figure.y = scaled_axis(group.front()->y_label, key.y_scale, unit_of_series(runs, key.quantity));
        break;
    }
    return figure;
}

Figure comparison_figure(const AnalysisSpec& scene, const AxesKey& key, const Runs& runs,
                         std::size_t variant) {
    Figure figure = curve_figure(scene, key, runs);
    const RunSummary& finest = *runs.back();
    figure.name = fmt::format("{}-{}-{}", scene.scene, finest.record.variant, key.name());
    figure.identifier = key.quantity;
    figure.title = fmt::format("{}, {}: {}", scene.scene, finest.record.variant, key.title(scene));
    Group group;
    std::vector<PlotSeries> simulations;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Group own = group_of(scene, *runs[k], key);
        if (!own.empty()) group = own;
        const Curve* curve = longest(own);
        if (curve == nullptr) continue;
        PlotSeries s = line("dx = " + spacing_text(runs[k]->record.particle_spacing), *curve,
                            run_colour(variant, k, runs.size()));
        if (runs[k]->record.status != RunStatus::ok)
            s.label += " (" + to_string(runs[k]->record.status) + ")";
        s.width = k + 1 == runs.size() ? 2.2 : 1.6;
        simulations.push_back(std::move(s));
    }
    if (simulations.empty()) return figure;
    figure.series = with_references(group, std::move(simulations));
    figure.shaded = common_window(group);
    if (const std::string errors = error_text(group); !errors.empty())
        figure.caption = fmt::format("NRMSE at the finest spacing: {}.", errors);
    return figure;
}

}  // namespace

std::vector<Figure> comparison_figures(const AnalysisSpec& scene, const Runs& runs_of_variant,
                                       std::size_t variant) {
    std::vector<Figure> figures;
    for (const AxesKey& key : keys_of(scene, runs_of_variant)) {
        Figure figure = comparison_figure(scene, key, runs_of_variant, variant);
        if (!figure.series.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

std::vector<Figure> variant_figures(const AnalysisSpec& scene, const Runs& runs) {
    const Runs finest = finest_of_each(runs);
    std::vector<Figure> figures;
    if (finest.size() < 2) return figures;
    for (const AxesKey& key : keys_of(scene, finest)) {
        Figure figure = curve_figure(scene, key, finest);
        figure.name = fmt::format("{}-variants-{}", scene.scene, key.name());
        figure.identifier = key.quantity;
        figure.title = fmt::format("{}, variants at their finest spacing: {}", scene.scene, key.title(scene));
        Group references;  // the same for all variants
        for (std::size_t v = 0; v < finest.size(); ++v) {
            const Group group = group_of(scene, *finest[v], key);
            const Curve* curve = longest(group);
            if (curve == nullptr) continue;
            if (references.empty()) references = group;
            const RunRecord& record = finest[v]->record;
            figure.series.push_back(
                line(fmt::format("{}, dx = {}", record.variant, spacing_text(record.particle_spacing)),
                     *curve, variant_colour(v)));
            if (const std::string errors = error_text(group); !errors.empty())
                figure.caption += fmt::format("{}{}: {}.", figure.caption.empty() ? "NRMSE of " : " ",
                                              record.variant, errors);
        }
        if (references.empty()) continue;
        figure.series = with_references(references, std::move(figure.series));
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace wetdeck::report

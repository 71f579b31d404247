// SPDX-License-Identifier: BSD-3-Clause
// One series of several variants.
#include <fmt/format.h>

#include <algorithm>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck::report {

Figure side_by_side_figure(const AnalysisSpec& scene, const SideBySide& entry, const Runs& runs) {
    Figure figure;
    if (entry.series.empty()) return figure;
    const auto compared = std::find_if(scene.comparisons.begin(), scene.comparisons.end(),
                                       [&](const ComparisonSpec& c) { return c.quantity == entry.series; });
    const bool scaled = compared != scene.comparisons.end();
    SeriesScaling scaling;
    if (scaled) scaling = *compared;
    // an origin of time is that of one variant: all are drawn on the clock of the run
    const bool own_clock = !scaled || !scaling.origin.empty();
    if (own_clock) {
        scaling.x_offset = 0;
        scaling.x_scale = 1;
        scaling.event.reset();
    }
    figure.name = scene.scene + "-" + slug(entry.title) + "-curves";
    figure.title = entry.title;
    figure.identifier = entry.series;
    figure.x = {own_clock ? "time" : compared->x_label, own_clock ? "s" : "", false, {}};
    const Runs chosen = side_by_side_runs(runs, entry);
    for (std::size_t v = 0; v < chosen.size(); ++v) {
        const RunRecord& record = chosen[v]->record;
        const SeriesCurve series = series_curve(record, entry.series, scaling);
        if (series.curve.x.size() < 2) continue;
        const auto found = record.series.find(entry.series);
        figure.y = {scaled ? compared->y_label : series_words(scene, entry.series),
                    scaled ? "" : found->second.unit,
                    false,
                    {}};
        figure.caption = fmt::format("{}: {}.", series_words(scene, entry.series), found->second.description);
        figure.series.push_back(
            line(fmt::format("{}, dx = {}", record.variant, spacing_text(record.particle_spacing)),
                 series.curve, variant_colour(v)));
    }
    return figure;
}

}  // namespace wetdeck::report

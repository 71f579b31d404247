// SPDX-License-Identifier: BSD-3-Clause
// Energies of the runs of a variant.
#include <fmt/format.h>

#include "reports/figures/figures.hpp"
#include "reports/page/html.hpp"
#include "validation/metrics/energy_budget.hpp"

namespace wetdeck::report {
namespace {

Figure budget_figure(const RunSummary& run, const EnergyChanges& energies) {
    Figure figure;
    figure.name = fmt::format("{}-{}-energy", run.record.scene, run.record.variant);
    figure.title = "Energy change since the start: " + run_name(run);
    const bool bodies = run.record.series.count("body_work") != 0;
    figure.caption = fmt::format("Largest increase of the total{}: {}.", bodies ? " minus that work" : "",
                                 number_with_unit(run.energy_error, "-"));
    figure.x = {"time", "s", false, {}};
    figure.y = {"(E − E(0)) / Epot(0)", "-", false, {}};
    const auto add = [&](const char* label, Curve curve, const char* colour, double width) {
        PlotSeries s = line(label, std::move(curve), colour);
        s.width = width;
        figure.series.push_back(std::move(s));
    };
    add("kinetic", energies.kinetic, "#c2571a", 1.6);
    add("potential", energies.potential, "#08519c", 1.6);
    add("compression", energies.compression, "#2f8f4e", 1.6);
    add("total", energies.total, "#111111", 2.2);
    return figure;
}

Figure change_figure(const Runs& runs, std::size_t variant) {
    const RunRecord& record = runs.back()->record;
    Figure figure;
    figure.name = fmt::format("{}-{}-energy-change", record.scene, record.variant);
    figure.title = fmt::format("{}, {}: change of the total energy", record.scene, record.variant);
    if (record.series.count("body_work") != 0) figure.caption = "With the work of the bodies on the fluid.";
    figure.x = {"time", "s", false, {}};
    figure.y = {"dE / Epot(0)", "-", false, {}};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const auto energies = energy_changes(runs[k]->record);
        if (!energies || energies->total.x.size() < 2) continue;
        figure.series.push_back(line("dx = " + spacing_text(runs[k]->record.particle_spacing),
                                     energies->total, run_colour(variant, k, runs.size())));
    }
    return figure;
}

}  // namespace

std::vector<Figure> energy_figures(const Runs& runs_of_variant, std::size_t variant) {
    std::vector<Figure> figures;
    const RunSummary& finest = *runs_of_variant.back();
    const auto energies = energy_changes(finest.record);
    if (energies && energies->total.x.size() > 1) figures.push_back(budget_figure(finest, *energies));
    Figure change = change_figure(runs_of_variant, variant);
    if (!change.series.empty()) figures.push_back(std::move(change));
    return figures;
}

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// Energy, momentum and other balances of the runs of a scene.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

const Series* scalar_series(const RunSummary& run, const std::string& name) {
    const auto found = run.record.series.find(name);
    if (found == run.record.series.end()) return nullptr;
    const Series& series = found->second;
    const bool usable =
        series.columns() == 1 && !series.time.empty() && series.time.size() == series.value.size();
    return usable ? &series : nullptr;
}

std::optional<double> largest(const RunSummary& run, const std::string& name) {
    const Series* series = scalar_series(run, name);
    if (series == nullptr) return std::nullopt;
    return *std::max_element(series->value.begin(), series->value.end());
}

/// The three energies of a run on their common instants, and their sum.
struct Energies {
    const Series* kinetic;
    const Series* potential;
    const Series* compression;

    explicit Energies(const RunSummary& run)
        : kinetic(scalar_series(run, "energy_kinetic")),
          potential(scalar_series(run, "energy_potential")),
          compression(scalar_series(run, "energy_compression")) {}

    bool complete() const {
        return kinetic && potential && compression && kinetic->time == potential->time &&
               kinetic->time == compression->time;
    }
    Curve total() const {
        Curve sum{kinetic->time, kinetic->value};
        for (std::size_t i = 0; i < sum.y.size(); ++i)
            sum.y[i] += potential->value[i] + compression->value[i];
        return sum;
    }
};

Curve since_start(Curve curve) {
    const double first = curve.y.front();
    for (double& value : curve.y) value -= first;
    return curve;
}

Curve since_start(const Series& series) {
    return since_start(Curve{series.time, series.value});
}

Figure budget_figure(const RunSummary& run, const Energies& energies) {
    Figure figure;
    figure.name = fmt::format("{}-{}-energy", run.record.scene, run.record.variant);
    figure.title = "Energy, change since the start: " + run_name(run);
    figure.caption = fmt::format("Revision {}. Largest energy error: {}.", revision_of(run),
                                 number_with_unit(run.energy_error, "-"));
    figure.x = {"time", "s", false, {}};
    figure.y = {"energy minus initial energy", energies.kinetic->unit, false, {}};
    const auto add = [&](const char* label, Curve curve, const char* colour, double width) {
        PlotSeries s;
        s.label = label;
        s.data = std::move(curve);
        s.colour = colour;
        s.width = width;
        figure.series.push_back(std::move(s));
    };
    add("kinetic", since_start(*energies.kinetic), "#c2571a", 1.6);
    add("potential", since_start(*energies.potential), "#08519c", 1.6);
    add("compression", since_start(*energies.compression), "#2f8f4e", 1.6);
    add("total", since_start(energies.total()), "#111111", 2.2);
    return figure;
}

/// Change of the total over its initial value, empty if that is zero.
Curve relative_change(const Energies& energies) {
    const Curve total = energies.total();
    const double initial = std::abs(total.y.front());
    if (initial == 0) return {};
    Curve change = since_start(total);
    for (double& value : change.y) value /= initial;
    return change;
}

Figure change_figure(const Runs& runs, std::size_t variant) {
    const RunRecord& record = runs.back()->record;
    Figure figure;
    figure.name = fmt::format("{}-{}-energy-change", record.scene, record.variant);
    figure.title = fmt::format("{}, {}: total energy, relative change", record.scene, record.variant);
    figure.caption = fmt::format("Revision {}. Change of the total energy over its initial value.",
                                 revision_of(*runs.back()));
    figure.x = {"time", "s", false, {}};
    figure.y = {"(E − E₀) / |E₀|", "-", false, {}};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Energies energies(*runs[k]);
        if (!energies.complete()) continue;
        PlotSeries s;
        s.data = relative_change(energies);
        s.label = "dx = " + spacing_text(runs[k]->record.particle_spacing);
        s.colour = run_colour(variant, k, runs.size());
        if (!s.data.x.empty()) figure.series.push_back(std::move(s));
    }
    return figure;
}

}  // namespace

std::vector<Figure> energy_figures(const Runs& runs_of_variant, std::size_t variant) {
    std::vector<Figure> figures;
    const RunSummary& finest = *runs_of_variant.back();
    const Energies energies(finest);
    if (energies.complete()) figures.push_back(budget_figure(finest, energies));
    Figure change = change_figure(runs_of_variant, variant);
    if (!change.series.empty()) figures.push_back(std::move(change));
    return figures;
}

std::string conservation_table(const Runs& runs) {
    Table table(
        {"variant", "dx", "energy error", "momentum error", "largest density error", "particles outside"});
    for (const RunSummary* run : runs) {
        table.add({markup(escape(run->record.variant), "name"), value(run->record.particle_spacing, "m", 4),
                   value(run->energy_error), value(run->momentum_error),
                   value(largest(*run, "density_error_max")), value(largest(*run, "particles_outside"))});
    }
    return table.html() +
           paragraph(
               "Energy error: largest rise of the total energy above its lowest value so far, over the range "
               "of the potential energy or its initial value; losses are not counted. Momentum error: "
               "largest absolute value of the momentum balance of the run. Density error: largest relative "
               "deviation from the reference density.",
               "soft");
}

}  // namespace wetdeck::report

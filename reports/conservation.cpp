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

/// Largest deviation from the first value, over it; empty without the series or if it starts at zero.
std::optional<double> drift(const RunSummary& run, const std::string& name) {
    const Series* series = scalar_series(run, name);
    if (series == nullptr || series->value.front() == 0) return std::nullopt;
    double out = 0;
    for (const double value : series->value) out = std::max(out, std::abs(value / series->value.front() - 1));
    return out;
}

/// The three energies of a run on their common instants, as changes since the start over the initial
/// potential energy.
class Energies {
  public:
    explicit Energies(const RunSummary& run)
        : kinetic_(scalar_series(run, "energy_kinetic")),
          potential_(scalar_series(run, "energy_potential")),
          compression_(scalar_series(run, "energy_compression")) {}

    bool complete() const {
        return kinetic_ && potential_ && compression_ && potential_->value.front() != 0 &&
               kinetic_->time == potential_->time && kinetic_->time == compression_->time;
    }
    Curve kinetic() const { return change(*kinetic_); }
    Curve potential() const { return change(*potential_); }
    Curve compression() const { return change(*compression_); }
    Curve total() const {
        Curve sum = kinetic();
        const Curve height = potential(), volume = compression();
        for (std::size_t i = 0; i < sum.y.size(); ++i) sum.y[i] += height.y[i] + volume.y[i];
        return sum;
    }

  private:
    Curve change(const Series& series) const {
        Curve curve{series.time, series.value};
        const double scale = std::abs(potential_->value.front());
        for (double& value : curve.y) value = (value - series.value.front()) / scale;
        return curve;
    }

    const Series* kinetic_;
    const Series* potential_;
    const Series* compression_;
};

Figure budget_figure(const RunSummary& run, const Energies& energies) {
    Figure figure;
    figure.name = fmt::format("{}-{}-energy", run.record.scene, run.record.variant);
    figure.title = "Energy, change since the start: " + run_name(run);
    const bool bodies = run.record.series.count("body_work") != 0;
    figure.caption = fmt::format(
        "Revision {}. Each energy minus its initial value, over the initial potential energy.{} Largest "
        "growth of the total{}: {}.",
        revision_of(run),
        bodies ? " These are the fluid's: the total rises by the work of a body that falls in." : "",
        bodies ? " less that work" : "", number_with_unit(run.energy_error, "-"));
    figure.x = {"time", "s", false, {}};
    figure.y = {"(E − E(0)) / Epot(0)", "-", false, {}};
    const auto add = [&](const char* label, Curve curve, const char* colour, double width) {
        PlotSeries s;
        s.label = label;
        s.data = std::move(curve);
        s.colour = colour;
        s.width = width;
        figure.series.push_back(std::move(s));
    };
    add("kinetic", energies.kinetic(), "#c2571a", 1.6);
    add("potential", energies.potential(), "#08519c", 1.6);
    add("compression", energies.compression(), "#2f8f4e", 1.6);
    add("total", energies.total(), "#111111", 2.2);
    return figure;
}

Figure change_figure(const Runs& runs, std::size_t variant) {
    const RunRecord& record = runs.back()->record;
    Figure figure;
    figure.name = fmt::format("{}-{}-energy-change", record.scene, record.variant);
    figure.title = fmt::format("{}, {}: change of the total energy", record.scene, record.variant);
    const bool bodies = record.series.count("body_work") != 0;
    figure.caption = fmt::format(
        "Revision {}. dE = total energy of the fluid minus its initial value, over the initial potential "
        "energy. {}",
        revision_of(*runs.back()),
        bodies
            ? "The work of the bodies on the fluid is in it."
            : "Water loses energy where it hits a wall or closes upon itself: for a dam break two bends are "
              "expected, at the impact on the wall and at the closure of the pocket, as Cao et al. (2018) "
              "show.");
    figure.x = {"time", "s", false, {}};
    figure.y = {"dE / Epot(0)", "-", false, {}};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const Energies energies(*runs[k]);
        if (!energies.complete()) continue;
        PlotSeries s;
        s.data = energies.total();
        s.label = "dx = " + spacing_text(runs[k]->record.particle_spacing);
        s.colour = run_colour(variant, k, runs.size());
        if (s.data.x.size() > 1) figure.series.push_back(std::move(s));
    }
    return figure;
}

std::optional<double> final_change(const RunSummary& run) {
    const Energies energies(run);
    return energies.complete() ? std::optional(energies.total().y.back()) : std::nullopt;
}

Cell count_cell(std::optional<double> number_or_nothing) {
    return number_or_nothing ? whole(*number_or_nothing) : text("—");
}

}  // namespace

std::vector<Figure> energy_figures(const Runs& runs_of_variant, std::size_t variant) {
    std::vector<Figure> figures;
    const RunSummary& finest = *runs_of_variant.back();
    const Energies energies(finest);
    if (energies.complete() && energies.total().x.size() > 1)
        figures.push_back(budget_figure(finest, energies));
    Figure change = change_figure(runs_of_variant, variant);
    if (!change.series.empty()) figures.push_back(std::move(change));
    return figures;
}

std::string conservation_table(const Runs& runs) {
    const bool momentum = std::any_of(runs.begin(), runs.end(),
                                      [](const RunSummary* run) { return bool(run->momentum_error); });
    std::vector<std::string> headers{"variant",
                                     "dx",
                                     "largest energy growth",
                                     "energy change, end",
                                     "mass drift",
                                     "particles outside, most",
                                     "largest density error"};
    if (momentum) headers.push_back("momentum error");
    Table table(headers, "compact");
    for (const RunSummary* run : runs) {
        std::vector<Cell> row{markup(escape(run->record.variant), "name"),
                              value(run->record.particle_spacing, "m", 4),
                              value(run->energy_error),
                              value(final_change(*run)),
                              value(drift(*run, "mass")),
                              count_cell(largest(*run, "particles_outside")),
                              value(largest(*run, "density_error_max"))};
        if (momentum) row.push_back(value(run->momentum_error));
        table.add(row);
    }
    std::string words =
        "Energy growth: largest rise of the total energy above its lowest value so far, over the range of "
        "the "
        "potential energy or its initial value, whichever is larger; losses are not counted. Energy change: "
        "of "
        "the total at the end, over the initial potential energy. Mass drift: largest deviation from the "
        "mass "
        "at the start. Density error: largest relative deviation from the reference density.";
    if (momentum) words += " Momentum error: largest absolute value of the momentum balance of the run.";
    return table.html() + paragraph(words, "soft");
}

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// Energy, momentum and other balances of the runs of a scene.
#include <algorithm>

#include "reports/parts/tables.hpp"
#include "validation/metrics/energy_budget.hpp"

namespace wetdeck::report {
namespace {

std::optional<double> final_change(const RunSummary& run) {
    const std::optional<EnergyChanges> changes = energy_changes(run.record);
    return changes ? std::optional(changes->total.y.back()) : std::nullopt;
}

Cell count_cell(std::optional<double> number_or_nothing) {
    return number_or_nothing ? whole(*number_or_nothing) : text("—");
}

}  // namespace

std::string conservation_table(const Runs& runs) {
    const bool momentum = std::any_of(runs.begin(), runs.end(),
                                      [](const RunSummary* run) { return bool(run->momentum_error); });
    std::vector<std::string> headers{"variant",
                                     "dx",
                                     "largest energy growth",
                                     "energy change at the end",
                                     "mass drift",
                                     "most particles outside the tank",
                                     "largest density error"};
    if (momentum) headers.push_back("momentum error");
    Table table(headers, "compact");
    for (const RunSummary* run : runs) {
        std::vector<Cell> row{markup(escape(run->record.variant), "name"),
                              value(run->record.particle_spacing, "m", 4),
                              value(run->energy_error),
                              value(final_change(*run)),
                              value(relative_drift(run->record, "mass")),
                              count_cell(largest_value(run->record, "particles_outside")),
                              value(largest_value(run->record, "density_error_max"))};
        if (momentum) row.push_back(value(run->momentum_error));
        table.add(row);
    }
    std::string explanation =
        "Energy growth: largest rise of the total energy above its lowest earlier value, divided by the "
        "larger "
        "of the range and the initial value of the potential energy; losses are not counted. Energy change: "
        "change of the total energy from start to end, divided by the initial potential energy; in the "
        "figures dE, "
        "and each energy likewise. The energies are those of the fluid: the total increases by the work of a "
        "falling body, and water loses energy where it hits a wall and where a cavity closes. Mass drift: "
        "largest deviation from the initial mass. Density error: largest relative deviation from the "
        "reference density.";
    if (momentum) explanation += " Momentum error: largest absolute value of the momentum balance.";
    return table.html() + paragraph(explanation, "soft");
}

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// Voids, mixing of the phases and penetration of bodies in the runs of a scene.
#include <array>

#include "reports/parts/tables.hpp"
#include "validation/metrics/energy_budget.hpp"

namespace wetdeck::report {
namespace {

constexpr std::array counts_of{"water_in_air", "air_in_water", "particles_in_bodies"};

Cell largest_area(const RunSummary& run, const char* series) {
    return value(largest_value(run.record, series), "m^2");
}

}  // namespace

std::string phase_defects_table(const Runs& runs) {
    Table table({"variant", "dx", "largest void area", "most water particles in air",
                 "most air particles in water", "largest enclosed air", "most particles in bodies"},
                "compact");
    for (const RunSummary* run : runs) {
        const auto& series = run->record.series;
        if (!series.contains("void_area") && !series.contains("particles_in_bodies")) continue;
        std::vector<Cell> row{markup(escape(run->record.variant), "name"),
                              value(run->record.particle_spacing, "m", 4), largest_area(*run, "void_area")};
        for (const char* name : counts_of) {
            const std::optional<double> most = largest_value(run->record, name);
            row.push_back(most ? whole(*most) : text("—"));
        }
        row.insert(row.begin() + 5, largest_area(*run, "enclosed_air"));
        table.add(row);
    }
    if (table.empty()) return "";
    return table.html() +
           paragraph(
               "At the instants of the field files. Void: the part of the tank outside bodies that is "
               "farther "
               "than one spacing from every particle. Water in air: water particles with less than a quarter "
               "of water among their neighbours within two spacings, and air in water likewise. Enclosed "
               "air: "
               "volume a metre of span of all air that is cut off from the largest body of air. In bodies: "
               "fluid particles whose centres lie inside an outline.",
               "soft");
}

}  // namespace wetdeck::report

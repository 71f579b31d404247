// SPDX-License-Identifier: BSD-3-Clause
// Cost of the runs of a scene, by stage, and the criteria that limited the time step.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/parts/tables.hpp"
#include "validation/metrics/cost.hpp"

namespace wetdeck::report {
namespace {

constexpr std::array<const char*, 10> stage_colours{"#08519c", "#e6842a", "#2f8f4e", "#7b4fa6", "#c23b3b",
                                                    "#4aa3a2", "#b8a12f", "#d06ba8", "#6b7681", "#9ecae1"};

/// A colour for each stage, the same for all runs.
std::map<std::string, std::string> colours_of_stages(const Runs& runs) {
    std::map<std::string, std::string> colours;
    for (const RunSummary* run : runs) {
        for (const auto& stage : run->record.cost.stage_seconds) colours[stage.first];
    }
    std::size_t k = 0;
    for (auto& entry : colours) entry.second = stage_colours[k++ % stage_colours.size()];
    return colours;
}

std::string stage_bar(const RunCost& cost, const std::map<std::string, std::string>& colours) {
    const std::map<std::string, double> shares = stage_shares(cost);
    if (shares.empty()) return "—";
    std::string out = "<div class=\"bar\">";
    for (const auto& [name, share] : shares) {
        out +=
            fmt::format("<i style=\"width:{:.2f}%;background:{}\" title=\"{} {}\"></i>", 100 * share,
                        colours.at(name), escape(name), number_with_unit(cost.stage_seconds.at(name), "s"));
    }
    return out + "</div>";
}

std::string limiting_text(const RunCost& cost) {
    std::string out;
    for (const auto& [name, share] : limiting_shares(cost))
        out += fmt::format("{}{} {} %", out.empty() ? "" : ", ", name, number(100 * share));
    return out.empty() ? "—" : out;
}

std::optional<double> parameter(const RunRecord& record, const std::string& key) {
    const auto found = record.parameters.find(key);
    return found == record.parameters.end() ? std::nullopt : std::optional(found->second);
}

/// The first columns of every row.
std::vector<Cell> run_cells(const RunRecord& record) {
    return {markup(escape(record.variant), "name"), value(record.particle_spacing, "m", 4)};
}

/// Of the air in one step of the water, or of fine water in one of coarse.
std::optional<double> substeps(const RunRecord& record) {
    return std::max(parameter(record, "model.air_substeps"), parameter(record, "model.coarse_substeps"));
}

/// With the particle-steps of the source's computation over those of each run, if they are known.
std::string pace_table(const Runs& runs, const std::optional<SourceRun>& source_run) {
    std::vector<std::string> headers{"variant",
                                     "dx",
                                     "steps",
                                     "substeps per step",
                                     "particle-steps",
                                     "particle-steps/s",
                                     "bytes per particle",
                                     "time step limited by"};
    if (source_run) headers.push_back("particle-steps, source / this run");
    Table table(headers);
    const double source_steps = source_run ? particle_steps(*source_run) : 0;
    for (const RunSummary* run : runs) {
        const RunRecord& record = run->record;
        std::vector<Cell> row = run_cells(record);
        row.push_back(whole(static_cast<double>(record.cost.steps)));
        row.push_back(value(substeps(record)));
        row.push_back(value(record.cost.particle_steps));
        row.push_back(value(particle_rate(record.cost)));
        row.push_back(value(parameter(record, "bytes_per_particle")));
        row.push_back(text(limiting_text(record.cost)));
        if (source_run) row.push_back(value(source_steps / record.cost.particle_steps));
        table.add(row);
    }
    if (!source_run) return table.html();
    return table.html() +
           paragraph(fmt::format(
               "The computation in the source takes {} particles × {} steps = {} particle-steps: {}.",
               number(source_run->particles), number(source_run->steps), number(source_steps),
               source_run->conditions));
}

std::string stage_table(const Runs& runs) {
    const std::map<std::string, std::string> colours = colours_of_stages(runs);
    std::vector<std::string> headers{"variant", "dx", "wall time [s]", "share of each stage"};
    for (const auto& stage : colours) headers.push_back(stage.first + " [s]");
    Table table(headers, "compact");
    for (const RunSummary* run : runs) {
        const RunCost& cost = run->record.cost;
        std::vector<Cell> row = run_cells(run->record);
        row.push_back(value(cost.wall_s));
        row.push_back(markup(stage_bar(cost, colours), "wide"));
        for (const auto& stage : colours) {
            const auto seconds = cost.stage_seconds.find(stage.first);
            row.push_back(seconds == cost.stage_seconds.end() ? text("—") : value(seconds->second));
        }
        table.add(row);
    }
    std::string key;
    for (const auto& [name, colour] : colours) {
        key += fmt::format("<span><i style=\"background:{}\"></i>{}</span>", colour, escape(name));
    }
    return table.html() + "<div class=\"key\">" + key + "</div>\n";
}

}  // namespace

std::string cost_table(const Runs& runs, const AnalysisSpec& scene) {
    return pace_table(runs, scene.source_run) + stage_table(runs) +
           paragraph(
               "Particle-steps: number of particles whose rates of change were computed, summed over all "
               "steps. If the air takes several substeps in one step of the water, or fine water in one of "
               "coarse, it counts in each substep, the rest only near it. The seconds of the stages are wall "
               "time of the time loop; the remaining wall time is set-up.",
               "soft");
}

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// What the runs of a scene cost, and what set their pace.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

constexpr std::array<const char*, 10> stage_colours{"#08519c", "#e6842a", "#2f8f4e", "#7b4fa6", "#c23b3b",
                                                    "#4aa3a2", "#b8a12f", "#d06ba8", "#6b7681", "#9ecae1"};

/// All names of stages, each with a colour that is the same for all runs.
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
    double total = 0;
    for (const auto& stage : cost.stage_seconds) total += stage.second;
    if (total <= 0) return "—";
    std::string out = "<div class=\"bar\">";
    for (const auto& [name, seconds] : cost.stage_seconds) {
        out += fmt::format("<i style=\"width:{:.2f}%;background:{}\" title=\"{} {}\"></i>",
                           100 * seconds / total, colours.at(name), escape(name),
                           number_with_unit(seconds, "s"));
    }
    return out + "</div>";
}

/// Steps by what set their size, the most frequent first.
std::string limiting_text(const RunCost& cost) {
    std::vector<std::pair<std::string, std::uint64_t>> criteria(cost.limiting_criterion.begin(),
                                                                cost.limiting_criterion.end());
    std::stable_sort(criteria.begin(), criteria.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    double total = 0;
    for (const auto& entry : criteria) total += static_cast<double>(entry.second);
    std::string out;
    for (const auto& [name, steps] : criteria) {
        if (steps == 0) continue;
        out += fmt::format("{}{} {} %", out.empty() ? "" : ", ", name,
                           number(100 * static_cast<double>(steps) / total));
    }
    return out.empty() ? "—" : out;
}

std::optional<double> parameter(const RunRecord& record, const std::string& key) {
    const auto found = record.parameters.find(key);
    return found == record.parameters.end() ? std::nullopt : std::optional(found->second);
}

/// Columns that open every row of this section.
std::vector<Cell> run_cells(const RunRecord& record) {
    return {markup(escape(record.variant), "name"), value(record.particle_spacing, "m", 4)};
}

/// @param source_run  if known, how many times more particle-steps it took is shown for each run
std::string pace_table(const Runs& runs, const std::optional<SourceRun>& source_run) {
    std::vector<std::string> headers{"variant",
                                     "dx",
                                     "steps",
                                     "of the air in each",
                                     "particle-steps",
                                     "particle-steps/s",
                                     "bytes per particle",
                                     "step limited by"};
    if (source_run) headers.push_back("source / this run");
    Table table(headers);
    const double source_steps = source_run ? source_run->particles * source_run->steps : 0;
    for (const RunSummary* run : runs) {
        const RunRecord& record = run->record;
        std::vector<Cell> row = run_cells(record);
        row.push_back(whole(static_cast<double>(record.cost.steps)));
        row.push_back(value(parameter(record, "model.air_substeps")));
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
               "The source's own computation takes {} particles times {} steps = {} particle-steps: {}.",
               number(source_run->particles), number(source_run->steps), number(source_steps),
               source_run->conditions));
}

std::string stage_table(const Runs& runs) {
    const std::map<std::string, std::string> colours = colours_of_stages(runs);
    std::vector<std::string> headers{"variant", "dx", "wall [s]", "share of each stage"};
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

std::optional<double> particle_rate(const RunCost& cost) {
    return cost.wall_s > 0 ? std::optional(cost.particle_steps / cost.wall_s) : std::nullopt;
}

std::string cost_table(const Runs& runs, const AnalysisSpec& scene) {
    return pace_table(runs, scene.source_run) + stage_table(runs) +
           paragraph(
               "Particle-steps: particles whose rates were summed, over all steps; where the air takes "
               "several "
               "in one of the water, the air counts in each of them, and of the water only what is near air. "
               "Seconds per stage are wall time of the time loop; what is not in them is set-up.",
               "soft");
}

}  // namespace wetdeck::report

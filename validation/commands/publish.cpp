// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/publish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/html.hpp"
#include "reports/selection.hpp"
#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

std::string number(std::optional<double> value) {
    return value ? fmt::format("{:.4g}", *value) : std::string();
}

/// A field of a CSV file.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

/// In a table of Markdown a bar would begin a cell.
std::string cell(std::string text) {
    std::replace(text.begin(), text.end(), '|', '/');
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string choice(const RunRecord& record, const char* key) {
    const auto found = record.choices.find(key);
    return found == record.choices.end() ? "unknown" : found->second;
}

std::string runs_csv(const Summary& summary) {
    std::string out =
        "scene,variant,dx [m],status,fluid particles,steps,wall [s],core [s],revision,start,threads,cpu\n";
    for (const RunSummary& run : summary.runs) {
        const RunRecord& r = run.record;
        out += fmt::format("{},{},{},{},{},{},{:.4g},{:.4g},{},{},{},{}\n", field(r.scene), field(r.variant),
                           r.particle_spacing, to_string(r.status), r.fluid_particles, r.cost.steps,
                           r.cost.wall_s, r.cost.core_s, choice(r, "commit"), choice(r, "start_time"),
                           choice(r, "threads"), field(choice(r, "cpu")));
    }
    return out;
}

std::string values_csv(const Summary& summary) {
    std::string out = "scene,variant,dx [m],quantity,unit,value,expected,tolerance,source\n";
    for (const RunSummary& run : summary.runs) {
        for (const QuantityResult& q : run.quantities) {
            out += fmt::format("{},{},{},{},{},{},{},{},{}\n", field(run.record.scene),
                               field(run.record.variant), run.record.particle_spacing, field(q.name),
                               field(q.unit), number(q.value), number(q.expected), number(q.tolerance),
                               field(q.expected_source));
        }
    }
    return out;
}

std::string statistics_csv(const Summary& summary) {
    std::string out = "class,points,bias,bias low,bias high,scatter,sigma of the data,sigma of the model\n";
    for (const ClassStatistics& s : summary.statistics) {
        out += fmt::format("{},{},{},{},{},{},{},{}\n", field(s.quantity_class), s.count, number(s.bias),
                           number(s.bias_low), number(s.bias_high), number(s.scatter), number(s.sigma_data),
                           number(s.sigma_model));
    }
    return out;
}

std::string scatter_csv(const Summary& summary) {
    std::string out = "class,scene,variant,dx [m],quantity,unit,measured,predicted,against,counted,reason\n";
    for (const ScatterPoint& p : summary.scatter) {
        out +=
            fmt::format("{},{},{},{},{},{},{:.6g},{:.6g},{},{},{}\n", field(p.quantity_class), field(p.scene),
                        field(p.variant), p.dx, field(p.quantity), field(p.unit), p.expected, p.predicted,
                        field(p.against), p.counted ? "yes" : "no", field(p.dropped));
    }
    return out;
}

std::string readme(const Summary& summary, const std::set<std::string>& figures) {
    std::string out = fmt::format(
        "# Results, tier {}\n\nWritten by `wetdeck report DIR --publish` from stored "
        "runs; {}.\n",
        cell(summary.tier), cell(report::stamp_of(summary)));
    if (!summary.missing.empty())
        out += fmt::format("\n**Incomplete**: {} runs of the tier are missing.\n", summary.missing.size());
    out +=
        "\n## Runs\n| scene | variant | dx [m] | status | core-seconds | revision "
        "|\n|---|---|---|---|---|---|\n";
    for (const RunSummary& run : summary.runs) {
        const RunRecord& r = run.record;
        out +=
            fmt::format("| {} | {} | {} | {} | {} | {} |\n", cell(r.scene), cell(r.variant),
                        r.particle_spacing, to_string(r.status), number(r.cost.core_s), choice(r, "commit"));
    }
    out +=
        "\n## Bias and scatter\nUnknown cells are empty.\n\n| class | points | bias | 95 % interval | "
        "scatter "
        "|\n|---|---|---|---|---|\n";
    for (const ClassStatistics& s : summary.statistics) {
        const std::string interval = s.bias_low ? number(s.bias_low) + " to " + number(s.bias_high) : "";
        out += fmt::format("| {} | {} | {} | {} | {} |\n", cell(s.quantity_class), s.count, number(s.bias),
                           interval, number(s.scatter));
    }
    out +=
        "\n## Errors with their uncertainties, finest spacings\n| scene | variant | quantity | S | D | E | "
        "u_num "
        "| u_input | u_data | in words |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const ValidationRow& row : summary.validation) {
        out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", cell(row.scene),
                           cell(row.variant), cell(row.quantity), number(row.simulated),
                           number(row.reference), number(row.error), number(row.u_num), number(row.u_input),
                           number(row.u_data), cell(row.verdict));
    }
    out += "\n## Figures\n";
    for (const std::string& figure : figures) out += fmt::format("- [{0}]({0})\n", figure);
    return out;
}

bool chosen(const std::string& stem) {
    return stem.rfind("suite-", 0) == 0 || stem.ends_with("-speed-error");
}

}  // namespace

void publish(const Summary& summary, const fs::path& directory, const fs::path& target) {
    const fs::path folder = target / report::slug(summary.tier);
    if (!fs::is_directory(directory / "figures"))
        throw InputError(fmt::format("{}: holds no figures of a report", directory.string()));
    make_directories(folder);
    std::set<std::string> figures;
    for (const auto& entry : fs::directory_iterator(directory / "figures")) {
        if (!chosen(entry.path().stem().string())) continue;
        const std::string name = entry.path().filename().string();
        atomic_write(folder / name, read_whole_file(entry.path()));
        figures.insert(name);
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (chosen(entry.path().stem().string()) && figures.count(name) == 0) fs::remove(entry.path());
    }
    atomic_write(folder / "runs.csv", runs_csv(summary));
    atomic_write(folder / "values.csv", values_csv(summary));
    atomic_write(folder / "statistics.csv", statistics_csv(summary));
    atomic_write(folder / "scatter.csv", scatter_csv(summary));
    atomic_write(folder / "README.md", readme(summary, figures));
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/publish.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "reports/figures/selection.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"
#include "reports/page/strings.hpp"
#include "reports/parts/outcomes.hpp"
#include "solver/core/errors.hpp"
#include "validation/commands/sketch.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using report::csv_field;
using report::provenance_of;

std::string number(std::optional<double> value) {
    return value ? fmt::format("{:.4g}", *value) : std::string();
}

/// In a table of Markdown a bar would begin a cell.
std::string cell(std::string text) {
    std::replace(text.begin(), text.end(), '|', '/');
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string runs_csv(const Summary& summary) {
    std::string out =
        "scene,variant,dx [m],status,fluid particles,steps,wall [s],core [s],revision,start,threads,cpu\n";
    for (const RunSummary& run : summary.runs) {
        const RunRecord& r = run.record;
        out += fmt::format("{},{},{},{},{},{},{:.4g},{:.4g},{},{},{},{}\n", csv_field(r.scene),
                           csv_field(r.variant), r.particle_spacing, to_string(r.status), r.fluid_particles,
                           r.cost.steps, r.cost.wall_s, r.cost.core_s, provenance_of(r, "commit"),
                           provenance_of(r, "start_time"), provenance_of(r, "threads"),
                           csv_field(provenance_of(r, "cpu")));
    }
    return out;
}

std::string values_csv(const Summary& summary) {
    std::string out = "scene,variant,dx [m],quantity,unit,value,expected,tolerance,source\n";
    for (const RunSummary& run : summary.runs) {
        for (const QuantityResult& q : run.quantities) {
            out += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(run.record.scene),
                               csv_field(run.record.variant), run.record.particle_spacing, csv_field(q.name),
                               csv_field(q.unit), number(q.value), number(q.expected), number(q.tolerance),
                               csv_field(q.expected_source));
        }
    }
    return out;
}

std::string statistics_csv(const Summary& summary) {
    std::string out =
        "class,against,points,bias,bias low,bias high,scatter,sigma of the data,sigma of the model\n";
    for (const ClassStatistics& s : summary.statistics) {
        out += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(s.quantity_class), name_of(s.against),
                           s.count, number(s.bias), number(s.bias_low), number(s.bias_high),
                           number(s.scatter), number(s.sigma_data), number(s.sigma_model));
    }
    return out;
}

std::string scatter_csv(const Summary& summary) {
    std::string out = "class,scene,variant,dx [m],quantity,unit,measured,predicted,against,counted,reason\n";
    for (const ScatterPoint& p : summary.scatter) {
        out += fmt::format("{},{},{},{},{},{},{:.6g},{:.6g},{},{},{}\n", csv_field(p.quantity_class),
                           csv_field(p.scene), csv_field(p.variant), p.dx, csv_field(p.quantity),
                           csv_field(p.unit), p.expected, p.predicted, csv_field(p.against),
                           p.counted ? "yes" : "no", csv_field(p.dropped));
    }
    return out;
}

/// One line a scene, as on the first page of the report.
std::string outcomes_section(const Summary& summary) {
    std::string out =
        "\n## What was reached\nThe main quantity of each scene, default variant, finest spacing.\n\n"
        "| scene | quantity | expected | kind | reached | unit | verdict | dx [m] | core-seconds |\n"
        "|---|---|---|---|---|---|---|---|---|\n";
    for (const report::Outcome& o : report::outcomes_of(summary)) {
        const bool ran = o.run != nullptr;
        out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", cell(o.title), cell(o.words),
                           number(o.expected), o.kind, number(o.reached), cell(o.unit), o.verdict,
                           ran ? fmt::format("{}", o.run->record.particle_spacing) : "",
                           ran ? number(o.run->record.cost.core_s) : "");
    }
    return out;
}

std::string runs_section(const Summary& summary) {
    std::string out =
        "\n## Runs\n| scene | variant | dx [m] | status | core-seconds | revision |\n"
        "|---|---|---|---|---|---|\n";
    for (const RunSummary& run : summary.runs) {
        const RunRecord& r = run.record;
        out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", cell(r.scene), cell(r.variant),
                           r.particle_spacing, to_string(r.status), number(r.cost.core_s),
                           provenance_of(r, "commit"));
    }
    return out;
}

std::string statistics_section(const Summary& summary) {
    std::string out =
        "\n## Bias and scatter\nEmpty cells are unknown.\n\n"
        "| class | against | points | bias | 95 % interval | scatter |\n|---|---|---|---|---|---|\n";
    for (const ClassStatistics& s : summary.statistics) {
        const std::string interval = s.bias_low ? number(s.bias_low) + " to " + number(s.bias_high) : "";
        out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", cell(s.quantity_class),
                           describe(s.against).heading, s.count, number(s.bias), interval, number(s.scatter));
    }
    return out;
}

std::string errors_section(const Summary& summary) {
    std::string out =
        "\n## Errors with their uncertainties, finest spacings\n"
        "| scene | variant | quantity | S | D | E | u_num | u_input | u_data | verdict |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n";
    for (const ValidationRow& row : summary.validation) {
        const std::string verdict = report::verdict_words(report::scene_named(summary, row.scene), row);
        out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", cell(row.scene),
                           cell(row.variant), cell(row.quantity), number(row.simulated),
                           number(row.reference), number(row.error), number(row.u_num), number(row.u_input),
                           number(row.u_data), cell(fmt::format("{}. {}", verdict, row.sentence)));
    }
    return out;
}

std::string readme(const Summary& summary, const std::set<std::string>& figures) {
    std::string out =
        fmt::format("# Results, tier {}\n\nWritten by `wetdeck report DIR --publish` from stored runs; {}.\n",
                    cell(summary.tier), cell(report::stamp_of(summary)));
    if (!summary.missing.empty())
        out += fmt::format("\n**Incomplete**: {} runs of the tier are missing.\n", summary.missing.size());
    out +=
        "\n`wetdeck report DIR` writes the report itself beside the runs: `index.html`, one page a scene and "
        "`statistics.html`; with `--single-file` one file for mail. It is not kept here.\n\n"
        "[library.md](library.md) shows every case with its picture, what it tests, and how it ended.\n";
    out += outcomes_section(summary) + runs_section(summary) + statistics_section(summary) +
           errors_section(summary) + "\n## Figures\n";
    for (const std::string& figure : figures) out += fmt::format("- [{0}]({0})\n", figure);
    return out;
}

bool chosen(const std::string& stem) {
    return stem.starts_with("suite-") || stem.starts_with("set-up-") || stem.ends_with("-speed-error");
}

/// Each case with its picture, what it tests, against what, verdict and cost; writes the pictures, whose
/// names it adds to `files`.
std::string library(const Summary& summary, const fs::path& folder, std::set<std::string>& files) {
    const std::vector<report::LibraryCase> cases = report::library_of(summary);
    std::string rows;
    for (const report::LibraryCase& each : cases) {
        const RunRecord& r = each.runs.front()->record;
        const std::string picture = fmt::format("set-up-{}.svg", report::slug(each.scene.scene));
        atomic_write(folder / picture, sketch(parse_scene(r.scene_text, r.scene_path)).svg());
        files.insert(picture);
        rows += fmt::format(
            "| <img src=\"{}\" width=\"160\"> | {} (`{}`) | {} | {} | {} of {} | {}: {} | {} |\n", picture,
            cell(each.scene.title), each.scene.scene, cell(each.scene.purpose),
            fmt::format("{}", fmt::join(each.judged.kinds, ", ")), each.judged.within, each.judged.points,
            cell(each.outcome.words), each.outcome.verdict, number(each.core_seconds));
    }
    return fmt::format(
        "# Library of cases, tier {}\n\nWritten by `wetdeck report DIR --publish` from stored runs; {}. {} "
        "The "
        "scene files are in [validation/scenes](../../../validation/scenes).\n\n"
        "| set-up | case | what it tests | against | within tolerance | main quantity and verdict | "
        "core-seconds of all runs |\n|---|---|---|---|---|---|---|\n{}{}",
        cell(summary.tier), cell(report::stamp_of(summary)), report::counted(cases), rows,
        statistics_section(summary));
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
    atomic_write(folder / "library.md", library(summary, folder, figures));
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

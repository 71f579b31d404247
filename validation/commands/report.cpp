// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/commands/publish.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/commands/stored_sweep.hpp"
#include "validation/run/exit_code.hpp"

namespace wetdeck {
namespace {

struct ReportOptions {
    std::string directory;
    std::string publish;  ///< folder; empty: nowhere
    bool single_file = false;
};

int report_command(const ReportOptions& options) {
    if (holds_sweep(options.directory)) {
        if (!options.publish.empty())
            throw InputError("option --publish: a sweep has no tier to publish, see sweep.csv");
        return print_sweep(make_sweep_report(options.directory, options.single_file), options.directory);
    }
    const Summary summary = make_report(options.directory, options.single_file);
    const int verdict = print_verdict(summary, options.directory);
    if (!options.publish.empty()) publish(summary, options.directory, options.publish);
    return verdict;
}

/// Whether a doubt is about a run of the report, not one of a study.
bool about_shown_run(const RunDoubt& doubt, const Summary& summary) {
    return std::any_of(summary.runs.begin(), summary.runs.end(), [&doubt](const RunSummary& run) {
        const RunRecord& r = run.record;
        return r.scene == doubt.scene && r.variant == doubt.variant && r.particle_spacing == doubt.dx &&
               provenance_entry(r, "overrides") == doubt.overrides;
    });
}

/// One line each; runs of studies, which mostly repeat those of the run that they vary, are counted.
void print_doubts(const Summary& summary) {
    std::size_t of_studies = 0;
    for (const RunDoubt& doubt : summary.doubts) {
        if (about_shown_run(doubt, summary))
            fmt::print(stderr, "doubt: {} {} dx {}: {}\n", doubt.scene, doubt.variant, doubt.dx,
                       doubt.sentence);
        else
            ++of_studies;
    }
    if (of_studies > 0)
        fmt::print(stderr, "doubt: {} more about runs of studies, see summary.json\n", of_studies);
}

}  // namespace

int print_verdict(const Summary& summary, const std::filesystem::path& directory) {
    for (const std::string& curve : unusable_curves(summary)) fmt::print(stderr, "note: {}\n", curve);
    fmt::print("report: {}\n", (directory / "index.html").string());
    std::fflush(stdout);
    print_doubts(summary);
    for (const LeftOutRun& run : summary.left_out)
        fmt::print(stderr, "left out: {}: {}\n", run.directory, fmt::join(run.differences, "; "));
    const std::vector<std::string> outside = outside_tolerance(summary);
    if (outside.empty()) return exit_done;
    constexpr std::size_t most = 3;
    fmt::print("outside tolerance ({}; the report shows all):\n", outside.size());
    for (std::size_t k = 0; k < std::min(most, outside.size()); ++k) fmt::print("  {}\n", outside[k]);
    if (outside.size() > most) fmt::print("  and {} more\n", outside.size() - most);
    return exit_outside;
}

void add_report(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ReportOptions>();
    CLI::App& command = *app.add_subcommand("report", "write the report again from the stored runs");
    add_directory(command, options->directory, "directory of a suite or a run");
    command
        .add_option("--publish", options->publish,
                    "also write small tables and figures to DIR/TIER, to be kept in a repository")
        ->type_name("DIR");
    command.add_flag("--single-file", options->single_file,
                     "write all pages as one self-contained index.html, for mail");
    command.callback([options, &exit_code] { exit_code = report_command(*options); });
}

}  // namespace wetdeck

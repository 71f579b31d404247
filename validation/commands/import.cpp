// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck import`: a reference curve from the files of another code.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/import/formats.hpp"
#include "validation/import/imported_curve.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

struct ImportOptions {
    std::string format, out;
    std::vector<std::string> paths;
    ImportChoices choices;
    bool replace = false;
};

int import_curve(const ImportOptions& options) {
    if (!options.out.ends_with(".csv"))
        throw InputError(fmt::format("--out is {}, expected the name of a curve, NAME.csv", options.out));
    if (std::filesystem::exists(options.out) && !options.replace)
        throw InputError(fmt::format("{}: exists already, expected --replace or another file", options.out));
    for (const ImportFormat& format : import_formats()) {
        if (options.format != format.name) continue;
        const CodeRecord record = format.read(options.paths);
        const std::string today = fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr)));
        const std::string text = imported_curve(record, options.choices, today);
        const Reference curve = parse_reference(options.out, text);
        atomic_write(options.out, text);
        fmt::print("{}: {} rows from {:.6g} to {:.6g} s", options.out, curve.columns.front().values.size(),
                   curve.columns.front().values.front(), curve.columns.front().values.back());
        for (std::size_t k = 1; k < curve.columns.size(); ++k)
            fmt::print(", {} [{}]", curve.columns[k].name, curve.columns[k].given_unit);
        fmt::print("\n");
        for (const std::string& note : record.notes) fmt::print("{}\n", note);
        return exit_done;
    }
    throw InputError("no such format");  // CLI11 has checked it
}

}  // namespace

void add_import(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<ImportOptions>();
    ImportChoices& choices = options->choices;
    CLI::App& command = *app.add_subcommand(
        "import",
        "make a reference curve of what OpenFOAM, DualSPHysics, SPHinXsys or TrixiParticles has written");
    std::vector<std::string> names;
    for (const ImportFormat& format : import_formats()) names.emplace_back(format.name);
    command.add_option("format", options->format, "whose files they are")
        ->required()
        ->type_name("")
        ->check(CLI::IsMember(names));
    command.add_option("paths", options->paths, "files, or the folders that a code writes them to")
        ->required()
        ->type_name("");
    command.add_option("--out", options->out, "the curve, in the form of reference_data/README.md")
        ->required()
        ->type_name("CURVE.csv");
    command
        .add_option("--column", choices.columns,
                    "which column, where the files hold several; may be repeated")
        ->type_name("NAME");
    command
        .add_option("--layer", choices.layer, "thickness of the computed layer, by which loads are divided")
        ->type_name("M");
    command
        .add_option("--factor", choices.factor,
                    "of all values: 2 where half of a symmetric body was computed")
        ->type_name("NUMBER");
    command.add_option("--datum", choices.datum, "of pressures: gauge or absolute")->type_name("DATUM");
    command.add_option("--reference-pressure", choices.reference_pressure, "taken off absolute pressures")
        ->type_name("PA");
    command.add_option("--pressure", choices.pressure, "p, or p_rgh where rho g h is left out")
        ->type_name("KIND");
    command.add_option("--phase", choices.phase, "what was computed: water or two-phase")->type_name("PHASE");
    command.add_option("--sign", choices.sign, "which direction is positive")->type_name("TEXT");
    command.add_option("--unit", choices.unit, "of the columns, where the files do not say")
        ->type_name("UNIT");
    command.add_option("--time-unit", choices.time_unit, "of the time, where the files do not say")
        ->type_name("UNIT");
    command.add_option("--time-origin", choices.time_origin, "what happens at time 0")->type_name("TEXT");
    command.add_option("--code", choices.code, "name of the code, for plain columns")->type_name("NAME");
    command.add_option("--code-version", choices.code_version, "its version, where the files do not say")
        ->type_name("TEXT");
    command.add_option("--setup", choices.setup, "what was computed, in a sentence")->type_name("TEXT");
    command.add_option("--scene", choices.scene, "scene of wetdeck that it stands for")->type_name("SCENE");
    command.add_flag("--replace", options->replace, "replace the file if it exists");
    command.callback([options, &exit_code] { exit_code = import_curve(*options); });
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck new`: from the corners of a section to a scene file of its water entry.
#include <unistd.h>

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>

#include "solver/core/errors.hpp"
#include "validation/commands/commands.hpp"
#include "validation/generate/scene_text.hpp"
#include "validation/metrics/units.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/run/progress.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/plausibility.hpp"
#include "validation/sections/section_address.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
    std::string section, out;
    std::map<std::string, std::string> wanted;  ///< of a file of sections, by key of its address
    std::optional<double> speed, mass, depth, record;
    bool constant_speed = false, air = false, no_air = false, half = false, whole = false, force = false;
};

/// A number that the user has to give.
struct Question {
    const char *flag, *words, *unit;
    bool may_be_absent = false;  ///< an empty answer is one, too
};

std::string answer_to(const std::string& question) {
    fmt::print(stderr, "{}: ", question);
    std::string line;
    if (!std::getline(std::cin, line)) throw InputError("the answer is missing: the input has ended");
    return std::string(trimmed(line));
}

bool asks() {
    return isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
}

void complete(std::optional<double>& value, const Question& question) {
    while (!value && asks()) {
        const std::string answer = answer_to(fmt::format("{} [{}]", question.words, question.unit));
        if (answer.empty() && question.may_be_absent) return;
        value = number_in(answer);
        if (value && *value > 0 && std::isfinite(*value)) return;
        value.reset();
        fmt::print(stderr, "expected a positive number\n");
    }
    if (!value && !question.may_be_absent)
        throw InputError(
            fmt::format("{} is missing: expected the {} [{}]", question.flag, question.words, question.unit));
    if (value && (!(*value > 0) || !std::isfinite(*value)))
        throw InputError(fmt::format("{} is {}, expected a positive number: the {} [{}]", question.flag,
                                     *value, question.words, question.unit));
}

EntryWishes wishes_of(NewOptions options) {
    if (options.constant_speed && options.mass)
        throw InputError("--mass is given beside --constant-speed: expected one of the two");
    if (options.no_air && options.air) throw InputError("--air and --no-air: expected one of the two");
    complete(options.speed, {"--speed", "speed downwards at which the keel meets the water", "m/s"});
    if (!options.constant_speed)
        complete(options.mass, {"--mass", "mass per metre of span (or --constant-speed)", "kg/m"});
    complete(options.depth, {"--depth", "depth of the water (nothing: deep)", "m", true});
    complete(options.record,
             {"--record", "time from contact to the end (nothing: by the section)", "s", true});
    if (!options.air && !options.no_air && asks()) {
        const std::string answer = answer_to("with air? (y, or nothing for water alone)");
        options.air = answer == "y" || answer == "yes";
    }
    return {*options.speed, options.mass.value_or(0), options.depth, options.air, options.record};
}

void check_out(const NewOptions& options) {
    const fs::path out = options.out;
    if (out.extension() != ".toml")
        throw InputError(
            fmt::format("--out is {}, expected the name of a scene file, NAME.toml", options.out));
    const fs::path folder = fs::absolute(out).parent_path();
    if (!fs::is_directory(folder))
        throw InputError(fmt::format("--out is {}: there is no folder {}", options.out, folder.string()));
    if (fs::exists(out) && !options.force)
        throw InputError(
            fmt::format("{} exists: expected another name, or --force to replace it", options.out));
}

/// Throws unless the scene is one that `check --strict` passes: what is left to doubt are the user's values.
Scene checked(const std::string& text, const fs::path& file) {
    Scene scene = parse_scene(with_outlines(text, file), file.string());
    std::vector<std::string> doubts = doubtful(scene);
    for (const auto& [tier, spacings] : scene.tiers)
        for (const double dx : spacings.at(scene.variant)) {
            check_row(scene, tier, dx);
            for (std::string& doubt : doubts_at_spacing(scene, dx)) doubts.push_back(std::move(doubt));
        }
    if (!doubts.empty()) throw InputError(fmt::format("no scene was written: {}", doubts.front()));
    return scene;
}

void print_result(const Scene& scene, const HullSection& section, const EntryChoices& choices,
                  const std::string& out) {
    fmt::print(
        "{}: {} of {:.4g} m beam, sound speed {:.4g} m/s, tank {:.4g} x {:.4g} m, record of {:.4g} ms\n", out,
        section.mirrored ? "half section, mirrored," : "section", section.beam(), choices.sound_speed,
        choices.width, choices.depth + choices.headroom, 1000 * choices.record);
    for (const double dx : choices.spacings()) {
        const CostEstimate cost = estimate_cost(scene, dx);
        fmt::print("  spacing {:.4g} m: {:.0f} fluid particles, about {} on one core\n", dx,
                   cost.fluid_particles, duration_text(cost.core_seconds));
    }
    fmt::print(
        "The reasons stand beside the numbers in the file. Next:\n"
        "  wetdeck check {0}\n"
        "  wetdeck run {0} --dx {1:.10g} --out results/first\n"
        "  wetdeck suite --only {0} --out results\n",
        out, choices.spacings().front());
}

/// The file, and which of its sections the options ask for.
std::string asked_section(const NewOptions& options) {
    if (options.wanted.empty()) return options.section;
    std::optional<SectionAddress> address = section_address(options.section);
    if (!address)
        throw InputError(fmt::format("{}: is a file of corners, of one section alone: expected no --{}",
                                     options.section, options.wanted.begin()->first));
    for (const auto& [key, value] : options.wanted)
        if (!address->wanted.emplace(key, value).second)
            throw InputError(fmt::format("--{}: stands behind the name of the file, too", key));
    return address->text();
}

/// Which outline of a file of sections was taken.
void print_choice(const std::string& section) {
    const std::optional<SectionAddress> address = section_address(section);
    if (!address) return;
    const ChosenSection chosen = read_section_at(*address);
    fmt::print("{}: {}\n", address->file.string(), chosen.title);
    for (const std::string& note : chosen.notes) fmt::print("  {}\n", note);
}

int write_scene(const NewOptions& options) {
    check_out(options);
    const std::string asked = asked_section(options);
    const HullSection section =
        read_section(asked, options.half || options.whole ? std::optional(options.half) : std::nullopt);
    const EntryWishes wishes = wishes_of(options);
    const EntryChoices choices = choose(section, wishes);
    const std::string text = scene_text(section, wishes, choices, options.out);
    const Scene scene = checked(text, options.out);
    atomic_write(options.out, text);
    print_choice(asked);
    print_result(scene, section, choices, options.out);
    return exit_done;
}

void add_number(CLI::App& command, const char* name, std::optional<double>& value, const char* type,
                const char* description) {
    command.add_option(name, value, description)->type_name(type);
}

}  // namespace

void add_new(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<NewOptions>();
    CLI::App& command =
        *app.add_subcommand("new", "write a scene file for the water entry of a section of your own");
    command
        .add_option("section", options->section,
                    "file of the section's corners, x and y; or of one half, from the keel to the deck; or a "
                    "GHS file (.gf), a drawing (.dxf) or a table of offsets")
        ->required()
        ->type_name("");
    add_number(command, "--speed", options->speed, "M/S",
               "speed downwards at which the keel meets the water");
    add_number(command, "--mass", options->mass, "KG/M", "mass per metre of span; it falls freely");
    command.add_flag("--constant-speed", options->constant_speed, "keep the speed, whatever the force");
    add_number(command, "--depth", options->depth, "M", "depth of the water (default: deep)");
    command.add_flag("--air", options->air, "water and air");
    command.add_flag("--no-air", options->no_air, "water alone (default)");
    add_number(command, "--record", options->record, "S",
               "time from contact to the end (default: until the bottom is in the water)");
    CLI::Option* half = command.add_flag("--half", options->half, "the corners are one half: mirror it");
    command.add_flag("--whole", options->whole, "the corners are the whole section")->excludes(half);
    const auto add_wanted = [&](const char* key, const char* type, const char* description) {
        const auto store = [options, key](const std::string& value) { options->wanted[key] = value; };
        command.add_option_function<std::string>(std::string("--") + key, store, description)
            ->type_name(type);
    };
    add_wanted("station", "S", "of a GHS file or a table of offsets: place [m] or name of the station");
    add_wanted("layer", "NAME", "of a drawing: the layer that holds the section");
    add_wanted("row", "N", "the section by its row in the list of `wetdeck sections`");
    add_wanted("part", "N", "of a station with several outlines, counted from the lowest up; or lowest");
    add_wanted("component", "NAME", "of a GHS file: one component alone");
    add_wanted("unit", "UNIT", "of a drawing that does not state its own: m, mm, ft ...");
    add_wanted("axis", "X", "of a drawing: x of the centre line [m]");
    command.add_option("--out", options->out, "the scene file to write")->required()->type_name("SCENE.toml");
    command.add_flag("--force", options->force, "replace the file if it exists");
    command.footer(
        "Sound speed, tank, spacings, sampling and background pressure are chosen by rules; the file states "
        "them.\nSpeed, mass, depth and air that are not given are asked for on a terminal.");
    command.callback([options, &exit_code] { exit_code = write_scene(*options); });
}

}  // namespace wetdeck

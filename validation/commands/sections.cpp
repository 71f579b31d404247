// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck sections`: what sections a file of a naval architect holds, as a list and as a body plan.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/core/errors.hpp"
#include "validation/commands/body_plan.hpp"
#include "validation/commands/commands.hpp"
#include "validation/run/exit_code.hpp"
#include "validation/sections/section_address.hpp"
#include "validation/sections/section_figures.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

struct SectionsOptions {
    std::string file;
    std::optional<std::string> unit, component, picture;
    bool force = false;
};

std::string number_or_dash(std::optional<double> value) {
    return value ? fmt::format("{:.4g}", *value) : "-";
}

/// Heights of the waterlines whose half breadths are listed: quarters of the whole file's depth.
std::vector<double> waterlines_of(const SectionFile& file) {
    std::optional<double> low, high;
    for (const Station& station : file.stations)
        for (const SectionOutline& outline : station.outlines) {
            const SectionFigures figures = figures_of(outline);
            low = std::min(low.value_or(figures.low), figures.low);
            high = std::max(high.value_or(figures.high), figures.high);
        }
    std::vector<double> heights;
    if (low)
        for (const double share : {0.25, 0.5, 0.75}) heights.push_back(*low + share * (*high - *low));
    return heights;
}

std::string short_title(const Station& station) {
    return station.name.empty() ? fmt::format("{:.6g}", station.location.value_or(0)) : station.name;
}

void print_list(const SectionFile& file) {
    const std::vector<double> waterlines = waterlines_of(file);
    std::size_t width = file.key.size() + 4;
    for (const Station& station : file.stations) width = std::max(width, short_title(station).size());
    const bool places = !file.stations.empty() && file.stations.front().name.empty();
    fmt::print("{:>4}  {:>{}}  part  {:>9}  {:>9}  {:>9}  {:>9}  {:>8}", "row",
               file.key + (places ? " [m]" : ""), width, "beam [m]", "depth [m]", "from [m]", "to [m]",
               "deadrise");
    for (const double height : waterlines) fmt::print("  {:>9}", fmt::format("at {:.4g}", height));
    fmt::print("  area [m^2]\n");
    std::size_t row = 0;
    for (const Station& station : file.stations) {
        if (station.outlines.empty())
            fmt::print("{:>4}  {:>{}}     -  {}\n", ++row, short_title(station), width,
                       station.problem.empty() ? "no outline" : station.problem);
        for (std::size_t k = 0; k < station.outlines.size(); ++k) {
            const SectionOutline& outline = station.outlines[k];
            const SectionFigures f = figures_of(outline);
            const auto deadrise =
                f.deadrise ? std::optional(*f.deadrise * 180 / std::numbers::pi) : std::nullopt;
            fmt::print("{:>4}  {:>{}}  {:>4}  {:>9.4g}  {:>9.4g}  {:>9.4g}  {:>9.4g}  {:>8}", ++row,
                       short_title(station), width, fmt::format("{}/{}", k + 1, station.outlines.size()),
                       f.beam, f.depth(), f.low, f.high, number_or_dash(deadrise));
            for (const double height : waterlines)
                fmt::print("  {:>9}", number_or_dash(half_breadth_at(outline, height)));
            fmt::print("  {:>10}{}\n", fmt::format("{:.5g}", f.area),
                       is_half_section(outline) ? "  half"
                       : outline.closed         ? ""
                                                : "  open");
        }
    }
}

void print_notes(const SectionFile& file) {
    for (const std::string& note : file.notes) fmt::print("{}\n", note);
    std::vector<std::pair<std::string, std::vector<const Station*>>> said;  // the stations of each note
    const auto say = [&said](const std::string& note, const Station& station) {
        const auto found =
            std::find_if(said.begin(), said.end(), [&](const auto& s) { return s.first == note; });
        if (found == said.end())
            said.push_back({note, {&station}});
        else
            found->second.push_back(&station);
    };
    for (const Station& station : file.stations) {
        for (const std::string& note : station.notes) say(note, station);
        if (!station.problem.empty() && !station.outlines.empty())
            say("cannot be taken for a body: " + station.problem, station);
    }
    for (const auto& [note, stations] : said)
        fmt::print("{}: {}\n",
                   stations.size() == 1
                       ? stations.front()->title()
                       : fmt::format("{} stations, from {} to {}", stations.size(),
                                     short_title(*stations.front()), short_title(*stations.back())),
                   note);
    fmt::print(
        "Heights and half breadths in m, half breadths from x = 0 at three heights. Deadrise in degrees, "
        "from the "
        "keel to an eighth of the beam beside it. Of a half the beam and the area are those of both "
        "halves.\n");
}

void write_picture(const SectionFile& file, const fs::path& picture, bool force) {
    const std::string extension = picture.extension().string();
    if (extension != ".svg" && extension != ".png")
        throw InputError(fmt::format("--picture is {}, expected FILE.svg or FILE.png", picture.string()));
    if (fs::exists(picture) && !force)
        throw InputError(
            fmt::format("{} exists: expected another name, or --force to replace it", picture.string()));
    if (body_plan(file).empty()) throw InputError("--picture: the file holds no outline to draw");
    drawn_body_plan(file).write(picture);
}

int list_sections(const SectionsOptions& options) {
    SectionAddress address;
    address.file = options.file;
    if (const auto found = section_address(options.file)) address = *found;
    if (options.unit) address.wanted["unit"] = *options.unit;
    if (options.component) address.wanted["component"] = *options.component;
    const SectionFile file = read_sections(address.file, address.options());
    if (options.picture) write_picture(file, *options.picture, options.force);
    fmt::print("{}: {}, lengths in {}\n", address.file.string(), file.format, file.unit);
    print_list(file);
    print_notes(file);
    return exit_done;
}

}  // namespace

void add_sections(CLI::App& app, int& exit_code) {
    const auto options = std::make_shared<SectionsOptions>();
    CLI::App& command = *app.add_subcommand(
        "sections",
        "list the hull sections of a GHS file, a DXF drawing or a table of offsets; draw the body plan");
    command
        .add_option("file", options->file, "GHS geometry file (.gf), DXF drawing (.dxf) or table of offsets")
        ->required()
        ->type_name("");
    command.add_option("--unit", options->unit, "of a drawing that does not state its own: m, mm, ft ...")
        ->type_name("UNIT");
    command.add_option("--component", options->component, "of a GHS file: one component alone")
        ->type_name("NAME");
    command.add_option("--picture", options->picture, "draw the body plan: aft stations left, forward right")
        ->type_name("FILE.svg|FILE.png");
    command.add_flag("--force", options->force, "replace the file if it exists");
    command.footer(
        "A section is taken from its file with `wetdeck new FILE --station S` (or --layer, --row, --part), "
        "or in "
        "a scene with\noutline = \"FILE#station=S&part=N\" (docs/sections.md).");
    command.callback([options, &exit_code] { exit_code = list_sections(*options); });
}

}  // namespace wetdeck

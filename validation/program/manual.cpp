// SPDX-License-Identifier: BSD-3-Clause
#include "validation/program/manual.hpp"

#include <fmt/format.h>

#include "validation/program/command_line.hpp"
#include "validation/store/provenance.hpp"

namespace wetdeck {
namespace {

constexpr const char* head = R"(.SH NAME
wetdeck \- SPH of bodies that slam into water, checked against experiments and exact solutions
.SH SYNOPSIS
.B wetdeck
.I command
.RI [ options ]
.SH DESCRIPTION
wetdeck solves water and air as two weakly compressible fluids in two dimensions by smoothed particle hydrodynamics, runs
published experiments at several resolutions, compares every run with measurements, exact solutions and other codes, and
writes one report of the accuracy reached and its cost. All units are SI.
)";

constexpr const char* tail = R"(.SH FILES
.TP
.I DIR/index.html
the first page of the report, which opens without a network
.TP
.I DIR/scene\-NAME.html, DIR/statistics.html
its other pages
.TP
.I DIR/summary.json
every number of the report
.TP
.I DIR/runs/SCENE/VARIANT/dxDX/run.h5
time series, every parameter, program, machine and cost of one run (HDF5)
.TP
.I DIR/runs/SCENE/VARIANT/dxDX/fields.pvd
the particles over time, for ParaView
.SH ENVIRONMENT
.TP
.B WETDECK_DATA
folder with
.I scenes
and
.I reference_data
to use in place of the installed ones
.TP
.B WETDECK_SIMD
instruction set to use: sse2, avx2 or avx512 (default: the widest that the processor supports)
.TP
.B OMP_NUM_THREADS
number of threads where no option sets it
.SH EXIT STATUS
.TP
.B 0
done and within tolerance
.TP
.B 1
a comparison or check fell outside its stated tolerance
.TP
.B 2
bad usage or bad input; one line on stderr names the place and the expected value
.TP
.B 3
a run became unstable
.TP
.B 4
the environment failed: disk full, no permission
.TP
.B 130, 143
stopped by Ctrl-C or SIGTERM after writing a checkpoint
.SH EXAMPLES
.TP
.B wetdeck suite \-\-tier quick
runs every scene of the quick tier and writes
.I results/quick/index.html
.TP
.B wetdeck run wedge \-\-variant single\-phase \-\-dx 0.01 \-\-out drop
makes one run and stores it in the folder
.I drop
.TP
.B wetdeck report drop
writes the report of that run
)";

/// Text for roff: minus signs and backslashes escaped, and lines that would begin with a control character.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '\\') {
            out += "\\e";
        } else if (letter == '-') {
            out += "\\-";
        } else if ((letter == '.' || letter == '\'') && (out.empty() || out.back() == '\n')) {
            out += std::string("\\&") + letter;
        } else {
            out += letter;
        }
    }
    return out;
}

std::string synopsis(const CommandInfo& command) {
    std::string line = ".B wetdeck " + escaped(command.name) + "\n";
    for (const OptionInfo& option : command.options)
        if (option.positional) line += ".I " + escaped(option.name) + "\n";
    return line + ".RI [ options ]\n";
}

std::string option_entry(const OptionInfo& option) {
    const char* font = option.positional ? "\\fI" : "\\fB";
    const std::string name = font + escaped(option.name) + "\\fR";
    const std::string value = option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", escaped(option.value));
    return fmt::format(".TP\n{}{}\n{}\n", name, value, escaped(option.description));
}

}  // namespace

std::string manual_page() {
    const std::vector<CommandInfo> commands = command_list();
    const std::string version = collect_provenance("", 1).program_version;
    std::string page = fmt::format(".TH WETDECK 1 \"\" \"wetdeck {}\" \"User Commands\"\n", version) + head;
    page += ".SH OPTIONS\n";
    for (const OptionInfo& option : commands.front().options) page += option_entry(option);
    page += ".SH COMMANDS\n";
    for (std::size_t k = 1; k < commands.size(); ++k) {
        const CommandInfo& command = commands[k];
        page += fmt::format(".SS {}\n{}.PP\n{}.\n", escaped(command.name), synopsis(command),
                            escaped(command.description));
        if (!command.footer.empty()) page += ".PP\n" + escaped(command.footer) + "\n";
        for (const OptionInfo& option : command.options) page += option_entry(option);
    }
    return page + tail;
}

}  // namespace wetdeck

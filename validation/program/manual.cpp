// SPDX-License-Identifier: BSD-3-Clause
#include "validation/program/manual.hpp"

#include <fmt/format.h>

#include "validation/program/command_line.hpp"

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
writes one report that says what was reached and at what cost. All units are SI.
)";

constexpr const char* tail = R"(.SH FILES
.TP
.I DIR/index.html
the report: one file that opens without a network
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
folder that holds
.I scenes
and
.I reference_data
in place of those installed with the program
.TP
.B WETDECK_SIMD
instruction set to use: sse2, avx2 or avx512 (the best that the processor has)
.TP
.B OMP_NUM_THREADS
threads where no option says how many
.SH EXIT STATUS
.TP
.B 0
done and within tolerance
.TP
.B 1
a comparison or check fell outside its stated tolerance
.TP
.B 2
bad usage or bad input; one line on stderr says where and what was expected
.TP
.B 3
a run became unstable
.TP
.B 4
the environment failed: disk full, no permission
.TP
.B 130, 143
stopped by Ctrl-C or SIGTERM, with a checkpoint written
.SH EXAMPLES
.TP
.B wetdeck suite \-\-tier quick
runs every scene and writes
.I results/quick/index.html
.TP
.B wetdeck run wedge \-\-variant single\-phase \-\-dx 0.01 \-\-out drop
one run into the folder
.I drop
.TP
.B wetdeck report drop
its report
)";

/// Text as roff takes it: minus signs and backslashes escaped, no line that begins with a control character.
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

std::string manual_page(const std::string& version) {
    const std::vector<CommandInfo> commands = command_list();
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

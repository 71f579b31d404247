// SPDX-License-Identifier: BSD-3-Clause
// A figure as SVG, drawn by gnuplot from a script with the data inside.
#include <fmt/format.h>
#include <stdio.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "reports/figure.hpp"
#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::report {
namespace {

/// A single-quoted string of gnuplot. Control characters would end the command, so they become spaces.
std::string quoted(std::string text) {
    std::string out = "'";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20) {
            out += ' ';
        } else {
            out += c == '\'' ? "''" : std::string(1, c);
        }
    }
    return out + "'";
}

std::string shell_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

/// Labelled 1, 2, 5 of every decade, or decades alone where there are many: gnuplot itself labels only
/// decades, which leaves short axes bare.
std::string logarithmic_ticks(char axis, const Window& range) {
    const bool short_axis = std::log10(range.end / range.begin) < 2.5;
    std::string ticks;
    for (int decade = static_cast<int>(std::floor(std::log10(range.begin)));
         decade <= static_cast<int>(std::ceil(std::log10(range.end))); ++decade) {
        for (const int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10.0, decade);
            if (value < range.begin || value > range.end || (digit > 1 && !short_axis)) continue;
            const bool plain = decade >= -3 && decade <= 4;
            const std::string label = plain        ? fmt::format("{:g}", value)
                                      : digit == 1 ? fmt::format("10^{{{}}}", decade)
                                                   : fmt::format("{}·10^{{{}}}", digit, decade);
            ticks += fmt::format("{}'{}' {:.9g}", ticks.empty() ? "" : ", ", label, value);
        }
    }
    return fmt::format("set {}tics ({})\n", axis, ticks);
}

std::string axis_commands(char name, const Axis& axis, const Window& range) {
    std::string out = fmt::format("set {}label {} noenhanced\nset {}range [{:.9g}:{:.9g}]\n", name,
                                  quoted(axis_title(axis)), name, range.begin, range.end);
    if (axis.logarithmic) out += fmt::format("set logscale {}\n", name) + logarithmic_ticks(name, range);
    return out;
}

std::string data_block(const Figure& figure, const PlotSeries& s, std::size_t index) {
    std::string out = fmt::format("$series{} << END_OF_DATA\n", index);
    for (const std::size_t i : drawn_samples(figure, s)) {
        out += fmt::format("{:.7g} {:.7g}", s.data.x[i], s.data.y[i]);
        if (!s.low.empty()) out += fmt::format(" {:.7g} {:.7g}", s.low[i], s.high[i]);
        out += "\n";
    }
    return out + "END_OF_DATA\n";
}

/// The clauses of the plot command for one series.
std::vector<std::string> plot_clauses(const PlotSeries& s, std::size_t index) {
    const std::string block = fmt::format("$series{}", index);
    const std::string title = s.label.empty() ? "notitle" : "title " + quoted(s.label) + " noenhanced";
    const std::string line = fmt::format("lc rgb '{}' lw {:.2f}", s.colour, s.width);
    const std::string point = fmt::format("lc rgb '{}' pt {} ps {:.2f}", s.colour, s.filled ? 7 : 6, s.point_size / 9);
    std::vector<std::string> clauses;
    switch (s.style) {
        case Style::solid:
            clauses.push_back(fmt::format("{} using 1:2 with lines {} {}", block, line, title));
            break;
        case Style::dashed:
            clauses.push_back(fmt::format("{} using 1:2 with lines dt 2 {} {}", block, line, title));
            break;
        case Style::band:
            clauses.push_back(
                fmt::format("{} using 1:3:4 with filledcurves fc rgb '{}' fs transparent solid 0.18 noborder {}",
                            block, s.colour, title));
            break;
        case Style::line_and_points:
            clauses.push_back(
                fmt::format("{} using 1:2 with linespoints lw {:.2f} {} {}", block, s.width, point, title));
            break;
        case Style::points:
            if (!s.low.empty()) {
                clauses.push_back(fmt::format("{} using 1:2:3:4 with yerrorbars lw 0.8 {} {}", block, point, title));
            } else {
                clauses.push_back(fmt::format("{} using 1:2 with points {} {}", block, point, title));
            }
            break;
    }
    return clauses;
}

std::string point_labels(const Figure& figure) {
    std::string out;
    for (const PlotSeries& s : figure.series) {
        if (s.point_labels.empty()) continue;
        for (const std::size_t i : drawn_samples(figure, s)) {
            out += fmt::format("set label {} at {:.7g},{:.7g} offset 0.6,0.6 noenhanced font ',10' tc rgb '{}'\n",
                               quoted(s.point_labels[i]), s.data.x[i], s.data.y[i], s.colour);
        }
    }
    return out;
}

struct Outcome {
    int status = 0;
    std::string words;
};

/// Runs a shell command and keeps what it says.
Outcome run(const std::string& command) {
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) throw EnvironmentError("cannot start a shell to run gnuplot");
    Outcome outcome;
    std::array<char, 512> buffer{};
    while (::fgets(buffer.data(), buffer.size(), pipe) != nullptr) outcome.words += buffer.data();
    outcome.status = ::pclose(pipe);
    return outcome;
}

std::string last_line(std::string words) {
    while (!words.empty() && words.back() == '\n') words.pop_back();
    return words.substr(words.find_last_of('\n') + 1);
}

}  // namespace

std::string gnuplot_script(const Figure& figure, const std::filesystem::path& output) {
    std::string out =
        "set terminal svg size 760,500 dynamic enhanced font 'DejaVu Sans,12' background 'white'\n"
        "set encoding utf8\nset border 3 lc rgb '#444444'\nset tics nomirror\n"
        "set grid lc rgb '#e3e6ea' lt 1 lw 0.6\n"
        "set key below left Left reverse samplen 2 spacing 1.1 maxcols 2 noenhanced\n";
    out += "set output " + quoted(output.string()) + "\n";
    out += "set title " + quoted(figure.title) + " noenhanced\n";
    const Window x_range = data_range(figure, true);
    out += axis_commands('x', figure.x, x_range) + axis_commands('y', figure.y, data_range(figure, false));
    if (figure.shaded) {
        const double begin = std::clamp(figure.shaded->begin, x_range.begin, x_range.end);
        const double end = std::clamp(figure.shaded->end, x_range.begin, x_range.end);
        out += fmt::format(
            "set object rectangle from {:.9g},graph 0 to {:.9g},graph 1 behind fc rgb '#f3f1e6' fs solid noborder\n", begin,
            end);
    }
    out += point_labels(figure);
    std::string clauses;
    for (std::size_t k = 0; k < figure.series.size(); ++k) {
        if (drawn_samples(figure, figure.series[k]).empty()) continue;
        out += data_block(figure, figure.series[k], k);
        for (const std::string& clause : plot_clauses(figure.series[k], k)) {
            clauses += (clauses.empty() ? "" : ", \\\n     ") + clause;
        }
    }
    return out + "plot " + (clauses.empty() ? "NaN notitle" : clauses) + "\n";
}

bool gnuplot_found() { return run("command -v gnuplot").status == 0; }

void write_svg(const Figure& figure, const std::filesystem::path& path) {
    const std::filesystem::path drawing = temporary_name(path);
    std::filesystem::path script = path;
    script.replace_extension(".gnuplot.tmp");
    atomic_write(script, gnuplot_script(figure, drawing));
    const Outcome outcome = run("gnuplot " + shell_quoted(script.string()) + " 2>&1");
    std::error_code ignored;
    std::filesystem::remove(script, ignored);
    if (outcome.status != 0) {
        std::filesystem::remove(drawing, ignored);
        throw EnvironmentError(fmt::format("{}: gnuplot failed (status {}): {}", path.string(),
                                           WIFEXITED(outcome.status) ? WEXITSTATUS(outcome.status) : outcome.status,
                                           last_line(outcome.words)));
    }
    std::error_code error;
    std::filesystem::rename(drawing, path, error);
    if (error) throw environment_error(path, "replace", error.value());
}

}  // namespace wetdeck::report

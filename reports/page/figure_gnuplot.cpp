// SPDX-License-Identifier: BSD-3-Clause
// A figure as SVG, drawn by gnuplot from a script with the data inside.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "reports/page/figure.hpp"
#include "reports/page/html.hpp"
#include "reports/page/strings.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/child_process.hpp"
#include "validation/store/whole_file.hpp"

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
    for (const std::size_t i : drawn_samples(figure, s, static_columns)) {
        out += fmt::format("{:.5g} {:.5g}", s.data.x[i], s.data.y[i]);
        if (!s.low.empty()) out += fmt::format(" {:.5g} {:.5g}", s.low[i], s.high[i]);
        out += "\n";
    }
    return out + "END_OF_DATA\n";
}

int point_type(const PlotSeries& s) {
    static constexpr std::array<int, 4> filled{7, 5, 9, 13};
    const int type = filled.at(static_cast<std::size_t>(s.marker));
    return s.filled ? type : type - 1;
}

/// The clauses of the plot command for one series.
std::vector<std::string> plot_clauses(const PlotSeries& s, std::size_t index) {
    const std::string block = fmt::format("$series{}", index);
    const std::string title = s.label.empty() ? "notitle" : "title " + quoted(s.label) + " noenhanced";
    const std::string line = fmt::format("lc rgb '{}' lw {:.2f}", s.colour, s.width);
    const std::string point =
        fmt::format("lc rgb '{}' pt {} ps {:.2f}", s.colour, point_type(s), s.point_size / 9);
    std::vector<std::string> clauses;
    switch (s.style) {
        case Style::solid:
            clauses.push_back(fmt::format("{} using 1:2 with lines {} {}", block, line, title));
            break;
        case Style::dashed:
            clauses.push_back(fmt::format("{} using 1:2 with lines dt 2 {} {}", block, line, title));
            break;
        case Style::band:
            clauses.push_back(fmt::format(
                "{} using 1:3:4 with filledcurves fc rgb '{}' fs transparent solid 0.18 noborder {}", block,
                s.colour, title));
            break;
        case Style::line_and_points:
            clauses.push_back(
                fmt::format("{} using 1:2 with linespoints lw {:.2f} {} {}", block, s.width, point, title));
            break;
        case Style::points:
            // Drawn as vectors: its own error bars come with a white ring around each point.
            if (!s.low.empty()) {
                clauses.push_back(
                    fmt::format("{} using 1:3:(0):($4-$3) with vectors heads size graph 0.005,90 lc rgb '{}' "
                                "lw 0.8 notitle",
                                block, s.colour));
            }
            clauses.push_back(fmt::format("{} using 1:2 with points {} {}", block, point, title));
            break;
    }
    return clauses;
}

std::string point_labels(const Figure& figure) {
    std::string out;
    for (const PlotSeries& s : figure.series) {
        if (s.point_labels.empty()) continue;
        for (const std::size_t i : drawn_samples(figure, s, static_columns)) {
            out += fmt::format(
                "set label {} at {:.7g},{:.7g} offset 0.6,0.6 noenhanced font ',10' tc rgb '{}'\n",
                quoted(s.point_labels[i]), s.data.x[i], s.data.y[i], s.colour);
        }
    }
    return out;
}

std::string last_line(const std::string& text) {
    return text.substr(text.find_last_of('\n') + 1);
}

constexpr const char* drawing_fonts = "DejaVu Sans,Verdana,sans-serif";
constexpr int drawing_width = 620;  // [px]

/// Canvas and legend. The legend has its own strip below the axes: gnuplot's automatic one can overlap the
/// label of the axis.
std::string canvas(const Figure& figure) {
    long entries = 0;
    std::size_t longest = 0;
    for (const PlotSeries& s : figure.series) {
        if (!s.label.empty()) ++entries;
        longest = std::max(longest, s.label.size());
    }
    const long columns = longest > 26 ? 1 : 2;
    const long rows = std::max(1L, (entries + columns - 1) / columns);
    const long strip = 21 * rows + 6;  // [px]
    const auto height = static_cast<double>(350 + strip);
    return fmt::format(
        "set terminal svg size {},{:.0f} dynamic enhanced font 'DejaVu Sans,12' background 'white'\n"
        "set encoding utf8\nset border 3 lc rgb '#444444'\nset tics nomirror\n"
        "set grid lc rgb '#e3e6ea' lt 1 lw 0.6\nset tmargin 1\nset bmargin at screen {:.4f}\n"
        "set key at screen 0.1, screen {:.4f} left top Left reverse samplen 2 spacing 1.1 vertical maxrows "
        "{} "
        "noenhanced\n",
        drawing_width, height, static_cast<double>(strip + 58) / height, static_cast<double>(strip) / height,
        rows);
}

/// The drawing as a file that stands alone: with its title above and its stamp below.
std::string with_title(const std::string& svg, const Figure& figure) {
    static const std::string begin = fmt::format("viewBox=\"0 0 {} ", drawing_width);
    constexpr int above = 26, below = 14;  // [px]
    const std::size_t box = svg.find(begin), open = svg.find('>', box), close = svg.rfind("</svg>");
    if (box == std::string::npos || close == std::string::npos) return svg;
    const int height = std::atoi(svg.c_str() + box + begin.size());
    const int whole = height + above + below;
    const std::size_t end = svg.find('"', box + begin.size());
    return svg.substr(0, box) + fmt::format("viewBox=\"0 {} {} {}", -above, drawing_width, whole) +
           svg.substr(end, open + 1 - end) +
           fmt::format("\n<rect y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>", -above,
                       drawing_width, whole) +
           svg.substr(open + 1, close - open - 1) +
           fmt::format(
               "<g font-family=\"{0}\"><text x=\"{1}\" y=\"-8\" font-size=\"12\" "
               "text-anchor=\"middle\">{2}</text>\n<text x=\"{3}\" y=\"{4}\" font-size=\"7\" "
               "text-anchor=\"end\" fill=\"#7b8791\">{5}</text></g>\n",
               drawing_fonts, drawing_width / 2, escape(figure.title), drawing_width - 6, height + 8,
               escape(figure.stamp)) +
           svg.substr(close);
}

/// What gnuplot has drawn, made smaller; empty where it has not come to its end.
std::string finished_drawing(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return "";
    const std::string drawn = read_whole_file(path);
    if (drawn.find("</svg>") == std::string::npos) return "";
    std::string svg = smaller_svg(drawn);
    // The drawing is seen on machines that lack the font.
    replace_all(svg, "font-family=\"DejaVu Sans", fmt::format("font-family=\"{}", drawing_fonts));
    return svg;
}

}  // namespace

std::string gnuplot_script(const Figure& figure, const std::filesystem::path& output) {
    std::string out = canvas(figure);
    out += "set output " + quoted(output.string()) + "\n";
    const Window x_range = data_range(figure, true);
    out += axis_commands('x', figure.x, x_range) + axis_commands('y', figure.y, data_range(figure, false));
    if (figure.shaded) {
        const double begin = std::clamp(figure.shaded->begin, x_range.begin, x_range.end);
        const double end = std::clamp(figure.shaded->end, x_range.begin, x_range.end);
        out += fmt::format(
            "set object rectangle from {:.9g},graph 0 to {:.9g},graph 1 behind fc rgb '#f3f1e6' fs solid "
            "noborder\n",
            begin, end);
    }
    out += point_labels(figure);
    std::string clauses;
    for (std::size_t k = 0; k < figure.series.size(); ++k) {
        if (drawn_samples(figure, figure.series[k], static_columns).empty()) continue;
        out += data_block(figure, figure.series[k], k);
        for (const std::string& clause : plot_clauses(figure.series[k], k)) {
            clauses += (clauses.empty() ? "" : ", \\\n     ") + clause;
        }
    }
    return out + "plot " + (clauses.empty() ? "NaN notitle" : clauses) + "\n";
}

bool gnuplot_found() {
    return program_found("gnuplot");
}

std::vector<Drawing> write_svgs(std::span<const Figure> figures, const std::filesystem::path& folder) {
    const std::filesystem::path script = temporary_name(folder / "figures.gnuplot");
    std::vector<std::filesystem::path> drawn;  // by gnuplot, before they get their title
    for (const Figure& figure : figures) drawn.push_back(temporary_name(folder / (figure.name + ".svg")));
    std::vector<Drawing> drawings;
    std::error_code ignored;
    while (drawings.size() < figures.size()) {
        std::string commands;
        for (std::size_t k = drawings.size(); k < figures.size(); ++k)
            commands += gnuplot_script(figures[k], drawn[k]) + "unset output\nreset\n";
        atomic_write(script, commands);
        const ShellResult result = run_in_shell("gnuplot " + shell_quoted(script.string()));
        bool complete = true;
        for (std::size_t k = drawings.size(); complete && k < figures.size(); ++k) {
            const std::filesystem::path path = folder / (figures[k].name + ".svg");
            Drawing drawing{finished_drawing(drawn[k]), {}};
            complete = !drawing.svg.empty();
            if (complete)
                atomic_write(path, with_title(drawing.svg, figures[k]));
            else
                drawing.failure = fmt::format("{}: gnuplot failed (status {}): {}", path.string(),
                                              result.status, last_line(result.output));
            drawings.push_back(std::move(drawing));
        }
        for (const std::filesystem::path& each : drawn) std::filesystem::remove(each, ignored);
    }
    std::filesystem::remove(script, ignored);
    return drawings;
}

}  // namespace wetdeck::report

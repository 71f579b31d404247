// SPDX-License-Identifier: BSD-3-Clause
// Makes the drawings of gnuplot smaller without changing what they show.
#include <cctype>
#include <sstream>

#include "reports/page/figure.hpp"
#include "reports/page/strings.hpp"

namespace wetdeck::report {
namespace {

/// Filters that gnuplot defines for labels in boxes, which no figure has.
bool of_a_filter(const std::string& line) {
    return line.find("filter") != std::string::npos || line.find("<fe") != std::string::npos;
}

/// Coordinates to a tenth of a pixel: drops the second of exactly two decimals.
std::string to_tenths(const std::string& line) {
    const auto digit = [&](std::size_t i) {
        return i < line.size() && std::isdigit(static_cast<unsigned char>(line[i])) != 0;
    };
    std::string out;
    for (std::size_t i = 0; i < line.size(); ++i) {
        out += line[i];
        if (line[i] != '.' || !digit(i + 1) || !digit(i + 2) || digit(i + 3)) continue;
        if (line[i + 1] == '0') {
            out.pop_back();
        } else {
            out += line[i + 1];
        }
        i += 2;
    }
    return out;
}

}  // namespace

std::string smaller_svg(const std::string& svg) {
    std::istringstream lines(svg);
    std::string out, group, line;  // `group`: an opened one that may turn out empty
    while (std::getline(lines, line)) {
        const bool words = line.find("<t") != std::string::npos;
        if (line.empty() || (!words && of_a_filter(line))) continue;
        if (!words) {
            // what SVG assumes anyway
            replace_all(line, " stroke-linecap=\"butt\" stroke-linejoin=\"miter\"", "");
            replace_all(line, "rgb( ", "rgb(");
            replace_all(line, ",  ", ",");
        }
        replace_all(line, "<tspan font-family=\"DejaVu Sans\" >", "<tspan>");  // as its group
        line.erase(0, line.find_first_not_of('\t'));
        if (!group.empty() && line == "</g>") {
            group.clear();
            continue;
        }
        out += group;
        group.clear();
        const bool definition = line.find("id='") != std::string::npos;
        std::string kept = (words || definition ? line : to_tenths(line)) + "\n";
        const bool opens = line.rfind("<g fill", 0) == 0 && line.back() == '>';
        (opens ? group : out) += kept;
    }
    return out + group;
}

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
// Outlines and curves in any combination of separator, line end, comment, byte order mark, sign and
// separators at the end of a line: the numbers stay the same to the bit.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/property/generated.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/scene/outline_file.hpp"

using namespace wetdeck;

namespace {

/// How a program writes a table.
struct Style {
    std::string mark, separator, end;
    bool plus, quotes, trailing, comments;
};

Style draw_style(std::initializer_list<const char*> separators) {
    Style style;
    style.mark = generated::one_of<const char*>("byte order mark", {"", "\xEF\xBB\xBF"});
    style.separator = generated::one_of<const char*>("separator", separators);
    style.end = generated::one_of<const char*>("line ends", {"\n", "\r\n"});
    style.plus = generated::one_of("plus signs", {false, true});
    style.quotes = generated::one_of("quotes", {false, true});
    style.trailing = generated::one_of("separators at the end", {false, true});
    style.comments = generated::one_of("comments", {false, true});
    return style;
}

std::string cell(const Style& style, double x) {
    const std::string text = fmt::format("{}{}", style.plus && !std::signbit(x) ? "+" : "", x);
    return style.quotes ? fmt::format("\"{}\"", text) : text;
}

/// Lines of cells, and between them what a reader passes over.
std::string lines_of(const Style& style, const std::vector<std::vector<double>>& rows) {
    std::string text;
    for (const std::vector<double>& row : rows) {
        if (style.comments)
            text += generated::one_of<const char*>("between", {"", "# note: 1,2", "  #", " "}) + style.end;
        std::vector<std::string> cells;
        for (const double x : row) cells.push_back(cell(style, x));
        text += fmt::format(
            "{}{}{}{}", fmt::join(cells, style.separator), style.trailing ? style.separator : "",
            style.comments ? generated::one_of<const char*>("behind", {"", " # 3;4", "#"}) : "", style.end);
    }
    return text;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::string head(const std::string& end) {
    std::string text;
    for (const char* line :
         {"kind: experiment", "citation: a, b; c", "doi: b", "figure: c", "obtained: digitised",
          "obtained_from: d", "date: 2026-01-31", "digitisation_error: e", "u_data: 0.03", "u_data_source: f",
          "sensor: g", "filter: none", "sign: up", "time_origin: h", "note: i", "logged by hand"})
        text += fmt::format("# {}{}", line, end);
    return text;
}

}  // namespace

TEST_CASE("An outline in any dialect has the same corners", "[generated][outline]") {
    generated::check(300, [] {
        const auto drawn =
            *rc::gen::suchThat(rc::gen::unique<std::vector<std::pair<double, double>>>(
                                   rc::gen::pair(generated::number(-10, 10), generated::number(-10, 10))),
                               [](const auto& corners) { return corners.size() >= 3; })
                 .as("corners");
        std::vector<std::vector<double>> rows;
        for (const auto& [x, y] : drawn) rows.push_back({x, y});
        const Style style = draw_style({",", ";", "\t", " ", ", ", " ;"});
        const std::string names =
            generated::one_of<const char*>("names", {"", "x", "half breadth [m]", "\"y\""});
        std::string text = style.mark;
        if (!names.empty()) text += names + style.separator + "z" + style.end;
        text += lines_of(style, rows);
        const Outline outline = parse_outline("hull.csv", text);
        RC_ASSERT(outline.size() == rows.size());
        for (std::size_t n = 0; n < rows.size(); ++n) {
            RC_ASSERT(same_bits(outline[n].x(), rows[n][0]));
            RC_ASSERT(same_bits(outline[n].y(), rows[n][1]));
        }
    });
}

TEST_CASE("A curve in any dialect has the same columns", "[generated][reference]") {
    generated::check(300, [] {
        const std::size_t columns = static_cast<std::size_t>(*generated::whole(2, 4).as("columns"));
        std::vector<double> x =
            *rc::gen::nonEmpty(rc::gen::unique<std::vector<double>>(generated::number(-5, 5))).as("abscissa");
        std::sort(x.begin(), x.end());
        std::vector<std::vector<double>> rows;
        for (const double first : x) {
            rows.push_back({first});
            while (rows.back().size() < columns)
                rows.back().push_back(*generated::number(-1e3, 1e3).as("cell"));
        }
        const Style style = draw_style({",", ";", "\t", ", ", " ;"});
        std::string text = style.mark + head(style.end);
        for (std::size_t n = 0; n < columns; ++n)
            text += fmt::format("{}c{} [Pa]", n > 0 ? style.separator : "", n);
        text += (style.trailing ? style.separator : "") + style.end + lines_of(style, rows);
        const Reference reference = parse_reference("a.csv", text);
        RC_ASSERT(reference.columns.size() == columns);
        RC_ASSERT(reference.keys.at("citation") == "a, b; c");
        for (std::size_t n = 0; n < columns; ++n) {
            RC_ASSERT(reference.columns[n].values.size() == rows.size());
            for (std::size_t row = 0; row < rows.size(); ++row)
                RC_ASSERT(same_bits(reference.columns[n].values[row], rows[row][n]));
        }
    });
}

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/outline_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/scene/toml_reader.hpp"
#include "validation/sections/section_address.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr std::size_t most_corners = 10'000;
constexpr std::uintmax_t largest_file = 20'000'000;  // [bytes]

/// Texts in these brackets, "m" and "mm" of "x [m], y [mm]".
std::vector<std::string> in_brackets(std::string_view line, char open, char close) {
    std::vector<std::string> texts;
    for (std::size_t at = 0; (at = line.find(open, at)) != std::string_view::npos; ++at) {
        const std::size_t end = line.find(close, at);
        if (end == std::string_view::npos) break;
        texts.emplace_back(trimmed(line.substr(at + 1, end - at - 1)));
    }
    return texts;
}

/// A length that a title may name without brackets, "x mm" or "x_mm"; metres are read anyway.
bool names_other_length(std::string_view cell) {
    static const std::set<std::string_view> lengths = {"mm", "cm",     "dm",   "km",   "um",   "in",
                                                       "ft", "inches", "inch", "feet", "foot", "millimetres"};
    const std::size_t last = cell.find_last_of(" _");
    return lengths.contains(last == std::string_view::npos ? cell : cell.substr(last + 1));
}

/// Whether a title holds one of these words, whatever its case.
bool names_any(std::string_view title, const std::set<std::string_view>& words) {
    std::string word;
    for (const char c : std::string(title) + " ") {
        if (std::isalpha(static_cast<unsigned char>(c))) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else {
            if (words.contains(word)) return true;
            word.clear();
        }
    }
    return false;
}

/// Titles of a height and of a breadth.
const std::set<std::string_view> heights = {"y", "z", "height", "draught", "draft", "depth", "vertical"};
const std::set<std::string_view> breadths = {"x", "breadth", "beam", "width", "horizontal", "offset"};

/// Reads the lines of one file of corners.
class CornerReader {
  public:
    CornerReader(const std::string& name, std::string_view text) : name_(name), lines_(name, text) {}

    Outline read() {
        while (lines_.next()) {
            const std::string_view line = trimmed(without_comment(lines_.line()));
            if (line.empty())
                read_remark();
            else
                read_line(line);
        }
        if (outline_.size() > 1 && outline_.back() == outline_.front()) outline_.pop_back();
        if (outline_.size() < 3)
            throw DataError(fmt::format("{}: holds {} corners, expected at least 3 lines of x, y [m]", name_,
                                        outline_.size()));
        return std::move(outline_);
    }

  private:
    void read_line(std::string_view line) {
        const char separator = separator_in(line);
        std::vector<std::string_view> cells = cells_of(line, separator);
        drop_empty_end(cells);
        if (cells.empty()) return;  // separators alone, as spreadsheets write for an empty row
        if (!outline_.empty() || std::any_of(cells.begin(), cells.end(), begins_as_number))
            read_corner(line, cells, separator);
        else
            read_titles(line, cells);
    }

    void read_corner(std::string_view line, const std::vector<std::string_view>& cells, char separator) {
        std::vector<double> numbers;
        for (const std::string_view cell : cells)
            if (const auto number = number_in(cell); number && std::isfinite(*number))
                numbers.push_back(*number);
        if (cells.size() != 2 || numbers.size() != 2) fail_on_numbers(line, cells);
        if (!outline_.empty() && separator != separator_)
            lines_.fail(fmt::format("numbers between {}, between {} in the lines before",
                                    separator_name(separator), separator_name(separator_)));
        const Vec2 corner(factors_[0] * numbers[0], factors_[1] * numbers[1]);
        if (!outline_.empty() && corner == outline_.back())
            lines_.fail("is the same corner as the one before");
        if (outline_.size() == most_corners) lines_.fail(fmt::format("more than {} corners", most_corners));
        separator_ = separator;
        outline_.push_back(corner);
    }

    [[noreturn]] void fail_on_numbers(std::string_view line,
                                      const std::vector<std::string_view>& cells) const {
        std::string hint;
        for (const std::string_view cell : cells)
            if (hint.empty() && !number_in(cell)) hint = reading_hint(cell);
        const auto words = cells_of(line, ' ');
        const bool commas = words.size() == 2 && cells.size() > 2 &&
                            std::all_of(words.begin(), words.end(), [](std::string_view word) {
                                return word.find(',') != std::string_view::npos && !word.ends_with(',');
                            });
        if (hint.empty() && (commas || cells.size() == 4)) hint = reading_hint("0,0");
        if (hint.empty() && outline_.empty() && !begins_as_number(cells.front()))
            hint = ", or names without a number; a title begins with '#'";
        lines_.fail("expected two numbers, x and y [m]" + hint);
    }

    /// One line of names in front of the corners, and one of units.
    void read_titles(std::string_view line, const std::vector<std::string_view>& cells) {
        std::vector<std::string> units = in_brackets(line, '[', ']');
        if (units.empty()) units = in_brackets(line, '(', ')');
        const bool units_alone =
            units.size() == cells.size() && std::all_of(cells.begin(), cells.end(), [](auto cell) {
                return cell.starts_with('[') || cell.starts_with('(');
            });
        if (titles_ > 0 && !(titles_ == 1 && units_alone)) lines_.fail("expected two numbers, x and y [m]");
        ++titles_;
        take_units(units);
        if (cells.size() == 2 && names_any(cells[0], heights) && names_any(cells[1], breadths))
            lines_.fail(fmt::format("names '{}' before '{}', expected the columns x, y", cells[0], cells[1]));
        if (!units.empty()) return;
        for (const std::string_view cell : cells)
            if (names_other_length(cell))
                lines_.fail(
                    fmt::format("'{}' names a unit, expected it in brackets, as in 'x [mm], y [mm]'", cell));
    }

    /// Units in brackets count also where the titles are a remark, as scripts write them.
    void read_remark() {
        if (!outline_.empty() || titles_ > 0) return;
        const std::vector<std::string> units = in_brackets(lines_.line(), '[', ']');
        const bool lengths =
            !units.empty() && units.size() <= 2 && std::all_of(units.begin(), units.end(), is_length);
        if (lengths) take_units(units);
    }

    void take_units(const std::vector<std::string>& units) {
        if (units.empty()) return;
        if (units.size() > 2)
            lines_.fail("more than two units, expected those of x and y, as in 'x [m], y [m]'");
        for (const std::string& unit : units)
            if (!is_length(unit))
                lines_.fail(
                    fmt::format("the unit '{}' is none of length, expected one such as m, mm, cm, ft", unit));
        factors_ = {unit_named(units.front()).factor, unit_named(units.back()).factor};
    }

    std::string name_;
    TextLines lines_;
    Outline outline_;
    char separator_ = ',';
    int titles_ = 0;
    std::array<double, 2> factors_{1, 1};  ///< metres in one unit of x and of y
};

/// Where a line of a scene file ends, if a comment may be added there; else npos.
std::size_t end_for_comment(const std::string& text, std::size_t from) {
    std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view rest = std::string_view(text).substr(from, end - from);
    if (rest.find("\"\"\"") != std::string_view::npos || rest.find("'''") != std::string_view::npos)
        return std::string::npos;
    if (end > from && text[end - 1] == '\r') --end;
    return end;
}

}  // namespace

Outline read_outline(const std::filesystem::path& file) {
    if (const auto address = section_address(file.string())) return read_section_at(*address).corners;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(fmt::format("{}: no such file of corners", file.string()));
    if (std::filesystem::file_size(file, error) > largest_file)
        throw InputError(
            fmt::format("{}: larger than {} bytes, not a file of corners", file.string(), largest_file));
    return parse_outline(file.string(), read_whole_file(file));
}

Outline parse_outline(const std::string& name, std::string_view text) {
    return CornerReader(name, text).read();
}

Outline mirrored_section(Outline half) {
    constexpr double on_axis = 1e-9;  // [m]
    for (Vec2& corner : half) {
        if (std::abs(corner.x()) < on_axis) corner.x() = 0;
        if (corner.x() < 0) throw InputError("of a mirrored body has a corner at x < 0");
    }
    if (half.empty()) return half;
    const Vec2 bottom = half.back().y() < half.front().y() ? half.back() : half.front();
    if (bottom.x() > 0)
        throw InputError(
            fmt::format("of a mirrored body has its lower end at ({0}, {1}), off the axis x = 0, and would "
                        "be closed by a "
                        "flat bottom from {2} to {0} m; for a flat bottom add the corner [0, {1}], for two "
                        "hulls write two "
                        "bodies (body, body_2) without 'mirrored'",
                        bottom.x(), bottom.y(), -bottom.x()));
    for (std::size_t k = half.size(); k-- > 0;)
        if (half[k].x() > 0) half.emplace_back(-half[k].x(), half[k].y());
    return half;
}

std::string with_outlines(std::string text, const std::filesystem::path& scene) {
    const auto files = TomlDocument(text, scene.string()).texts_named("outline");
    for (auto file = files.rbegin(); file != files.rend(); ++file) {  // from the end: places before it stay
        std::string corners, source;
        try {
            const std::filesystem::path path = scene.parent_path() / file->value;
            Outline outline;
            if (const auto address = section_address(path.string())) {
                ChosenSection chosen = read_section_at(*address);
                outline = std::move(chosen.corners);
                source = std::move(chosen.source);
            } else {
                outline = read_outline(path);
            }
            for (const Vec2& corner : outline)
                corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", corner.x(), corner.y());
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("{}:{}: key '{}': {}", scene.string(), file->line, file->key, error.what()));
        }
        if (const std::size_t end = end_for_comment(text, file->end);
            !source.empty() && end != std::string::npos)
            text.insert(end, "  # " + source);
        text.replace(file->begin, file->end - file->begin, "[" + corners + "]");
    }
    return text;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Tables of offsets: half breadths by station and waterline, as lines plans list them. One row a point,
//   station [m], waterline [m], half breadth [m]
// or a matrix with the stations across and the waterlines down, in the unit of its first cell,
//   waterline [m], 0, 1, 2, ...
// Cells above the deck and below the keel are empty. Each station is one half, from the keel to the deck.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/sections/section_file.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {
namespace {

constexpr std::size_t most_stations = 1000, most_rows = 10'000;

std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

/// The text in the brackets of a title, "m" of "waterline [m]".
std::optional<std::string> in_brackets(std::string_view cell) {
    for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
        const std::size_t begin = cell.find(open), end = cell.find(close);
        if (begin != std::string_view::npos && end != std::string_view::npos && begin < end)
            return std::string(trimmed(cell.substr(begin + 1, end - begin - 1)));
    }
    return std::nullopt;
}

bool is_title(std::string_view cell) {
    const std::string text = lower_case(cell);
    return text.find("station") != std::string::npos || text.find("waterline") != std::string::npos;
}

class Reader {
  public:
    Reader(const std::string& name, std::string_view text) : name_(name), lines_(name, text) {}

    SectionFile read() {
        file_.format = "table of offsets";
        file_.key = "station";
        file_.bow_first = true;
        if (!next_row()) lines_.fail("holds no line of titles, expected a table of offsets");
        const bool matrix = cells_.size() > 2 && std::all_of(cells_.begin() + 1, cells_.end(), [](auto cell) {
                                return !in_brackets(cell) && !is_title(cell);
                            });
        matrix ? read_matrix() : read_rows();
        for (const Station& station : file_.stations) check(station);
        file_.notes.push_back(
            "Half sections, from the keel to the deck. The body plan takes the table to "
            "begin at the bow.");
        return std::move(file_);
    }

  private:
    bool next_row() {
        while (lines_.next()) {
            const std::string_view line = trimmed(without_comment(lines_.line()));
            if (line.empty()) continue;
            if (separator_ == 0) separator_ = separator_in(line);
            cells_ = cells_of(line, separator_);
            if (std::all_of(cells_.begin(), cells_.end(), [](auto cell) { return cell.empty(); })) continue;
            text_ = line;
            return true;
        }
        return false;
    }

    /// Metres in one unit of a title.
    double factor_of(std::string_view title, const std::string& what) {
        const std::optional<std::string> unit = in_brackets(title);
        if (!unit)
            lines_.fail(
                fmt::format("'{}' states no unit: expected it in brackets, as in '{} [m]'", title, what));
        if (!is_length(*unit))
            lines_.fail(
                fmt::format("the unit '{}' is none of length, expected one such as m, mm, ft", *unit));
        file_.unit = *unit + ", as the titles say";
        return unit_named(*unit).factor;
    }

    double number(std::string_view cell, const std::string& what) const {
        const auto value = number_in(cell);
        if (!value || !std::isfinite(*value))
            lines_.fail(fmt::format("'{}': expected {}{}", cell, what, reading_hint(cell)));
        return *value;
    }

    Station& station_named(std::string_view name, std::optional<double> metres) {
        for (Station& station : file_.stations)
            if (station.name == name) return station;
        if (file_.stations.size() == most_stations) lines_.fail("more stations than expected");
        Station station;
        station.name = name;
        if (const auto place = number_in(name); metres && place) station.location = *place * *metres;
        station.outlines.push_back({{}, false});
        file_.stations.push_back(std::move(station));
        return file_.stations.back();
    }

    void add(Station& station, Vec2 point) {
        Outline& half = station.outlines.front().corners;
        if (point.x() < 0) lines_.fail("a half breadth is negative, expected the half at starboard");
        if (!half.empty() && point.y() < half.back().y())
            lines_.fail(
                fmt::format("{}: a waterline below the one before, expected them from the keel to the "
                            "deck",
                            station.title()));
        if (!half.empty() && point == half.back())
            lines_.fail(fmt::format("{}: the same point twice", station.title()));
        if (half.size() == most_rows) lines_.fail("more rows than expected");
        half.push_back(point);
        if (!station.source.empty()) station.source += '\n';
        station.source += fmt::format("{}, {}", point.x(), point.y());
    }

    void read_rows() {
        if (cells_.size() != 3 || lower_case(cells_[0]).find("station") == std::string::npos)
            lines_.fail(
                "expected the titles 'station, waterline [m], half breadth [m]', or 'waterline [m]' "
                "and the stations");
        const auto names = [this](std::size_t k, std::string_view word) {
            return lower_case(cells_[k]).find(word) != std::string::npos;
        };
        if (names(1, "breadth") || names(2, "waterline") || names(2, "height"))
            lines_.fail("expected the titles in the order station, waterline, half breadth");
        std::optional<double> along;
        if (in_brackets(cells_[0]) && *in_brackets(cells_[0]) != "-") along = factor_of(cells_[0], "station");
        const double up = factor_of(cells_[1], "waterline"), across = factor_of(cells_[2], "half breadth");
        while (next_row()) {
            drop_empty_end(cells_, 3);
            if (cells_.size() != 3)
                lines_.fail(
                    fmt::format("has {} cells, expected 3: station, waterline, half breadth", cells_.size()));
            if (cells_[0].empty()) lines_.fail("expected the name or place of a station in the first cell");
            const Vec2 point(across * number(cells_[2], "a half breadth"),
                             up * number(cells_[1], "a waterline"));
            add(station_named(cells_[0], along), point);
        }
    }

    void read_matrix() {
        if (!is_title(cells_[0])) lines_.fail("expected 'waterline [m]' in the first cell");
        const double metres = factor_of(cells_[0], "waterline");
        drop_empty_end(cells_);
        const std::size_t width = cells_.size();
        for (std::size_t k = 1; k < width; ++k) {
            if (cells_[k].empty()) lines_.fail("expected the name or place of a station in each cell");
            const std::size_t before = file_.stations.size();
            station_named(cells_[k], std::nullopt);
            if (file_.stations.size() == before)
                lines_.fail(fmt::format("station '{}' stands twice", cells_[k]));
        }
        while (next_row()) {
            drop_empty_end(cells_, 1);
            if (cells_.size() > width)
                lines_.fail(fmt::format("has {} cells, expected {} or fewer", cells_.size(), width));
            const double height = metres * number(cells_[0], "a waterline");
            for (std::size_t k = 1; k < cells_.size(); ++k)
                if (!cells_[k].empty())
                    add(file_.stations[k - 1], {metres * number(cells_[k], "a half breadth"), height});
        }
    }

    void check(const Station& station) const {
        const Outline& half = station.outlines.front().corners;
        if (half.size() < 3)
            throw DataError(
                fmt::format("{}: {} has {} points, expected 3 or more", name_, station.title(), half.size()));
        if (half.front().x() > 0)
            throw DataError(
                fmt::format("{}: {} begins with half breadth {:.6g} m at {:.6g} m, off the centre line: "
                            "expected its keel "
                            "first, half breadth 0 (of a flat bottom at the same waterline)",
                            name_, station.title(), half.front().x(), half.front().y()));
    }

    std::string name_;
    TextLines lines_;
    SectionFile file_;
    char separator_ = 0;
    std::string_view text_;
    std::vector<std::string_view> cells_;
};

}  // namespace

bool looks_like_offsets(std::string_view text) {
    TextLines lines("", text);
    while (lines.next()) {
        const std::string_view line = trimmed(without_comment(lines.line()));
        if (line.empty()) continue;
        const std::vector<std::string_view> cells = cells_of(line, separator_in(line));
        return cells.size() > 2 && is_title(cells.front());
    }
    return false;
}

SectionFile parse_offsets(const std::string& name, std::string_view text) {
    return Reader(name, text).read();
}

}  // namespace wetdeck

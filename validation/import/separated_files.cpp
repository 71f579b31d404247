// SPDX-License-Identifier: BSD-3-Clause
#include "validation/import/separated_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/metrics/column_titles.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {
namespace {

struct Reading {
    const TableFormat& format;
    TitledRows& rows;
    std::size_t first_segment = 0;  ///< of the file

    void titles(const std::vector<std::string_view>& cells, std::size_t time, const TextLines& lines) {
        const std::vector<std::string> found(cells.begin(), cells.end());
        const bool again = rows.segments.size() > first_segment;
        if (again && !format.titles_repeat) lines.fail("a second line of titles, expected numbers");
        if (!rows.titles.empty() && found != rows.titles)
            lines.fail(fmt::format("other titles than before ({} columns, {} before)", found.size(),
                                   rows.titles.size()));
        std::set<std::string> names;
        for (const std::string& title : found)
            if (!names.insert(title).second) lines.fail(fmt::format("two columns are named '{}'", title));
        rows.titles = found;
        rows.time = time;
        rows.segments.emplace_back();
    }

    void numbers(const std::vector<std::string_view>& cells, const TextLines& lines) {
        if (rows.segments.size() == first_segment)
            lines.fail(fmt::format("expected a line of titles first, {}", format.titles));
        if (cells.size() != rows.titles.size())
            lines.fail(fmt::format("holds {} cells, expected {}; a line that ends early is half written",
                                   cells.size(), rows.titles.size()));
        RecordRow row;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const bool missing =
                cells[k].empty() || (format.text_cells && k != rows.time && !number_in(cells[k]));
            row.values.push_back(missing && k != rows.time ? std::numeric_limits<double>::quiet_NaN()
                                                           : record_number(cells[k], lines));
        }
        row.time = row.values[rows.time];
        add_row(rows.segments.back(), std::move(row), lines);
    }
};

void read_file(const std::string& file, const TableFormat& format, TitledRows& rows) {
    const std::string text = record_text(file);
    TextLines lines(file, text);
    Reading reading{format, rows, rows.segments.size()};
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty() || line.front() == '#') continue;
        std::vector<std::string_view> cells = cells_of(line, format.separator(line));
        drop_empty_end(cells, rows.titles.size());
        const std::size_t time = format.time_title(cells);
        if (time < cells.size())
            reading.titles(cells, time, lines);
        else
            reading.numbers(cells, lines);
    }
    if (rows.segments.size() == reading.first_segment || rows.segments.back().rows.empty())
        lines.fail("the file ends without numbers");
}

/// A title with an index, "Pressure[0]", whose brackets are not those of a unit, is named "Pressure_0"; marks
/// that separate columns or begin units in a reference curve become '_'.
RecordColumn column_titled(std::string text) {
    static const std::regex index(R"(\[(\d+)\])");
    text = std::regex_replace(text, index, "_$1");
    const ColumnTitle title = title_in(text);
    RecordColumn column{std::string(title.name), std::string(title.unit), {}, {}, {}};
    const auto separates = [](char c) {
        return std::string_view(",;\"#\t[]").find(c) != std::string_view::npos;
    };
    std::replace_if(column.name.begin(), column.name.end(), separates, '_');
    return column;
}

}  // namespace

TitledRows read_tables(const std::vector<std::string>& files, const TableFormat& format) {
    TitledRows all;
    std::vector<std::pair<double, std::size_t>> begins;  // of the files, and their first segments
    for (const std::string& file : files) {
        const std::size_t first = all.segments.size();
        read_file(file, format, all);
        for (std::size_t k = first; k < all.segments.size(); ++k) {
            RecordSegment& segment = all.segments[k];
            segment.begin =
                segment.rows.empty() ? std::numeric_limits<double>::infinity() : segment.rows.front().time;
        }
        begins.emplace_back(all.segments[first].begin, first);
    }
    std::vector<RecordSegment> ordered;
    std::vector<std::pair<double, std::size_t>> sorted = begins;
    std::stable_sort(sorted.begin(), sorted.end());
    for (std::size_t k = 1; k < sorted.size(); ++k)
        if (sorted[k].first == sorted[k - 1].first)
            throw InputError(
                fmt::format("two of the files start at the time {:.9g}: expected one run, or runs "
                            "that were continued later",
                            sorted[k].first));
    for (const auto& [begin, first] : sorted) {
        std::size_t end = all.segments.size();
        for (const auto& [other, at] : begins)
            if (at > first) end = std::min(end, at);
        for (std::size_t k = first; k < end; ++k)
            if (!all.segments[k].rows.empty()) ordered.push_back(std::move(all.segments[k]));
    }
    all.segments = std::move(ordered);
    return all;
}

void fill_from(CodeRecord& record, TitledRows rows) {
    for (const std::string& text : rows.titles) record.columns.push_back(column_titled(text));
    if (record.time_unit.empty()) record.time_unit = record.columns[rows.time].unit;
    fill(record, joined(rows.segments));
    record.columns.erase(record.columns.begin() + static_cast<std::ptrdiff_t>(rows.time));
    const auto empty = [](const RecordColumn& column) {
        return std::all_of(column.values.begin(), column.values.end(),
                           [](double v) { return std::isnan(v); });
    };
    record.columns.erase(std::remove_if(record.columns.begin(), record.columns.end(), empty),
                         record.columns.end());
}

}  // namespace wetdeck

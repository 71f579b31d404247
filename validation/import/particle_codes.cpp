// SPDX-License-Identifier: BSD-3-Clause
// Readers of DualSPHysics, SPHinXsys, TrixiParticles, and of plain columns.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/import/formats.hpp"
#include "validation/import/separated_files.hpp"
#include "validation/metrics/column_titles.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string lower(std::string_view text) {
    std::string all(text);
    std::transform(all.begin(), all.end(), all.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return all;
}

/// Where the title of the time is among titles, none of which begins as a number.
template <class IsTime>
std::size_t time_among(const std::vector<std::string_view>& cells, IsTime is_time) {
    if (cells.empty() || begins_as_number(cells.front())) return cells.size();
    return static_cast<std::size_t>(std::find_if(cells.begin(), cells.end(), is_time) - cells.begin());
}

std::size_t time_of_dualsphysics(const std::vector<std::string_view>& cells) {
    return time_among(cells, [](std::string_view cell) { return lower(title_in(cell).name) == "time"; });
}

std::size_t time_of_sphinxsys(const std::vector<std::string_view>& cells) {
    const bool titles = !cells.empty() && (cells.front() == "run_time" || cells.front() == "time");
    return titles ? 0 : cells.size();
}

std::size_t time_of_trixiparticles(const std::vector<std::string_view>& cells) {
    return time_among(cells, [](std::string_view cell) { return cell == "time"; });
}

char spaces(std::string_view) {
    return ' ';
}

char comma(std::string_view) {
    return ',';
}

/// The values of series in a file of PostprocessCallback; a null is a value that JSON has no number for.
void add_series(const std::string& file, const std::string& name, const json& series, CodeRecord& record) {
    const auto wrong = [&](const char* what) {
        return DataError(fmt::format("{}:1: series '{}': {}", file, name, what));
    };
    if (!series.contains("values") || !series.contains("time")) throw wrong("expected 'values' and 'time'");
    const json &values = series["values"], &time = series["time"];
    if (!values.is_array() || !time.is_array() || values.size() != time.size())
        throw wrong("expected as many values as times");
    std::vector<double> times;
    for (const json& t : time) {
        if (!t.is_number()) throw wrong("a time is no number");
        times.push_back(t.get<double>());
    }
    if (record.time.empty()) record.time = times;
    if (record.time != times) throw wrong("its times are others than those of the series before");
    RecordColumn column{name, {}, {}, {}, {}};
    for (const json& value : values) {
        if (!value.is_number() && !value.is_null()) {
            record.notes.push_back(fmt::format("series '{}' left out: its values are no numbers", name));
            return;
        }
        column.values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                                : value.get<double>());
    }
    record.columns.push_back(std::move(column));
}

json parsed(const std::string& file, const std::string& text) {
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw DataError(fmt::format("{}:{}: no sound JSON: the file is damaged or half written", file,
                                    1 + std::count(text.begin(), end, '\n')));
    }
}

std::string solver_version(const json& document) {
    const json meta = document.value("meta", json::object());
    const std::string version = meta.is_object() ? meta.value("solver_version", "") : "";
    return version == "UnknownVersion" ? "" : version;
}

/// JSON tells itself whether it is whole.
std::string json_text(const std::string& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) throw InputError(fmt::format("{}: no such file", file));
    return read_whole_file(file);
}

CodeRecord read_json(const std::string& file) {
    CodeRecord record;
    const std::string text = json_text(file);
    const json document = parsed(file, text);
    if (!document.is_object()) throw DataError(fmt::format("{}:1: expected a JSON object of series", file));
    record.version = solver_version(document);
    for (const auto& [name, series] : document.items())
        if (series.is_object() && series.value("type", "") == "series")
            add_series(file, name, series, record);
    if (record.time.empty()) throw DataError(fmt::format("{}:1: holds no series", file));
    for (std::size_t k = 1; k < record.time.size(); ++k)
        if (!(record.time[k] > record.time[k - 1]))
            throw DataError(fmt::format("{}:1: the times do not rise at value {}", file, k + 1));
    return record;
}

std::string version_in_json_beside(const std::string& file) {
    const fs::path beside = fs::path(file).replace_extension(".json");
    std::error_code error;
    if (!fs::is_regular_file(beside, error)) return {};
    return solver_version(parsed(beside.string(), json_text(beside.string())));
}

/// The lines of a file without titles get the names column_1, column_2, ...
TitledRows untitled(const std::string& file) {
    const std::string text = record_text(file);
    TextLines lines(file, text);
    TitledRows rows;
    rows.segments.emplace_back();
    while (lines.next()) {
        const std::string_view line = trimmed(without_comment(lines.line()));
        if (line.empty()) continue;
        std::vector<std::string_view> cells = cells_of(line, separator_in(line));
        drop_empty_end(cells, rows.titles.size());
        if (rows.titles.empty())
            for (std::size_t k = 1; k <= cells.size(); ++k)
                rows.titles.push_back(fmt::format("column_{}", k));
        if (cells.size() != rows.titles.size())
            lines.fail(fmt::format("holds {} numbers, expected {}", cells.size(), rows.titles.size()));
        RecordRow row;
        for (const std::string_view cell : cells)
            row.values.push_back(cell.empty() ? std::numeric_limits<double>::quiet_NaN()
                                              : record_number(cell, lines));
        row.time = row.values.front();
        add_row(rows.segments.back(), std::move(row), lines);
    }
    if (rows.segments.back().rows.empty()) lines.fail("the file ends without numbers");
    return rows;
}

bool has_titles(const std::string& file) {
    const std::string text = record_text(file);
    TextLines lines(file, text);
    while (lines.next()) {
        const std::string_view line = trimmed(without_comment(lines.line()));
        if (!line.empty()) return !begins_as_number(line.front() == '"' ? line.substr(1) : line);
    }
    return false;
}

}  // namespace

CodeRecord read_dualsphysics(const std::vector<std::string>& paths) {
    CodeRecord record;
    record.code = "DualSPHysics";
    record.files = paths;
    TableFormat format{separator_in, time_of_dualsphysics, false, true,
                       "'time [s];...' with ';' or ',' between them"};
    fill_from(record, read_tables(paths, format));
    record.version =
        word_behind((fs::path(paths.front()).parent_path() / "Run.out").string(), "DualSPHysics");
    if (!record.version.starts_with('v')) record.version.clear();
    return record;
}

CodeRecord read_sphinxsys(const std::vector<std::string>& paths) {
    CodeRecord record;
    record.code = "SPHinXsys";
    record.files = paths;
    TableFormat format{spaces, time_of_sphinxsys, true, false, "that begins with run_time"};
    fill_from(record, read_tables(paths, format));
    return record;
}

CodeRecord read_trixiparticles(const std::vector<std::string>& paths) {
    CodeRecord record;
    if (paths.size() == 1 && fs::path(paths.front()).extension() == ".json") {
        record = read_json(paths.front());
    } else {
        TableFormat format{comma, time_of_trixiparticles, false, true, "with a column named time"};
        fill_from(record, read_tables(paths, format));
        record.version = version_in_json_beside(paths.front());
    }
    record.code = "TrixiParticles.jl";
    record.files = paths;
    return record;
}

CodeRecord read_plain(const std::vector<std::string>& paths) {
    if (paths.size() != 1) throw InputError("plain: expected one file");
    CodeRecord record;
    record.files = paths;
    TableFormat format{[](std::string_view line) {
                           return line.find('\t') != std::string_view::npos ? '\t' : separator_in(line);
                       },
                       [](const std::vector<std::string_view>& cells) {
                           const bool numbers = cells.empty() || begins_as_number(cells.front());
                           return numbers ? cells.size() : std::size_t{0};
                       },
                       false, false, ""};
    fill_from(record, has_titles(paths.front()) ? read_tables(paths, format) : untitled(paths.front()));
    return record;
}

}  // namespace wetdeck

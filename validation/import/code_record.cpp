// SPDX-License-Identifier: BSD-3-Clause
#include "validation/import/code_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "solver/core/errors.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr double missing_from = 1e37;  // -3.4e38 (DualSPHysics), -1e300 (OpenFOAM)
constexpr std::uintmax_t largest_file = 200'000'000;
constexpr int lines_of_head = 60;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Mean of the values that are there.
std::vector<double> mean_of(const std::vector<RecordRow>& rows) {
    std::vector<double> mean(rows.front().values.size(), 0);
    for (std::size_t k = 0; k < mean.size(); ++k) {
        std::size_t count = 0;
        for (const RecordRow& row : rows) {
            if (std::isnan(row.values[k])) continue;
            mean[k] += row.values[k];
            ++count;
        }
        mean[k] = count > 0 ? mean[k] / static_cast<double>(count) : none;
    }
    return mean;
}

}  // namespace

JoinedRows joined(const std::vector<RecordSegment>& segments) {
    JoinedRows all;
    std::vector<RecordRow> kept;
    for (const RecordSegment& segment : segments) {
        const double first = segment.rows.empty() ? segment.begin : segment.rows.front().time;
        const auto end = std::remove_if(kept.begin(), kept.end(), [&](const RecordRow& row) {
            return row.time > segment.begin || (!segment.rows.empty() && row.time >= first);
        });
        all.superseded += static_cast<std::size_t>(kept.end() - end);
        kept.erase(end, kept.end());
        kept.insert(kept.end(), segment.rows.begin(), segment.rows.end());
    }
    for (std::size_t begin = 0, end = 0; begin < kept.size(); begin = end) {
        while (end < kept.size() && kept[end].time == kept[begin].time) ++end;
        const auto at = [&kept](std::size_t k) { return kept.begin() + static_cast<std::ptrdiff_t>(k); };
        all.rows.push_back({kept[begin].time, mean_of({at(begin), at(end)})});
        all.merged += end - begin - 1;
    }
    return all;
}

std::vector<std::string> notes_on(const JoinedRows& rows) {
    std::vector<std::string> notes;
    if (rows.superseded > 0)
        notes.push_back(fmt::format("{} rows of an earlier run dropped, which a later start computed again",
                                    rows.superseded));
    if (rows.merged > 0)
        notes.push_back(fmt::format("{} rows of a repeated time merged into means", rows.merged));
    return notes;
}

void fill(CodeRecord& record, const JoinedRows& rows) {
    for (const RecordRow& row : rows.rows) {
        record.time.push_back(row.time);
        for (std::size_t k = 0; k < record.columns.size(); ++k)
            record.columns[k].values.push_back(row.values[k]);
    }
    for (std::string& note : notes_on(rows)) record.notes.push_back(std::move(note));
}

double record_number(std::string_view cell, const TextLines& lines) {
    const std::optional<double> number = number_in(cell);
    if (!number) {
        const std::string hint = reading_hint(cell);
        lines.fail(fmt::format("'{}' is no number{}", cell, hint));
    }
    return std::isfinite(*number) && std::abs(*number) < missing_from ? *number : none;
}

void add_row(RecordSegment& segment, RecordRow row, const TextLines& lines) {
    if (std::isnan(row.time)) lines.fail("the time is no finite number");
    if (!segment.rows.empty() && row.time < segment.rows.back().time)
        lines.fail(fmt::format("time {:.9g} after {:.9g}: the time goes back, expected rising times",
                               row.time, segment.rows.back().time));
    segment.rows.push_back(std::move(row));
}

std::string record_text(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        throw InputError(fmt::format("{}: no such file", file));
    if (std::filesystem::file_size(file, error) > largest_file)
        throw DataError(fmt::format("{}: larger than {} bytes", file, largest_file));
    std::string text = read_whole_file(file);
    if (text.empty()) throw DataError(fmt::format("{}:1: the file is empty", file));
    if (text.back() != '\n')
        throw DataError(
            fmt::format("{}:{}: the last line has no end: the file is half written; wait for the end of the "
                        "run, or end or remove that line",
                        file, 1 + std::count(text.begin(), text.end(), '\n')));
    return text;
}

std::string word_behind(const std::string& file, std::string_view marker) {
    std::ifstream stream(file);
    std::string line;
    for (int k = 0; k < lines_of_head && std::getline(stream, line); ++k) {
        const std::size_t at = line.find(marker);
        if (at == std::string::npos) continue;
        const std::vector<std::string_view> words =
            cells_of(std::string_view(line).substr(at + marker.size()), ' ');
        if (!words.empty()) return std::string(words.front());
    }
    return {};
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// What the files of another code hold: columns over time, and what the files say of themselves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wetdeck {

class TextLines;

/// One column of a record.
struct RecordColumn {
    std::string name;
    std::string unit;            ///< as the format has it; empty: the files do not say
    std::string sensor;          ///< where it was taken, or empty
    std::string sign;            ///< positive direction, where the format defines it, or empty
    std::vector<double> values;  ///< in `unit`; NaN where there is none
};

/// The record of one computation of another code.
struct CodeRecord {
    std::string code;                   ///< its name; empty: the files do not say
    std::string version;                ///< empty: the files do not say
    std::string phase;                  ///< "water" or "two-phase"; empty: the files do not say
    std::string time_unit;              ///< empty: the files do not say
    std::optional<double> layer;        ///< thickness of the computed layer [m]
    std::vector<std::string> files;     ///< read, in the order in which they count
    std::vector<std::string> notes;     ///< what was merged, dropped or missing
    std::vector<double> time;           ///< strictly increasing, in `time_unit`
    std::vector<RecordColumn> columns;  ///< as long as `time`
};

/// One row of a file.
struct RecordRow {
    double time = 0;
    std::vector<double> values;  ///< NaN: none
};

/// Rows that one run wrote without being started again.
struct RecordSegment {
    double begin = 0;             ///< when the run started: no row of an earlier run counts after it
    std::vector<RecordRow> rows;  ///< their times never fall
};

struct JoinedRows {
    std::vector<RecordRow> rows;  ///< their times rise
    std::size_t superseded = 0;   ///< rows of an earlier run that a later one computed again
    std::size_t merged = 0;       ///< rows with the time of their neighbour
};

/// The runs in one: rows of earlier segments after the start of a later one are dropped, rows of one time
/// become their mean (a code that writes few digits repeats the time of short steps).
JoinedRows joined(const std::vector<RecordSegment>& segments);

/// What was dropped and merged in words, one note each; nothing where nothing was.
std::vector<std::string> notes_on(const JoinedRows& rows);

/// Time and columns of a record from rows; the columns must have their titles.
void fill(CodeRecord& record, const JoinedRows& rows);

/// A number of a line. Throws DataError "FILE:LINE: ..." for a cell that is none. Magnitudes beyond 1e37,
/// which stand for missing values, and values that are not finite become NaN.
double record_number(std::string_view cell, const TextLines& lines);

/// Adds a row. Throws DataError "FILE:LINE: ..." where the time is no number or goes back.
void add_row(RecordSegment& segment, RecordRow row, const TextLines& lines);

/// The text of a file of at most 200 MB. Throws InputError where there is none, and DataError "FILE:LINE:"
/// where its last line has no end: it is half written.
std::string record_text(const std::string& file);

/// The word behind `marker` in one of the first lines of a file, or nothing.
std::string word_behind(const std::string& file, std::string_view marker);

}  // namespace wetdeck

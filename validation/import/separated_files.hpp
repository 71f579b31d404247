// SPDX-License-Identifier: BSD-3-Clause
// What the readers of tables with one line of titles have in common.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "validation/import/code_record.hpp"

namespace wetdeck {

/// The titles of a table and its runs.
struct TitledRows {
    std::vector<std::string> titles;  ///< of all cells of a line
    std::size_t time = 0;             ///< which of them is the time
    std::vector<RecordSegment> segments;
};

/// How the tables of a code are written.
struct TableFormat {
    /// The separator of a line.
    char (*separator)(std::string_view line);
    /// Which cell of a line of titles is the time; the number of cells for a line that is none.
    std::size_t (*time_title)(const std::vector<std::string_view>& cells);
    bool titles_repeat = false;  ///< each further line of titles starts a run
    bool text_cells = false;     ///< cells that are no numbers count as missing
    const char* titles;          ///< in words, for messages
};

/// Reads several files of one format, which must have the same titles, in the order of their first times.
TitledRows read_tables(const std::vector<std::string>& files, const TableFormat& format);

/// Columns for all titles but the time; units in brackets are taken, the others are empty. Columns without
/// any number are left out.
void fill_from(CodeRecord& record, TitledRows rows);

}  // namespace wetdeck

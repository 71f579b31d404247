// SPDX-License-Identifier: BSD-3-Clause
// The line of column names of a reference file: "t [s],p [Pa]".
#pragma once

#include <string_view>
#include <vector>

namespace wetdeck {

/// "name [unit]" in its parts; a cell of another form has no unit.
struct ColumnTitle {
    std::string_view name, unit;
    bool has_unit = false;
};

ColumnTitle title_in(std::string_view cell);

std::vector<std::string_view> titles_of(std::string_view line, char separator);

/// The separator that leaves one unit to each cell: "t [s];p, filtered [Pa]" has two columns.
char separator_of_titles(std::string_view line);

/// Whether all cells have units and the columns are not those of an outline: two lengths, or x and y.
bool has_titles_of_curves(std::string_view line);

}  // namespace wetdeck

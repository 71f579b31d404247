// SPDX-License-Identifier: BSD-3-Clause
// Small tables of numbers that scenes take from files: one line of titles, "t [s], y [mm]", then numbers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wetdeck {

/// One column of a file, in SI units.
struct NumberColumn {
    std::string name;
    std::string unit;            ///< as the title says in brackets, or empty: SI units
    std::vector<double> values;  ///< [SI]
};

/// The columns of a text: titles first, with units in brackets; lines of as many finite numbers, between
/// commas, semicolons, tabs or spaces; comments from '#' on. Throws DataError "NAME:LINE: what was expected".
std::vector<NumberColumn> parse_columns(const std::string& name, const std::string& text);
/// The same of a file. Throws InputError where there is none.
std::vector<NumberColumn> read_columns(const std::filesystem::path& file);

}  // namespace wetdeck

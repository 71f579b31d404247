// SPDX-License-Identifier: BSD-3-Clause
// Reference curves: the CSV files of reference_data/ and those of users. The format is described in
// reference_data/README.md; a file that does not follow it is refused, never repaired.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/core/curve.hpp"
#include "validation/metrics/reference_kind.hpp"
#include "validation/metrics/standard_uncertainty.hpp"

namespace wetdeck {

/// One column of a reference file.
struct Column {
    std::string name;
    std::string unit;            ///< SI, or "-" for a value that is scaled already
    std::string given_unit;      ///< as the file has it
    std::vector<double> values;  ///< in `unit`; NaN where the cell is empty
    std::size_t empty_cells = 0;
};

/// One reference file. The first column is strictly increasing and has no empty cell.
struct Reference {
    ReferenceKind kind = ReferenceKind::stated;
    std::string citation;
    std::optional<StandardUncertainty> u_data;          ///< stated; empty if unknown
    std::optional<StandardUncertainty> u_data_assumed;  ///< by judgement, where nobody states it
    std::optional<double> u_abscissa;  ///< standard, along the first column, in its unit; empty if unknown
    std::map<std::string, std::string> keys;  ///< the whole header, the above included
    std::vector<Column> columns;
    std::string hash;  ///< of the bytes of the file, "fnv1a64:" and 16 hexadecimal digits
    std::filesystem::path path;
};

/// Reads and checks a reference file of at most 20 MB. Throws DataError, "file:line: what was found, what was
/// expected", and EnvironmentError if the file may not be read.
Reference load_reference(const std::filesystem::path& path);

/// The same for a text in that format; `name` replaces the path in messages.
Reference parse_reference(const std::string& name, std::string_view text);

/// Keys of the header that the file lacks and that a reader of the report would want: where the numbers come
/// from, and how they were measured.
std::vector<std::string> missing_recommended_keys(const Reference& reference);

/// Whether a text means to be a reference file, sound or not: it has a key of the header, or names of columns
/// with units that an outline does not have (another number of columns than two, or no lengths).
bool looks_like_reference(std::string_view text);

/// The same hash without reading further; empty if there is no such file.
std::string file_hash(const std::filesystem::path& path);

/// The column of that name; throws DataError that lists the columns of the file.
const Column& find_column(const Reference& reference, const std::string& name);

/// y over x. Rows whose x or y cell is empty are dropped; `Column::empty_cells` tells how many a column has.
/// Throws DataError if a column is missing, if x is not strictly increasing or if no row is left.
Curve column_curve(const Reference& reference, const std::string& x_column, const std::string& y_column);

}  // namespace wetdeck

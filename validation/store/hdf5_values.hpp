// SPDX-License-Identifier: BSD-3-Clause
// Values in HDF5 files: scalar attributes (double, unsigned, UTF-8 text) and arrays of doubles with one or
// two dimensions. Reading checks type and shape first and throws DataError that names the place.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "validation/store/hdf5_file.hpp"

namespace wetdeck::hdf5 {

void write_attribute(const Node& node, const std::string& name, double value);
void write_attribute(const Node& node, const std::string& name, std::uint64_t value);
/// Variable-length UTF-8; the text itself lies outside the 64 KiB that HDF5 grants an attribute. A NUL ends
/// it.
void write_attribute(const Node& node, const std::string& name, const std::string& value);

double read_double(const Node& node, const std::string& name);
std::uint64_t read_unsigned(const Node& node, const std::string& name);
std::string read_text(const Node& node, const std::string& name);
bool is_text(const Node& node, const std::string& attribute);

enum class Packing {
    deflated,  ///< shuffled and deflated if it is long enough to gain
    plain,
};

/// A new dataset. `columns` = 0 makes it one-dimensional.
Node write_array(const Node& parent, const std::string& name, std::span<const double> values,
                 std::size_t columns = 0, Packing packing = Packing::deflated);

/// Makes `scale` the coordinates of one dimension of `dataset`, as readers of netCDF look for them.
void attach_scale(const Node& dataset, unsigned dimension, const Node& scale, const std::string& name);

struct Array {
    std::vector<hsize_t> shape;  ///< one or two extents
    std::vector<double> values;  ///< row-major
};
Array read_array(const Node& parent, const std::string& name);

/// An empty two-dimensional dataset in a file, which grows by rows; uncompressed, so that flushes leave no
/// holes. Rows that were never written read as NaN.
Node create_table(const Node& file, const std::string& name, std::size_t columns, std::size_t rows_per_chunk);
/// Adds whole rows behind the `rows` that the table has.
void append_rows(const Node& table, std::size_t rows, std::size_t columns, std::span<const double> values);

}  // namespace wetdeck::hdf5

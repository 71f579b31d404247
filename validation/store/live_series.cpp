// SPDX-License-Identifier: BSD-3-Clause
// The growing table of scalar series: default file format and a flush per block, the combination that was
// readable after a kill.
#include "validation/store/live_series.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/hdf5_values.hpp"

namespace wetdeck {
namespace {

struct LiveTable {
    std::vector<LiveColumn> columns;
    std::vector<double> values;  ///< row-major: the time, then the columns

    std::size_t width() const { return columns.size() + 1; }
    std::size_t rows() const { return values.size() / width(); }
    double time(std::size_t row) const { return values[row * width()]; }
};

std::vector<LiveColumn> read_columns(const hdf5::Node& file) {
    const hdf5::Node group = open_group(file, "columns");
    const std::vector<std::string> names = link_names(group);
    std::vector<LiveColumn> columns(names.size());
    for (const std::string& name : names) {
        const hdf5::Node column = open_group(group, name);
        const std::uint64_t index = read_unsigned(column, "index");
        if (index >= columns.size() || !columns[index].name.empty()) {
            throw DataError(column.place() + ": index out of range or given twice");
        }
        columns[index] = {name, read_text(column, "unit"), read_text(column, "description")};
    }
    return columns;
}

LiveTable read_table(const std::filesystem::path& path) {
    const hdf5::Node file = hdf5::open_file(path, hdf5::Access::read);
    hdf5::Array rows = read_array(file, "rows");
    LiveTable table{read_columns(file), std::move(rows.values)};
    if (rows.shape.size() != 2 || rows.shape[1] != table.width()) {
        throw DataError(path.string() + " /rows: expected the time and " +
                        std::to_string(table.columns.size()) + " columns");
    }
    // A kill inside a flush can leave the table longer than its data: rows of the fill value, NaN.
    std::size_t whole = 0;
    while (whole < table.rows() && !std::isnan(table.time(whole)) &&
           (whole == 0 || table.time(whole) > table.time(whole - 1)))
        ++whole;
    table.values.resize(whole * table.width());
    return table;
}

}  // namespace

std::filesystem::path live_file(const std::filesystem::path& run_dir) {
    return run_dir / "live.h5";
}

LiveSeries::LiveSeries(const std::filesystem::path& run_dir, std::vector<LiveColumn> columns,
                       std::size_t rows_per_flush)
    : columns_(std::move(columns)), rows_per_flush_(std::max<std::size_t>(rows_per_flush, 1)) {
    const std::filesystem::path path = live_file(run_dir);
    // A new file rather than the old one reopened: a kill may have damaged it.
    create(temporary_name(path));
    if (::rename(temporary_name(path).c_str(), path.c_str()) != 0) {
        throw environment_error(path, "replace", errno);
    }
}

void LiveSeries::create(const std::filesystem::path& path) {
    file_ = hdf5::create_file(path);
    const hdf5::Node group = create_group(*file_, "columns");
    for (std::size_t index = 0; index < columns_.size(); ++index) {
        const hdf5::Node column = create_group(group, columns_[index].name);
        write_attribute(column, "index", std::uint64_t{index});
        write_attribute(column, "unit", columns_[index].unit);
        write_attribute(column, "description", columns_[index].description);
    }
    table_ = create_table(*file_, "rows", columns_.size() + 1, rows_per_flush_);
    flush();
}

LiveSeries::~LiveSeries() {
    try {
        flush();
    } catch (const std::exception&) {  // nothing is left to be done: the rows before are safe
    }
}

void LiveSeries::append(double time, std::span<const double> values) {
    if (values.size() != columns_.size()) {
        throw DataError("live series: " + std::to_string(values.size()) + " values for " +
                        std::to_string(columns_.size()) + " columns");
    }
    buffer_.push_back(time);
    buffer_.insert(buffer_.end(), values.begin(), values.end());
    if (buffer_.size() >= rows_per_flush_ * (columns_.size() + 1)) flush();
}

void LiveSeries::flush() {
    if (!file_) return;
    try {
        const std::size_t width = columns_.size() + 1;
        if (!buffer_.empty()) append_rows(*table_, rows_, width, buffer_);
        rows_ += buffer_.size() / width;
        buffer_.clear();
        hdf5::check(H5Fflush(file_->id(), H5F_SCOPE_GLOBAL), file_->place(), "cannot write");
    } catch (const EnvironmentError&) {
        table_.reset();
        file_.reset();
        throw;
    }
}

std::map<std::string, Series> read_live(const std::filesystem::path& run_dir) {
    const LiveTable table = read_table(live_file(run_dir));
    std::map<std::string, Series> all;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        Series series{table.columns[column].unit, table.columns[column].description, {}, {}, {}};
        for (std::size_t row = 0; row < table.rows(); ++row) {
            series.time.push_back(table.time(row));
            series.value.push_back(table.values[row * table.width() + column + 1]);
        }
        all[table.columns[column].name] = std::move(series);
    }
    return all;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The series of a run in progress, DIR/live.h5: they can be read while the run goes on and after a kill.
// One table /rows: time [s], then one column per series. The file can be read while it grows.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "validation/store/hdf5_file.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

struct LiveColumn {
    std::string name;
    std::string unit;
    std::string description;
};

/// DIR/live.h5; to be removed once run.h5 is in place.
std::filesystem::path live_file(const std::filesystem::path& run_dir);

/// Appends rows to DIR/live.h5. All members throw EnvironmentError if the machine refuses; nothing more is
/// written after that.
class LiveSeries {
  public:
    /// Starts the file anew. The rows of an earlier process come from the checkpoint.
    LiveSeries(const std::filesystem::path& run_dir, std::vector<LiveColumn> columns,
               std::size_t rows_per_flush = 64);
    ~LiveSeries();
    LiveSeries(const LiveSeries&) = delete;
    LiveSeries& operator=(const LiveSeries&) = delete;

    /// One value per column. The row is on disk after at most `rows_per_flush` calls.
    void append(double time, std::span<const double> values);
    void flush();

  private:
    void create(const std::filesystem::path& path);

    std::vector<LiveColumn> columns_;
    std::size_t rows_per_flush_;
    std::size_t rows_ = 0;        ///< in the table
    std::vector<double> buffer_;  ///< rows to come
    std::optional<hdf5::Node> file_;
    std::optional<hdf5::Node> table_;
};

/// The series of DIR/live.h5, by name, up to the last row that is whole on disk. Throws DataError if there is
/// none or it cannot be read.
std::map<std::string, Series> read_live(const std::filesystem::path& run_dir);

}  // namespace wetdeck

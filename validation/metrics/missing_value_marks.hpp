// SPDX-License-Identifier: BSD-3-Clause
// Numbers of nines, 999, -9999.0 and their like, which measuring programs write where they have no value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "validation/metrics/reference.hpp"

namespace wetdeck {

/// Such numbers of one reference file.
class MissingValueMarks {
  public:
    /// Notes a cell if it is such a number.
    void see(std::string_view cell, std::size_t column, std::size_t row, std::size_t line);

    /// Throws DataError "FILE:LINE: ..." for a mark more than twenty times as large as all other values of
    /// its column.
    void check(const Reference& reference) const;

  private:
    struct Mark {
        std::size_t column, row, line;
        std::string text;
    };
    std::vector<Mark> marks_;
};

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/column_titles.hpp"

#include <algorithm>
#include <string>

#include "validation/metrics/units.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {

ColumnTitle title_in(std::string_view cell) {
    const std::size_t open = cell.find('[');
    if (open == std::string_view::npos || cell.back() != ']') return {cell, {}, false};
    return {trimmed(cell.substr(0, open)), trimmed(cell.substr(open + 1, cell.size() - open - 2)), true};
}

std::vector<std::string_view> titles_of(std::string_view line, char separator) {
    std::vector<std::string_view> cells = cells_of(line, separator);
    drop_empty_end(cells, 1);
    return cells;
}

char separator_of_titles(std::string_view line) {
    for (const char separator : {',', ';', '\t'}) {
        const std::vector<std::string_view> cells = titles_of(line, separator);
        const bool all = std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
            return title_in(cell).has_unit && std::count(cell.begin(), cell.end(), '[') == 1;
        });
        if (all && (cells.size() > 1 || trimmed(line).find_first_of(",;\t") == std::string_view::npos))
            return separator;
    }
    if (line.find(';') != std::string_view::npos) return ';';
    return line.find(',') != std::string_view::npos || line.find('\t') == std::string_view::npos ? ',' : '\t';
}

bool has_titles_of_curves(std::string_view line) {
    const std::vector<std::string_view> cells = titles_of(line, separator_of_titles(line));
    const auto is_title = [](std::string_view cell) { return title_in(cell).has_unit; };
    if (!std::all_of(cells.begin(), cells.end(), is_title)) return false;
    const auto is_place = [](std::string_view cell) {
        return title_in(cell).name == "x" || title_in(cell).name == "y";
    };
    if (cells.size() == 2 && std::all_of(cells.begin(), cells.end(), is_place)) return false;
    const auto in_length = [](std::string_view cell) { return is_length(std::string(title_in(cell).unit)); };
    return cells.size() != 2 || !std::all_of(cells.begin(), cells.end(), in_length);
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Reading and checking of reference files.
#include "validation/metrics/reference.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "solver/core/errors.hpp"
#include "validation/store/hash.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr std::uintmax_t largest_file = 20'000'000;
constexpr std::array origins{"tabulated", "digitised", "computed", "stated"};
constexpr std::array units{"-",   "m",     "s",   "Pa",    "N",  "N/m",  "N s/m", "J/m",
                           "m/s", "m/s^2", "rad", "rad/s", "Hz", "kg/m", "kg/m^3"};
constexpr std::array required_keys{
    "kind",   "citation",      "doi",    "figure", "obtained", "obtained_from", "date", "digitisation_error",
    "u_data", "u_data_source", "sensor", "filter", "sign",     "time_origin",   "note"};

template <typename List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;
         line.remove_prefix(comma + 1)) {
        cells.push_back(trim(line.substr(0, comma)));
    }
    cells.push_back(trim(line));
    return cells;
}

bool is_utf8(std::string_view text) {
    try {
        static_cast<void>(nlohmann::json(text).dump());  // the header ends up in summary.json
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

bool is_date(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    return std::count_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }) == 8;
}

std::string hash_of(std::string_view bytes) {
    return fmt::format("fnv1a64:{:016x}", fnv1a(bytes));
}

std::string file_text(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw DataError(fmt::format("{}: no such file", path.string()));
    if (!std::filesystem::is_regular_file(status)) {
        throw DataError(fmt::format("{}: not a regular file, expected a reference CSV", path.string()));
    }
    const auto size = std::filesystem::file_size(path, error);
    if (!error && size > largest_file) {
        throw DataError(
            fmt::format("{}: {} bytes, a reference file may have {}", path.string(), size, largest_file));
    }
    return read_whole_file(path);
}

/// Reads the lines of one file; every error names the file and the line.
class Reader {
  public:
    Reader(const std::filesystem::path& path, std::string_view text) : rest_(text) {
        reference_.path = path;
        reference_.hash = hash_of(text);
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // byte order mark of spreadsheets
    }

    Reference read() {
        while (next_line()) {
            if (line_.empty()) continue;
            if (line_.front() == '#' && reference_.columns.empty()) {
                read_key();
            } else if (reference_.columns.empty()) {
                check_keys();
                read_column_names();
            } else {
                read_row();
            }
        }
        if (reference_.columns.empty()) check_keys();
        if (reference_.columns.empty()) fail("no column names, expected a line such as 'T [-],p_star [-]'");
        if (reference_.columns.front().values.empty()) fail("no rows after the column names");
        return std::move(reference_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw DataError(fmt::format("{}:{}: {}", reference_.path.string(), line_number_, what));
    }

    bool next_line() {
        if (rest_.empty()) return false;
        ++line_number_;
        const auto end = rest_.find('\n');
        line_ = trim(rest_.substr(0, end));
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        return true;
    }

    void read_key() {
        const auto colon = line_.find(':');
        if (colon == std::string_view::npos) fail("a header line without a key, expected '# key: value'");
        const std::string key{trim(line_.substr(1, colon - 1))};
        const std::string value{trim(line_.substr(colon + 1))};
        if (!is_utf8(line_)) fail("not UTF-8 text");
        if (value.empty()) fail(fmt::format("key '{}' has no value", key));
        if (!reference_.keys.emplace(key, value).second) fail(fmt::format("key '{}' is given twice", key));
        if (key == "kind") check_word(key, value, reference_kind_names());
        if (key == "obtained") check_word(key, value, origins);
        if (key == "date" && !is_date(value)) fail(fmt::format("date is '{}', expected YYYY-MM-DD", value));
        if (key == "u_data" && value != "unknown") {
            reference_.u_data = number(value, "u_data");
            if (*reference_.u_data < 0)
                fail("u_data is negative, expected a relative uncertainty or unknown");
        }
    }

    template <typename List>
    void check_word(const std::string& key, const std::string& value, const List& words) const {
        if (contains(words, value)) return;
        fail(fmt::format("{} is '{}', expected {}", key, value, fmt::join(words, ", ")));
    }

    void check_keys() {
        std::vector<const char*> missing;
        for (const char* key : required_keys) {
            if (!reference_.keys.contains(key)) missing.push_back(key);
        }
        if (!missing.empty())
            fail(fmt::format("missing key{} '{}', expected '# {}: ...'", missing.size() > 1 ? "s" : "",
                             fmt::join(missing, "', '"), missing.front()));
        reference_.kind = *reference_kind_named(reference_.keys.at("kind"));
        reference_.citation = reference_.keys.at("citation");
    }

    void read_column_names() {
        if (!is_utf8(line_)) fail("not UTF-8 text");
        for (const std::string_view cell : split(line_)) {
            const auto open = cell.find('[');
            if (open == std::string_view::npos || cell.back() != ']') {
                fail(fmt::format("column '{}' has no unit, expected 'name [unit]'", cell));
            }
            Column column;
            column.name = trim(cell.substr(0, open));
            column.unit = trim(cell.substr(open + 1, cell.size() - open - 2));
            if (column.name.empty())
                fail(fmt::format("column '{}' has no name, expected 'name [unit]'", cell));
            if (!contains(units, column.unit)) {
                fail(fmt::format("column '{}' has the unknown unit '{}', expected one of {}", column.name,
                                 column.unit, fmt::join(units, ", ")));
            }
            for (const Column& other : reference_.columns) {
                if (other.name == column.name) fail(fmt::format("column '{}' is given twice", column.name));
            }
            reference_.columns.push_back(std::move(column));
        }
    }

    void read_row() {
        const auto cells = split(line_);
        auto& columns = reference_.columns;
        if (cells.size() != columns.size()) {
            fail(fmt::format("{} cells, expected {}", cells.size(), columns.size()));
        }
        if (cells.front().empty()) fail(fmt::format("the abscissa '{}' is empty", columns.front().name));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i].empty()) {
                ++columns[i].empty_cells;
                columns[i].values.push_back(std::numeric_limits<double>::quiet_NaN());
            } else {
                columns[i].values.push_back(number(cells[i], columns[i].name));
            }
        }
        const auto& x = columns.front().values;
        if (x.size() > 1 && x.back() <= x[x.size() - 2]) {
            fail(fmt::format("{} is {} after {}, expected a strictly increasing abscissa",
                             columns.front().name, x.back(), x[x.size() - 2]));
        }
    }

    double number(std::string_view cell, std::string_view name) const {
        double value = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc{} || end != cell.data() + cell.size()) {
            fail(fmt::format("{} is '{}', expected a number", name, cell));
        }
        if (!std::isfinite(value)) fail(fmt::format("{} is '{}', expected a finite number", name, cell));
        return value;
    }

    std::string_view rest_;
    std::string_view line_;
    std::size_t line_number_ = 0;
    Reference reference_;
};

}  // namespace

Reference load_reference(const std::filesystem::path& path) {
    const std::string text = file_text(path);
    return Reader(path, text).read();
}

Reference parse_reference(const std::string& name, std::string_view text) {
    return Reader(name, text).read();
}

std::string file_hash(const std::filesystem::path& path) {
    return std::filesystem::is_regular_file(path) ? hash_of(file_text(path)) : std::string();
}

const Column& find_column(const Reference& reference, const std::string& name) {
    std::vector<std::string> names;
    for (const Column& column : reference.columns) {
        if (column.name == name) return column;
        names.push_back(column.name);
    }
    throw DataError(fmt::format("{}: no column '{}', there are {}", reference.path.string(), name,
                                fmt::join(names, ", ")));
}

Curve column_curve(const Reference& reference, const std::string& x_column, const std::string& y_column) {
    const Column& x = find_column(reference, x_column);
    const Column& y = find_column(reference, y_column);
    Curve curve;
    for (std::size_t row = 0; row < x.values.size(); ++row) {
        if (std::isnan(x.values[row]) || std::isnan(y.values[row])) continue;
        if (!curve.x.empty() && x.values[row] <= curve.x.back()) {
            throw DataError(
                fmt::format("{}: column '{}' is not strictly increasing and cannot be an abscissa",
                            reference.path.string(), x_column));
        }
        curve.x.push_back(x.values[row]);
        curve.y.push_back(y.values[row]);
    }
    if (curve.x.empty()) {
        throw DataError(fmt::format("{}: column '{}' has no values", reference.path.string(), y_column));
    }
    return curve;
}

}  // namespace wetdeck

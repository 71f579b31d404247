// SPDX-License-Identifier: BSD-3-Clause
// Reading and checking of reference files.
#include "validation/metrics/reference.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "solver/core/errors.hpp"
#include "validation/metrics/column_titles.hpp"
#include "validation/metrics/missing_value_marks.hpp"
#include "validation/metrics/units.hpp"
#include "validation/store/hash.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr double no_value = 1e300;  // OpenFOAM writes -1e+300 where a probe lies in no cell
constexpr std::uintmax_t largest_file = 20'000'000;
constexpr std::array origins{"tabulated", "digitised", "computed", "stated"};
constexpr std::array required_keys{"kind", "citation", "u_data", "sign", "time_origin"};
constexpr std::array recommended_keys{
    "doi",           "figure", "obtained", "obtained_from", "date", "digitisation_error",
    "u_data_source", "sensor", "filter",   "note"};

/// Those that no remark in a file of corners has.
constexpr std::array telling_keys{"kind", "obtained", "u_data", "digitisation_error", "time_origin"};

template <typename List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Without the separators that spreadsheets add at the end of a line.
std::string_view without_separators_at_end(std::string_view text) {
    const std::size_t last = text.find_last_not_of(",; \t\r");
    return last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
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
    Reader(const std::filesystem::path& path, std::string_view text) : lines_(path.string(), text) {
        reference_.path = path;
        reference_.hash = hash_of(text);
    }

    Reference read() {
        while (lines_.next()) {
            const std::string_view line = trimmed(lines_.line());
            if (line.empty()) continue;
            if (reference_.columns.empty() && unquoted_hash(line)) {
                read_key(line);
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
        marks_.check(reference_);
        check_units();
        return std::move(reference_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

    /// Spreadsheets put quotes around a line that holds a comma.
    static bool unquoted_hash(std::string_view line) {
        return line.starts_with('#') || line.starts_with("\"#");
    }

    void read_key(std::string_view line) {
        if (!is_utf8(line)) fail("not UTF-8 text");
        line = without_separators_at_end(line);
        if (line.starts_with('"')) line = line.substr(1, line.size() - (line.ends_with('"') ? 2 : 1));
        const auto colon = line.find(':');
        if (colon == std::string_view::npos) return;  // a comment
        const std::string key{trimmed(line.substr(1, colon - 1))};
        const std::string value{trimmed(line.substr(colon + 1))};
        if (value.empty()) fail(fmt::format("key '{}' has no value", key));
        if (!reference_.keys.emplace(key, value).second) fail(fmt::format("key '{}' is given twice", key));
        if (key == "kind") check_word(key, value, reference_kind_names());
        if (key == "obtained") check_word(key, value, origins);
        if (key == "date" && !is_date(value)) fail(fmt::format("date is '{}', expected YYYY-MM-DD", value));
        if (key == "u_data" && value != "unknown") reference_.u_data = uncertainty(key, value, " or unknown");
        if (key == "u_data_assumed") reference_.u_data_assumed = uncertainty(key, value, "");
        if (key == "u_abscissa") {
            reference_.u_abscissa = number(value, key);
            if (*reference_.u_abscissa < 0)
                fail("u_abscissa is negative, expected zero or a positive number");
        }
    }

    StandardUncertainty uncertainty(const std::string& key, const std::string& value,
                                    const char* otherwise) const {
        try {
            return uncertainty_in(value);
        } catch (const InputError& error) {
            fail(fmt::format("{} {}{}", key, error.what(), otherwise));
        }
    }

    /// An uncertainty with a unit is that of a column behind the first.
    void check_units() const {
        for (const auto& [key, given] : {std::pair("u_data", reference_.u_data),
                                         std::pair("u_data_assumed", reference_.u_data_assumed)}) {
            if (!given || given->relative()) continue;
            const auto has_unit = [unit = unit_named(given->unit)](const Column& column) {
                return same_dimension(unit_named(column.unit), unit);
            };
            if (std::none_of(reference_.columns.begin() + 1, reference_.columns.end(), has_unit))
                fail(fmt::format("{} is in {}, the unit of no column of values", key, given->unit));
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
        std::string_view line = lines_.line();
        if (!is_utf8(line)) fail("not UTF-8 text");
        const std::size_t last_unit = std::min(line.rfind(']'), line.size());  // '#' may be part of a name
        line = line.substr(0, last_unit + without_comment(line.substr(last_unit)).size());
        separator_ = separator_of_titles(line);
        for (const std::string_view cell : titles_of(line, separator_)) add_column(cell);
    }

    void add_column(std::string_view cell) {
        const ColumnTitle title = title_in(cell);
        if (!title.has_unit) fail(fmt::format("column '{}' has no unit, expected 'name [unit]'", cell));
        if (title.name.empty()) fail(fmt::format("column '{}' has no name, expected 'name [unit]'", cell));
        Column column;
        column.name = title.name;
        column.given_unit = title.unit;
        try {
            const Unit unit = unit_named(column.given_unit);
            column.unit =
                unit.factor == 1 && unit.powers != Powers{} ? column.given_unit : si_name(unit.powers);
            factors_.push_back(unit.factor);
        } catch (const InputError& error) {
            fail(fmt::format("column '{}' has the {}", column.name, error.what()));
        }
        for (const Column& other : reference_.columns) {
            if (other.name == column.name) fail(fmt::format("column '{}' is given twice", column.name));
        }
        reference_.columns.push_back(std::move(column));
    }

    void read_row() {
        std::vector<std::string_view> cells = cells_of(without_comment(lines_.line()), separator_);
        auto& columns = reference_.columns;
        drop_empty_end(cells);
        if (cells.empty()) return;
        if (cells.size() < columns.size()) restore_empty_end(cells);
        if (cells.size() != columns.size()) fail_on_cells(cells);
        if (cells.front().empty()) fail(fmt::format("the abscissa '{}' is empty", columns.front().name));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i].empty()) {
                ++columns[i].empty_cells;
                columns[i].values.push_back(std::numeric_limits<double>::quiet_NaN());
            } else {
                columns[i].values.push_back(factors_[i] * number(cells[i], columns[i].name));
                marks_.see(cells[i], i, columns[i].values.size() - 1, lines_.number());
            }
        }
        const auto& x = columns.front().values;
        if (x.size() > 1 && x.back() <= x[x.size() - 2]) {
            fail(fmt::format("{} is {} after {}, expected a strictly increasing abscissa",
                             columns.front().name, x.back() / factors_[0], x[x.size() - 2] / factors_[0]));
        }
    }

    /// The empty cells of columns, as far as the line has separators for them.
    void restore_empty_end(std::vector<std::string_view>& cells) const {
        const std::size_t written = cells_of(without_comment(lines_.line()), separator_).size();
        cells.resize(std::min(written, reference_.columns.size()));
    }

    [[noreturn]] void fail_on_cells(const std::vector<std::string_view>& cells) const {
        const std::size_t expected = reference_.columns.size();
        std::string hint;
        if (cells.size() == 2 * expected && separator_ == ',')
            hint = ", or decimal commas, which are not read";
        else if (cells.size() == 1)
            hint = fmt::format(" between {}, as in the column names", separator_name(separator_));
        fail(fmt::format("{} cell{}, expected {}{}", cells.size(), cells.size() == 1 ? "" : "s", expected,
                         hint));
    }

    double number(std::string_view cell, std::string_view name) const {
        const std::optional<double> value = number_in(cell);
        if (!value) fail(fmt::format("{} is '{}', expected a number{}", name, cell, reading_hint(cell)));
        if (!std::isfinite(*value)) fail(fmt::format("{} is '{}', expected a finite number", name, cell));
        if (std::abs(*value) >= no_value)
            fail(fmt::format("{} is '{}', which stands for no value in some programs; leave the cell empty",
                             name, cell));
        return *value;
    }

    TextLines lines_;
    Reference reference_;
    char separator_ = ',';
    std::vector<double> factors_;  ///< SI units in one unit of each column
    MissingValueMarks marks_;
};

}  // namespace

Reference load_reference(const std::filesystem::path& path) {
    const std::string text = file_text(path);
    return Reader(path, text).read();
}

Reference parse_reference(const std::string& name, std::string_view text) {
    return Reader(name, text).read();
}

std::vector<std::string> missing_recommended_keys(const Reference& reference) {
    std::vector<std::string> missing;
    for (const char* key : recommended_keys)
        if (!reference.keys.contains(key)) missing.emplace_back(key);
    return missing;
}

bool looks_like_reference(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t hash = line.find_first_not_of("\" ");
        if (line.empty() || hash == std::string_view::npos) continue;
        if (line[hash] != '#') return has_titles_of_curves(line);
        const std::string_view key = trimmed(line.substr(hash + 1, line.find(':') - hash - 1));
        if (line.find(':') != std::string_view::npos && contains(telling_keys, key)) return true;
    }
    return false;
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

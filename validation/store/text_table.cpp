// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

constexpr std::string_view blanks = " \t\r", minus_sign = "\xE2\x88\x92";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Why the text cannot be read as lines of bytes; empty if it can.
std::string encoding_problem(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return "UTF-16 text, expected UTF-8 (save the file as UTF-8 or as plain CSV)";
    if (text.find('\0') != std::string_view::npos)
        return "holds NUL bytes, as UTF-16 text and binary files do, expected UTF-8 text";
    return {};
}

/// Where a carriage return stands that no line feed follows, further carriage returns between them aside.
std::size_t lone_carriage_return(std::string_view text) {
    for (std::size_t at = 0; (at = text.find('\r', at)) != std::string_view::npos;) {
        const std::size_t end = text.find_first_not_of('\r', at);
        if (end == std::string_view::npos) break;
        if (text[end] != '\n') return at;
        at = end;
    }
    return std::string_view::npos;
}

std::string_view unquoted(std::string_view cell) {
    const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
    return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (!(line = trimmed(line)).empty()) {
        const std::size_t end = std::min(line.find_first_of(blanks), line.size());
        words.push_back(unquoted(line.substr(0, end)));
        line.remove_prefix(end);
    }
    return words;
}

}  // namespace

TextLines::TextLines(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    number_ = 1;
    if (const std::string problem = encoding_problem(rest_); !problem.empty()) fail(problem);
    const std::size_t at = lone_carriage_return(rest_);
    if (at != std::string_view::npos) {
        number_ += static_cast<std::size_t>(
            std::count(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
        fail("the line ends with a lone carriage return, expected a line feed, or both");
    }
    number_ = 0;
}

bool TextLines::next() {
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ')) line_.remove_suffix(1);
    while (!line_.empty() && line_.front() == ' ') line_.remove_prefix(1);
    return true;
}

void TextLines::fail(const std::string& what) const {
    throw DataError(fmt::format("{}:{}: {}", name_, number_, what));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_comment(std::string_view line) {
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '"') quoted = !quoted;
        if (line[k] == '#' && !quoted) return line.substr(0, k);
    }
    return line;
}

char separator_in(std::string_view line) {
    for (const char separator : {';', ','})
        if (line.find(separator) != std::string_view::npos) return separator;
    return ' ';
}

std::string separator_name(char separator) {
    if (separator == ' ') return "spaces or tabs";
    return separator == '\t' ? "tabs" : fmt::format("'{}'", separator);
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
    if (separator == ' ') return words_of(line);
    std::vector<std::string_view> cells;
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t k = 0; k <= line.size(); ++k) {
        if (k < line.size() && line[k] == '"') quoted = !quoted;
        if (k < line.size() && (quoted || line[k] != separator)) continue;
        cells.push_back(unquoted(trimmed(line.substr(begin, k - begin))));
        begin = k + 1;
    }
    return cells;
}

void drop_empty_end(std::vector<std::string_view>& cells, std::size_t least) {
    while (cells.size() > least && cells.back().empty()) cells.pop_back();
}

std::optional<double> number_in(std::string_view cell) {
    if (cell.size() > 1 && cell.front() == '+' && cell[1] != '-') cell.remove_prefix(1);
    double value = 0;
    const char* const end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

bool begins_as_number(std::string_view cell) {
    if (cell.starts_with(minus_sign)) return true;
    if (!cell.empty() && (cell.front() == '+' || cell.front() == '-')) cell.remove_prefix(1);
    if (!cell.empty() && cell.front() == '.') cell.remove_prefix(1);
    return !cell.empty() && is_digit(cell.front());
}

std::string reading_hint(std::string_view cell) {
    if (cell.find(minus_sign) != std::string_view::npos)
        return "; its minus sign is that of typesetting, expected '-'";
    for (std::size_t comma = 0; (comma = cell.find(',', comma)) != std::string_view::npos; ++comma) {
        const bool before = comma > 0 && is_digit(cell[comma - 1]);
        const bool behind = comma + 1 < cell.size() && is_digit(cell[comma + 1]);
        if (before || behind) return "; decimal commas are not read, expected a decimal point";
    }
    return {};
}

}  // namespace wetdeck

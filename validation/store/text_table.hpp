// SPDX-License-Identifier: BSD-3-Clause
// Tables of numbers in text files, as measuring computers, spreadsheets and scripts write them: lines that
// end with LF or CR LF, cells between tabs, semicolons, commas or spaces, comments that begin with '#', a
// byte order mark in front. What could be read in two ways is refused.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wetdeck {

/// The lines of a text, one after the other.
class TextLines {
  public:
    /// @param name  of the file, for messages
    /// @param text  must live as long as the object
    /// Throws DataError "NAME:LINE: ..." for UTF-16, for binary data, and for lines that end with a lone
    /// carriage return.
    TextLines(std::string name, std::string_view text);

    /// Goes to the next line; false after the last one.
    bool next();
    /// The line without the spaces around it.
    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; }  ///< of the line, from 1
    /// Throws DataError "NAME:LINE: what".
    [[noreturn]] void fail(const std::string& what) const;

  private:
    std::string name_;
    std::string_view rest_, line_;
    std::size_t number_ = 0;
};

/// The text without spaces, tabs and carriage returns around it.
std::string_view trimmed(std::string_view text);

/// The line without a comment that begins with '#' outside quotes.
std::string_view without_comment(std::string_view line);

/// ';' where the line has one, else ',', else ' ', which stands for spaces and tabs.
char separator_in(std::string_view line);

/// How messages name a separator: "';'", "a tab", "spaces".
std::string separator_name(char separator);

/// The cells of a line, without the spaces and the quotes around each. With ' ' as separator, cells lie
/// between spaces and tabs, and none is empty.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// Drops empty cells at the end down to `least`: spreadsheets end each line with as many separators as the
/// longest one has.
void drop_empty_end(std::vector<std::string_view>& cells, std::size_t least = 0);

/// The number that is the whole cell, with or without a sign; may be infinite or NaN where that is written.
std::optional<double> number_in(std::string_view cell);

/// Whether the cell begins as numbers do: with a digit, a sign or a point and a digit.
bool begins_as_number(std::string_view cell);

/// Why the cell may be no number, to end a message with: a decimal comma, a minus sign of typesetting. Empty
/// where nothing is known.
std::string reading_hint(std::string_view cell);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The smallest parts of the page: escaping, numbers, tables. Every text of a user passes through escape().
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wetdeck::report {

/// HTML text or attribute value: & < > " ' become entities, control characters other than newline become
/// spaces.
std::string escape(std::string_view text);

/// JavaScript for the inside of a <script> element: `</script` becomes `<\/script`, `<!--` becomes `\x3c!--`.
std::string escape_script(std::string_view code);

/// JSON for the inside of a <script> element: every `<` becomes \u003c.
std::string escape_json(std::string json);

std::string base64(std::span<const unsigned char> bytes);
std::string base64(std::string_view bytes);

/// `data:` address of these bytes. A picture loaded through it cannot run scripts, whatever it holds.
std::string data_address(std::string_view media_type, std::string_view bytes);

/// The same for an SVG text inside a double-quoted attribute, percent-encoded, line ends as spaces: a
/// quarter smaller than base64.
std::string svg_address(std::string_view svg);

/// At most `digits` significant digits: 0.0123, 0.000123, 12300, 1.23 × 10⁻⁵ (UTF-8); "not finite" for NaN
/// and infinities.
std::string number(double value, int digits = 3);
/// The same, with a plus sign where it is positive.
std::string signed_number(double value, int digits = 3);
/// As number, with the unit unless it is "-"; an em dash for an empty value.
std::string number_with_unit(std::optional<double> value, std::string_view unit, int digits = 3);
/// Numbers from coarse to fine, with arrows between them; an em dash for none.
std::string joined(const std::vector<double>& values, int digits = 3);
/// A count, in full, in groups of three digits.
std::string count(double value);

/// Lower-case letters, digits and hyphens only: for identifiers and file names.
std::string slug(std::string_view text);

/// A piece of markup. The makers below are the only ways to one, and all but `markup` escape.
struct Cell {
    std::string html;
    std::string css_class;
    std::size_t rows = 1;  ///< rows that it spans; the next rows then have one cell less
};
Cell text(std::string_view value);
Cell value(std::optional<double> number_or_nothing, std::string_view unit = "-", int digits = 3);
Cell whole(double count_value);
/// "within tolerance", "outside tolerance" or an em dash.
Cell verdict(std::optional<bool> within);
/// Words for readers, with the identifier for scripts in the tooltip.
std::string named_words(std::string_view words, std::string_view identifier);
Cell named(std::string_view words, std::string_view identifier, std::string css_class = "",
           std::size_t rows = 1);
/// Markup that the caller made safe.
Cell markup(std::string html, std::string css_class = "", std::size_t rows = 1);

/// A table that scrolls inside its own box on narrow screens. In print it is as wide as the paper: cells
/// wrap, and tables of many columns have smaller letters (classes `columns-many`, `columns-most`).
class Table {
  public:
    /// `css_class`: "compact" for many columns of numbers; "stacked" for a table whose rows become blocks on
    /// narrow screens, with the header of each cell before it.
    explicit Table(const std::vector<std::string>& headers, std::string css_class = "");
    void add(const std::vector<Cell>& cells);
    std::size_t rows() const { return static_cast<std::size_t>(rows_); }
    bool empty() const { return rows_ == 0; }
    std::string html() const;

  private:
    std::string css_class_;
    std::size_t columns_;
    std::vector<std::string> labels_;  ///< of the cells of a stacked table
    std::string head_;
    std::string body_;
    int rows_ = 0;
};

std::string paragraph(std::string_view text, std::string_view css_class = "");
/// A closed box that opens on a click (and for print).
std::string details(std::string_view summary, const std::string& html, bool open = false,
                    std::string_view css_class = "");
/// A long text of a machine's making, folded away on the screen and left out in print.
std::string source_text(std::string_view summary, std::string_view text);

}  // namespace wetdeck::report

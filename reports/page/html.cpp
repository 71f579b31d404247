// SPDX-License-Identifier: BSD-3-Clause
// Escaping, numbers and tables of the report.
#include "reports/page/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "reports/page/strings.hpp"

namespace wetdeck::report {
namespace {

/// Superscript digits in UTF-8, for powers of ten.
std::string superscript(int exponent) {
    static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
    return text;
}

/// Without trailing zeros, with a true minus sign.
std::string polished(std::string text) {
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text.front() == '-' ? "−" + text.substr(1) : text;
}

}  // namespace

std::string escape(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += (static_cast<unsigned char>(c) < 0x20 && c != '\n') ? ' ' : c;
        }
    }
    return out;
}

std::string escape_script(std::string_view code) {
    static constexpr std::string_view closing = "</script";
    std::string out;
    out.reserve(code.size());
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::string_view here = code.substr(i, closing.size());
        const bool closes = std::equal(here.begin(), here.end(), closing.begin(), closing.end(),
                                       [](char a, char b) { return std::tolower(a) == b; });
        // Both occur only in strings, patterns and comments, where these spellings mean the same.
        const bool opens_comment = here.substr(0, 4) == "<!--";
        out += opens_comment ? "\\x3c" : std::string(1, code[i]);
        if (closes) out += '\\';
    }
    return out;
}

std::string escape_json(std::string json) {
    replace_all(json, "<", "\\u003c");
    return json;
}

std::string base64(std::span<const unsigned char> bytes) {
    static constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += k <= n ? alphabet[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string base64(std::string_view bytes) {
    return base64(std::span(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

std::string data_address(std::string_view media_type, std::string_view bytes) {
    return fmt::format("data:{};base64,{}", media_type, base64(bytes));
}

std::string svg_address(std::string_view svg) {
    std::string out = "data:image/svg+xml,";
    for (const char c : svg) {
        const bool reserved = static_cast<unsigned char>(c) <= 0x20 || c == '\x7f' ||
                              std::string_view("%#<>\"&").find(c) != std::string_view::npos;
        if (c == ' ' || c == '\n') {
            out += ' ';
        } else if (!reserved) {
            out += c;
        } else {
            out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return out;
}

std::string signed_number(double value, int digits) {
    return fmt::format("{}{}", value > 0 ? "+" : "", number(value, digits));
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "not finite";
    if (value == 0) return "0";
    // Rounded in scientific form first, so that 9.996 counts as 10.0 and not as 9.996.
    const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = scientific.find('e');
    const int exponent = std::stoi(scientific.substr(e + 1));
    if (exponent < -4 || exponent >= 5) {
        return polished(scientific.substr(0, e)) + " × 10" + superscript(exponent);
    }
    const double rounded = std::stod(scientific);
    return polished(fmt::format("{:.{}f}", rounded, std::max(0, digits - 1 - exponent)));
}

std::string number_with_unit(std::optional<double> value, std::string_view unit, int digits) {
    if (!value) return "—";
    const bool plain = unit.empty() || unit == "-";
    return plain ? number(*value, digits) : number(*value, digits) + "\u00a0" + std::string(unit);
}

std::string joined(const std::vector<double>& values, int digits) {
    std::string out;
    for (const double value : values) out += (out.empty() ? "" : " → ") + number(value, digits);
    return out.empty() ? "—" : out;
}

std::string count(double value) {
    if (!std::isfinite(value)) return "not finite";
    const std::string digits = fmt::format("{:.0f}", value);
    std::string out;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && digits[i - 1] != '-' && (digits.size() - i) % 3 == 0) out += "\u202f";
        out += digits[i];
    }
    return out;
}

std::string slug(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool upper = c >= 'A' && c <= 'Z';
        const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (upper || kept) {
            out += upper ? static_cast<char>(c - 'A' + 'a') : c;
        } else if (!out.empty() && out.back() != '-') {
            out += '-';
        }
    }
    if (!out.empty() && out.back() == '-') out.pop_back();
    return out.empty() ? "x" : out;
}

Cell text(std::string_view value) {
    return {escape(value), "", 1};
}

Cell value(std::optional<double> number_or_nothing, std::string_view unit, int digits) {
    return {escape(number_with_unit(number_or_nothing, unit, digits)), "number", 1};
}

Cell whole(double count_value) {
    return {count(count_value), "number", 1};
}

Cell verdict(std::optional<bool> within) {
    if (!within) return markup("—");
    return *within ? markup("<span class=\"badge good\">within tolerance</span>")
                   : markup("<span class=\"badge bad\">outside tolerance</span>");
}

Cell markup(std::string html, std::string css_class, std::size_t rows) {
    return {std::move(html), std::move(css_class), rows};
}

std::string named_words(std::string_view words, std::string_view identifier) {
    if (identifier.empty()) return escape(words);
    return fmt::format("<span title=\"{}\">{}</span>", escape(identifier), escape(words));
}

Cell named(std::string_view words, std::string_view identifier, std::string css_class, std::size_t rows) {
    return markup(named_words(words, identifier), std::move(css_class), rows);
}

Table::Table(const std::vector<std::string>& headers, std::string css_class)
    : css_class_(std::move(css_class)), columns_(headers.size()) {
    if (css_class_.find("stacked") != std::string::npos) labels_ = headers;
    for (const std::string& header : headers) head_ += "<th scope=\"col\">" + escape(header) + "</th>";
}

void Table::add(const std::vector<Cell>& cells) {
    body_ += "<tr>";
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const Cell& cell = cells[k];
        const std::string rows = cell.rows > 1 ? fmt::format(" rowspan=\"{}\"", cell.rows) : "";
        const std::string css = cell.css_class.empty() ? "" : fmt::format(" class=\"{}\"", cell.css_class);
        const std::string label =
            k < labels_.size() ? fmt::format(" data-label=\"{}\"", escape(labels_[k])) : "";
        body_ += fmt::format("<td{}{}{}>{}</td>", rows, css, label, cell.html);
    }
    body_ += "</tr>\n";
    ++rows_;
}

std::string Table::html() const {
    const std::string css = css_class_.empty() ? "" : " " + css_class_;
    const std::string many = columns_ > 6 ? fmt::format(" columns-{}", columns_ > 10 ? "most" : "many") : "";
    return "<div class=\"table" + css + many + "\"><table><thead><tr>" + head_ + "</tr></thead>\n<tbody>\n" +
           body_ + "</tbody></table></div>\n";
}

std::string paragraph(std::string_view text, std::string_view css_class) {
    const std::string attribute = css_class.empty() ? "" : fmt::format(" class=\"{}\"", css_class);
    return "<p" + attribute + ">" + escape(text) + "</p>\n";
}

std::string details(std::string_view summary, const std::string& html, bool open,
                    std::string_view css_class) {
    return fmt::format("<details{}{}><summary>{}</summary>\n{}</details>\n",
                       css_class.empty() ? "" : fmt::format(" class=\"{}\"", css_class), open ? " open" : "",
                       escape(summary), html);
}

std::string source_text(std::string_view summary, std::string_view text) {
    return details(summary, "<pre>" + escape(text) + "</pre>", false, "source");
}

}  // namespace wetdeck::report

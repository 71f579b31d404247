// SPDX-License-Identifier: BSD-3-Clause
// Escaping, numbers and tables of the report.
#include "reports/page/html.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "reports/page/strings.hpp"

using namespace wetdeck::report;

TEST_CASE("Markup in a text is shown and not obeyed", "[report]") {
    CHECK(escape("<b a=\"1\" c='2'>&") == "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
    CHECK(escape(std::string_view("a\0\x1b\tb", 5)) == "a   b");
    CHECK(text("<script>").html == "&lt;script&gt;");
    CHECK(value(1.0, "<Pa>").html == "1\u00a0&lt;Pa&gt;");
    CHECK(paragraph("<i>") == "<p>&lt;i&gt;</p>\n");
}

TEST_CASE("A script cannot end its element early", "[report]") {
    CHECK(escape_script("a('</script>', '</SCRIPT')") == "a('<\\/script>', '<\\/SCRIPT')");
    CHECK(escape_script("'<!--'") == "'\\x3c!--'");
    CHECK(escape_script("a < b && c </d") == "a < b && c </d");
    CHECK(escape_json("{\"t\":\"</script>\"}") == "{\"t\":\"\\u003c/script>\"}");
}

TEST_CASE("Numbers have at most the asked number of significant digits", "[report]") {
    CHECK(number(0) == "0");
    CHECK(number(0.012345) == "0.0123");
    CHECK(number(9.996) == "10");
    CHECK(number(-2.5) == "−2.5");
    CHECK(number(12345) == "12300");
    CHECK(number(99960) == "1 × 10⁵");
    CHECK(number(0.00049) == "0.00049");
    CHECK(number(1.234e-5) == "1.23 × 10⁻⁵");
    CHECK(number(6.02214e23, 4) == "6.022 × 10²³");
    CHECK(number(0.0050001, 4) == "0.005");
    CHECK(number(std::numeric_limits<double>::quiet_NaN()) == "not finite");
    CHECK(number(-std::numeric_limits<double>::infinity()) == "not finite");
}

TEST_CASE("A number comes with its unit, and a missing one is a dash", "[report]") {
    CHECK(number_with_unit(9810.0, "Pa") == "9810\u00a0Pa");
    CHECK(number_with_unit(0.5, "-") == "0.5");
    CHECK(number_with_unit(std::nullopt, "Pa") == "—");
}

TEST_CASE("Counts are written in full, in groups of three digits", "[report]") {
    CHECK(count(999) == "999");
    CHECK(count(1234567) == "1\u202f234\u202f567");
    CHECK(count(-123456) == "-123\u202f456");
}

TEST_CASE("Base64 follows RFC 4648 for every remainder of three", "[report]") {
    CHECK(base64(std::string_view("")) == "");
    CHECK(base64(std::string_view("f")) == "Zg==");
    CHECK(base64(std::string_view("fo")) == "Zm8=");
    CHECK(base64(std::string_view("foo")) == "Zm9v");
    CHECK(base64(std::string_view("\xff\xfe\xfd")) == "//79");
}

TEST_CASE("A drawing in an attribute cannot end it", "[report]") {
    CHECK(svg_address("<a b=\"#1\">&lt;50%\n") == "data:image/svg+xml,%3Ca b=%22%231%22%3E%26lt;50%25 ");
}

TEST_CASE("A slug is safe as a file name and an identifier", "[report]") {
    CHECK(slug("Dam_break: p/(rho g) ../x") == "dam-break-p-rho-g-x");
    CHECK(slug("<>") == "x");
}

TEST_CASE("The words of a verdict are within and outside tolerance", "[report]") {
    CHECK(verdict(true).html.find("within tolerance") != std::string::npos);
    CHECK(verdict(false).html.find("outside tolerance") != std::string::npos);
    CHECK(verdict(std::nullopt).html == "—");
}

TEST_CASE("A cell may span rows", "[report]") {
    Table table({"a", "b"});
    CHECK(table.empty());
    table.add({markup("x", "", 2), text("1")});
    table.add({text("2")});
    CHECK(table.html().find("<tr><td rowspan=\"2\">x</td><td>1</td></tr>\n<tr><td>2</td></tr>") !=
          std::string::npos);
}

TEST_CASE("Numbers from coarse to fine are joined by arrows", "[report]") {
    CHECK(joined({0.04, 0.02, 0.0123456}, 4) == "0.04 → 0.02 → 0.01235");
    CHECK(joined({}) == "—");
}

TEST_CASE("A CSV field stays one field on one line", "[report]") {
    CHECK(csv_field("plain text") == "plain text");
    CHECK(csv_field("a, b") == "a; b");
    CHECK(csv_field("say \"x\"") == "say 'x'");
    CHECK(csv_field("#1") == "\"#1\"");
    CHECK(csv_field("two\nlines") == "two lines");
}

// SPDX-License-Identifier: BSD-3-Clause
// Readers of files against any valid input: what was written is what is read.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <variant>

#include "tests/property/generated.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/scene/outline_file.hpp"
#include "validation/scene/toml_reader.hpp"
#include "validation/store/run_store.hpp"

using namespace wetdeck;

namespace {

/// Any number that may be a value, the smallest included: from 1e300 on it stands for none.
rc::Gen<double> finite() {
    const auto bits = rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>());
    const auto any = rc::gen::map(bits, [](std::uint64_t n) { return std::bit_cast<double>(n); });
    return rc::gen::oneOf(rc::gen::suchThat(any, [](double x) { return std::abs(x) < 1e300; }),
                          generated::number(-1000, 1000));
}

rc::Gen<std::string> word(const std::string& letters) {
    return rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::elementOf(letters)));
}

/// Names, each once.
rc::Gen<std::vector<std::string>> names(std::size_t least) {
    return rc::gen::suchThat(
        rc::gen::resize(6, rc::gen::unique<std::vector<std::string>>(word("abcxyz_-09"))),
        [least](const auto& drawn) { return drawn.size() >= least; });
}

// --- reference curves

struct Table {
    std::vector<std::string> names, units;
    std::vector<std::vector<double>> rows;  ///< NaN for an empty cell
};

Table draw_table() {
    Table table;
    table.names = *names(1).as("columns");
    for (std::size_t n = 0; n < table.names.size(); ++n)
        table.units.push_back(generated::one_of<const char*>("unit", {"-", "m", "N s/m", "kg/m^3"}));
    std::vector<double> x = *rc::gen::nonEmpty(rc::gen::unique<std::vector<double>>(finite())).as("abscissa");
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());  // 0 and -0
    for (const double abscissa : x) {
        table.rows.push_back({abscissa});
        for (std::size_t n = 1; n < table.names.size(); ++n) {
            const bool empty = generated::one_of("empty", {false, false, false, true});
            table.rows.back().push_back(empty ? std::nan("") : *finite().as("cell"));
        }
    }
    return table;
}

/// As a reference file, with a spreadsheet's line ends, blank lines and spaces where these are drawn.
std::string csv_of(const Table& table) {
    const std::string end = generated::one_of<const char*>("line ends", {"\n", "\r\n"});
    const std::string gap = generated::one_of<const char*>("spaces", {"", " ", "\t"});
    std::string text = generated::one_of<const char*>("mark", {"", "\xEF\xBB\xBF"});
    for (const char* key :
         {"kind: experiment", "citation: a", "doi: b", "figure: c", "obtained: digitised", "obtained_from: d",
          "date: 2026-01-31", "digitisation_error: e", "u_data: 0.03", "u_data_source: f", "sensor: g",
          "filter: none", "sign: up", "time_origin: h", "note: i: j, k"})
        text += fmt::format("# {}{}", key, end);
    for (std::size_t n = 0; n < table.names.size(); ++n)
        text += fmt::format("{}{}{} [{}]", n > 0 ? "," : "", gap, table.names[n], table.units[n]);
    text += end;
    for (const std::vector<double>& row : table.rows) {
        if (generated::one_of("blank line", {false, true})) text += end;
        for (std::size_t n = 0; n < row.size(); ++n)
            text += (n > 0 ? "," : "") + gap + (std::isnan(row[n]) ? "" : fmt::format("{}", row[n]));
        text += end;
    }
    return text;
}

// --- TOML

using Value = std::variant<double, bool, std::string, std::vector<double>, std::vector<std::string>>;

/// Texts of letters that need care in a file.
rc::Gen<std::string> text() {
    const std::vector<std::string> letters = {"a", "Z", " ", "\"", "\\", "\n", "\t",   "#",
                                              "=", "'", "é", "ψ",  "[",  "]",  "\x01", "😀"};
    return rc::gen::map(
        rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(letters)),
        [](const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "")); });
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += {'\\', c};
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
    }
    return out + "\"";
}

template <class Item, class Write>
std::string list_of(const std::vector<Item>& items, const Write& write) {
    std::vector<std::string> written;
    for (const Item& item : items) written.push_back(write(item));
    return fmt::format("[{}]", fmt::join(written, ", "));
}

std::string toml_of(const Value& value) {
    const auto number = [](double x) {
        return x == std::trunc(x) && std::abs(x) < 1e15 ? fmt::format("{:.0f}", x) : fmt::format("{:#}", x);
    };
    if (const auto* x = std::get_if<double>(&value)) return number(*x);
    if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
    if (const auto* t = std::get_if<std::string>(&value)) return quoted(*t);
    if (const auto* list = std::get_if<std::vector<double>>(&value)) return list_of(*list, number);
    return list_of(std::get<std::vector<std::string>>(value), quoted);
}

Value draw_value() {
    switch (*generated::whole(0, 4).as("type")) {
        case 0:
            return *finite().as("number");
        case 1:
            return generated::one_of("boolean", {false, true});
        case 2:
            return *text().as("text");
        case 3:
            return *rc::gen::container<std::vector<double>>(finite()).as("numbers");
        default:
            return *rc::gen::container<std::vector<std::string>>(text()).as("texts");
    }
}

std::map<std::string, Value> draw_entries() {
    std::map<std::string, Value> entries;
    for (const std::string& name : *names(0).as("keys")) entries[name] = draw_value();
    return entries;
}

std::string toml_of(const std::map<std::string, Value>& entries) {
    std::string text;
    for (const auto& [key, value] : entries) text += fmt::format("{} = {}\n", key, toml_of(value));
    return text;
}

Value read(const TomlTable& table, const std::string& key, const Value& like) {
    if (std::holds_alternative<double>(like)) return table.number(key);
    if (std::holds_alternative<bool>(like)) return table.boolean_or(key, false);
    if (std::holds_alternative<std::string>(like)) return table.text(key);
    if (std::holds_alternative<std::vector<double>>(like)) return table.numbers(key);
    return table.texts(key);
}

void require_same(const TomlTable& table, const std::map<std::string, Value>& entries) {
    for (const auto& [key, value] : entries) RC_ASSERT((read(table, key, value) == value));
}

}  // namespace

TEST_CASE("Any reference file is read back, bit for bit", "[generated][reference]") {
    generated::check(150, [] {
        const Table table = draw_table();
        const Reference reference = parse_reference("a.csv", csv_of(table));
        RC_ASSERT(reference.columns.size() == table.names.size());
        for (std::size_t n = 0; n < table.names.size(); ++n) {
            const Column& column = reference.columns[n];
            RC_ASSERT(column.name == table.names[n]);
            RC_ASSERT(column.unit == table.units[n]);
            RC_ASSERT(column.values.size() == table.rows.size());
            std::size_t empty = 0;
            for (std::size_t row = 0; row < table.rows.size(); ++row) {
                const double expected = table.rows[row][n];
                empty += std::isnan(expected) ? 1 : 0;
                RC_ASSERT(std::bit_cast<std::uint64_t>(column.values[row]) ==
                          std::bit_cast<std::uint64_t>(expected));
            }
            RC_ASSERT(column.empty_cells == empty);
        }
        RC_ASSERT(reference.keys.at("note") == "i: j, k");
        RC_ASSERT(reference.u_data.value().value == 0.03);
    });
}

TEST_CASE("Any tables of a TOML document are read back, and no key is left over", "[generated][toml]") {
    generated::check(200, [] {
        const auto root = draw_entries(), inner = draw_entries(), first = draw_entries(),
                   second = draw_entries();
        const TomlDocument document(toml_of(root) + "[inner.most]\n" + toml_of(inner) + "[[rows]]\n" +
                                        toml_of(first) + "[[rows]]\n" + toml_of(second),
                                    "a.toml");
        const TomlTable table = document.root();
        require_same(table, root);
        const TomlTable most = table.table("inner").table("most");
        require_same(most, inner);
        const std::vector<TomlTable> rows = table.tables("rows");
        RC_ASSERT(rows.size() == 2u);
        require_same(rows[0], first);
        require_same(rows[1], second);
        for (const TomlTable& read_out : {table, most, rows[0], rows[1]}) read_out.finish();
    });
}

TEST_CASE("A TOML document that is written out again says the same", "[generated][toml]") {
    generated::check(150, [] {
        const auto root = draw_entries(), inner = draw_entries();
        const TomlDocument document(toml_of(root) + "[inner]\n" + toml_of(inner), "a.toml");
        // toml++ 3.3 writes a line end as such, and drops it at the beginning of a text
        RC_PRE(toml_of(root).find("\\u") == std::string::npos);
        RC_PRE(toml_of(inner).find("\\u") == std::string::npos);
        const TomlDocument again(document.resolved(), "b.toml");
        require_same(again.root(), root);
        require_same(again.root().table("inner"), inner);
    });
}

TEST_CASE("Any outline of corners is read back from its file", "[generated][outline]") {
    const samples::ScratchFolder folder;
    generated::check(60, [&] {
        auto corners =
            *rc::gen::suchThat(rc::gen::unique<std::vector<std::pair<double, double>>>(
                                   rc::gen::pair(generated::number(-10, 10), generated::number(-10, 10))),
                               [](const auto& drawn) { return drawn.size() >= 3; })
                 .as("corners");
        const std::string between = generated::one_of<const char*>("between", {",", ";", " ", ", ", "\t"});
        std::string file =
            generated::one_of<const char*>("above", {"", "# hull\n", "x, y\n", "\n# a\nx [m], y [m]\n"});
        for (const auto& [x, y] : corners) file += fmt::format("{}{}{}\n", x, between, y);
        if (generated::one_of("closed", {false, true}))
            file += fmt::format("{}{}{}\n", corners[0].first, between, corners[0].second);
        samples::put_bytes(folder / "hull.csv", file);
        const Outline outline = read_outline(folder / "hull.csv");
        RC_ASSERT(outline.size() == corners.size());
        for (std::size_t n = 0; n < corners.size(); ++n)
            RC_ASSERT((outline[n] == Vec2(corners[n].first, corners[n].second)));
    });
}

TEST_CASE("Any series and numbers of a run are read back from run.h5, bit for bit", "[generated][store]") {
    const samples::ScratchFolder folder;
    generated::check(20, [&] {
        RunRecord record;
        record.scene = *text().as("scene");
        for (const std::string& name : *names(0).as("series")) {
            Series& series = record.series[name];
            series.unit = *text().as("unit");
            series.time = *rc::gen::container<std::vector<double>>(finite()).as("time");
            series.value = *rc::gen::container<std::vector<double>>(series.time.size(), finite()).as("value");
        }
        for (const std::string& name : *names(0).as("parameters"))
            record.parameters[name] = *finite().as("parameter");
        write_run(folder, record);
        const RunRecord found = read_run(run_file(folder));
        RC_ASSERT(found.scene == record.scene);
        RC_ASSERT(found.parameters == record.parameters);
        RC_ASSERT(found.series.size() == record.series.size());
        for (const auto& [name, series] : record.series)
            RC_ASSERT(samples::same(found.series.at(name), series));
    });
}

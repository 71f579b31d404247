// SPDX-License-Identifier: BSD-3-Clause
// Function objects of OpenFOAM: forces and probes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <regex>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/import/formats.hpp"
#include "validation/import/openfoam_files.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array axes{"x", "y", "z"};

/// What the head of a file of probes says of each.
struct ProbeHead {
    std::string place;
    bool found = true;
};

/// The record of one quantity of one function object.
struct Part {
    std::vector<RecordColumn> columns;
    std::vector<RecordSegment> segments;
    std::vector<ProbeHead> probes;
};

/// The numbers of a line, and whether all stand in brackets of three.
struct Numbers {
    std::vector<double> values;
    bool vectors = false;
};

Numbers numbers_in(std::string_view line, const TextLines& lines) {
    Numbers found;
    std::string text(line);
    const auto open = std::count(text.begin(), text.end(), '('),
               close = std::count(text.begin(), text.end(), ')');
    if (open != close) lines.fail("a bracket is missing: the line is half written");
    found.vectors = open > 0;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
    for (const std::string_view cell : cells_of(text, ' '))
        found.values.push_back(record_number(cell, lines));
    return found;
}

bool is_load(const std::string& quantity) {
    return quantity == "force" || quantity == "moment";
}

std::string unit_of(const std::string& quantity) {
    if (quantity == "force") return "N";
    if (quantity == "moment") return "N m";
    if (quantity == "p" || quantity == "p_rgh") return "Pa";
    if (quantity == "U") return "m/s";
    return quantity.starts_with("alpha.") ? "-" : "";
}

void name_load(Part& part, const std::string& quantity, std::size_t count, const TextLines& lines) {
    const std::array parts{"", "_pressure", "_viscous", "_porous"};
    if (count != 9 && count != 12)
        lines.fail(
            fmt::format("holds {} numbers, expected a time and total, pressure and viscous parts of "
                        "three (9, or 12 with a porous one)",
                        count));
    for (std::size_t k = 0; k < count; ++k)
        part.columns.push_back({fmt::format("{}{}_{}", quantity, parts[k / 3], axes[k % 3]),
                                unit_of(quantity),
                                "all patches of the function object, the whole layer",
                                fmt::format("of the fluid on the patch, along {} of the mesh", axes[k % 3]),
                                {}});
}

void name_probes(Part& part, const std::string& quantity, const Numbers& numbers, const TextLines& lines) {
    const std::size_t count = part.probes.size(), size = numbers.vectors ? 3 : 1;
    if (count == 0) lines.fail("expected lines '# Probe 0 (x y z)' first");
    if (numbers.values.size() != 1 + count * size)
        lines.fail(fmt::format("holds {} numbers, expected a time and {} for {} probes",
                               numbers.values.size(), count * size, count));
    for (std::size_t k = 0; k < count * size; ++k) {
        const ProbeHead& probe = part.probes[k / size];
        std::string name = fmt::format("{}_{}", quantity, k / size);
        if (size == 3) name += fmt::format("_{}", axes[k % 3]);
        part.columns.push_back(
            {name,
             unit_of(quantity),
             fmt::format("probe at {}{}", probe.place, probe.found ? "" : ", outside the mesh"),
             unit_of(quantity) == "Pa" ? "pressure, compression positive" : "",
             {}});
    }
}

/// "# Probe 3 (0.1 0.2 0.5) # Not Found"
void read_probe_head(std::string_view line, std::vector<ProbeHead>& probes, const TextLines& lines) {
    static const std::regex head(R"(#\s*Probe\s+(\d+)\s*(\([^)]*\))(.*))");
    std::match_results<std::string_view::const_iterator> match;
    if (!std::regex_match(line.begin(), line.end(), match, head)) return;
    if (std::stoul(match[1].str()) != probes.size()) lines.fail("a probe is missing in the head");
    probes.push_back({match[2].str(), match[3].str().find("Not Found") == std::string::npos});
}

void read_file(const OpenfoamFile& file, Part& part) {
    const std::string text = record_text(file.path.string());
    TextLines lines(file.path.string(), text);
    RecordSegment segment{file.start, {}};
    std::vector<ProbeHead> probes;
    std::size_t width = 0;
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty()) continue;
        if (line.front() == '#') {
            read_probe_head(line, probes, lines);
            continue;
        }
        const Numbers numbers = numbers_in(line, lines);
        if (part.columns.empty()) {
            part.probes = probes;
            if (is_load(file.quantity))
                name_load(part, file.quantity, numbers.values.size() - 1, lines);
            else
                name_probes(part, file.quantity, numbers, lines);
        }
        width = part.columns.size();
        if (numbers.values.size() != width + 1)
            lines.fail(fmt::format("holds {} numbers, expected {}; a line that ends early is half written",
                                   numbers.values.size(), width + 1));
        for (std::size_t k = 0; k < probes.size() && k < part.probes.size(); ++k)
            if (probes[k].place != part.probes[k].place)
                lines.fail(fmt::format("probe {} is at {}, at {} in an earlier run", k, probes[k].place,
                                       part.probes[k].place));
        add_row(segment, {numbers.values.front(), {numbers.values.begin() + 1, numbers.values.end()}}, lines);
    }
    part.segments.push_back(std::move(segment));
}

/// All parts over the union of their times.
void join_parts(CodeRecord& record, const std::map<std::pair<std::string, std::string>, Part>& parts) {
    std::set<std::string> objects;
    for (const auto& [key, part] : parts) objects.insert(key.first);
    std::map<double, std::vector<double>> rows;
    std::size_t width = 0;
    std::set<std::string> said;
    for (const auto& [key, part] : parts) {
        const JoinedRows all = joined(part.segments);
        for (const std::string& note : notes_on(all))
            if (const std::string text = fmt::format("{}: {}", key.second, note); said.insert(text).second)
                record.notes.push_back(text);
        for (RecordColumn column : part.columns) {
            if (objects.size() > 1) column.name = fmt::format("{}.{}", key.first, column.name);
            record.columns.push_back(std::move(column));
        }
        for (const RecordRow& row : all.rows) {
            std::vector<double>& values = rows[row.time];
            values.resize(width, none);
            values.insert(values.end(), row.values.begin(), row.values.end());
        }
        width += part.columns.size();
    }
    for (auto& [time, values] : rows) {
        values.resize(width, none);
        record.time.push_back(time);
        for (std::size_t k = 0; k < width; ++k) record.columns[k].values.push_back(values[k]);
    }
}

}  // namespace

CodeRecord read_openfoam(const std::vector<std::string>& paths) {
    CodeRecord record;
    record.code = "OpenFOAM";
    record.time_unit = std::string("s");
    std::map<std::pair<std::string, std::string>, Part> parts;
    const std::vector<OpenfoamFile> files = openfoam_files(paths);
    for (const OpenfoamFile& file : files) {
        read_file(file, parts[{file.object, file.quantity}]);
        record.files.push_back(file.path.string());
    }
    join_parts(record, parts);
    if (record.time.empty()) throw DataError(fmt::format("{}: holds no rows", record.files.front()));
    const OpenfoamCase found = openfoam_case(files.front());
    record.version = found.version;
    record.phase = found.phase;
    record.layer = found.layer;
    return record;
}

}  // namespace wetdeck

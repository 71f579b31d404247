// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/section_address.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/sections/section_figures.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

const std::set<std::string> keys = {"station", "layer",     "row",  "part",
                                    "unit",    "component", "axis", "tolerance"};

std::string decoded(std::string_view text, const std::string& address) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '%') {
            out += text[k];
            continue;
        }
        const std::string digits(text.substr(k + 1, 2));
        if (digits.size() < 2 || std::isxdigit(static_cast<unsigned char>(digits[0])) == 0 ||
            std::isxdigit(static_cast<unsigned char>(digits[1])) == 0)
            throw InputError(fmt::format("{}: expected two hexadecimal digits behind '%'", address));
        out += static_cast<char>(std::stoi(digits, nullptr, 16));
        k += 2;
    }
    return out;
}

std::string encoded(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += std::string_view("%&#/\"\\").find(c) != std::string_view::npos || (c > 0 && c < ' ')
                   ? fmt::format("%{:02X}", static_cast<unsigned char>(c))
                   : std::string(1, c);
    return out;
}

bool is_offset_table(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error) ||
        std::filesystem::file_size(file, error) > 20'000'000)
        return false;
    try {
        return looks_like_offsets(read_whole_file(file));
    } catch (const InputError&) {
        return false;
    }
}

/// An outline of a file: its station and its number there.
struct Row {
    const Station* station;
    std::size_t part;
};

std::vector<Row> rows_of(const SectionFile& file) {
    std::vector<Row> rows;
    for (const Station& station : file.stations)
        for (std::size_t part = 0; part < std::max<std::size_t>(station.outlines.size(), 1); ++part)
            rows.push_back({&station, part});
    return rows;
}

std::size_t number_from(const std::string& text, const std::string& key, std::size_t most) {
    const auto value = number_in(text);
    if (!value || *value != std::floor(*value) || *value < 1 || *value > static_cast<double>(most))
        throw InputError(fmt::format("{}={}: expected a number from 1 to {}", key, text, most));
    return static_cast<std::size_t>(*value);
}

std::string short_name(const Station& station) {
    return station.name.empty() ? fmt::format("{:.6g}", station.location.value_or(0)) : station.name;
}

std::string names_of(const SectionFile& file) {
    constexpr std::size_t most = 40;
    std::vector<std::string> names;
    for (const Station& station : file.stations)
        if (names.size() < most) names.push_back(short_name(station));
    return fmt::format("{}{}", fmt::join(names, ", "), file.stations.size() > most ? ", ..." : "");
}

const Station& station_at(const SectionFile& file, const std::string& wanted) {
    constexpr double rounding = 0.0005;  // of a place that was printed [m]
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    for (const Station& station : file.stations)
        if (!station.name.empty() &&
            std::equal(station.name.begin(), station.name.end(), wanted.begin(), wanted.end(), same))
            return station;
    const auto place = number_in(wanted);
    const Station* nearest = nullptr;
    const auto distance = [&](const Station& s) { return std::abs(*s.location - *place); };
    if (place)
        for (const Station& station : file.stations)
            if (station.name.empty() && station.location &&
                (!nearest || distance(station) < distance(*nearest)))
                nearest = &station;
    if (nearest && distance(*nearest) <= rounding) return *nearest;
    throw InputError(fmt::format("{}={}: no such {}{}, expected one of {}", file.key, wanted, file.key,
                                 nearest ? fmt::format(" (the nearest is {})", short_name(*nearest)) : "",
                                 names_of(file)));
}

std::string outlines_of(const Station& station) {
    std::vector<std::string> words;
    for (std::size_t k = 0; k < station.outlines.size(); ++k) {
        const SectionFigures figures = figures_of(station.outlines[k]);
        words.push_back(fmt::format("part={} ({:.4g} m wide, y from {:.4g} to {:.4g} m)", k + 1, figures.beam,
                                    figures.low, figures.high));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

std::size_t part_of(const Station& station, const SectionAddress& address) {
    const std::size_t count = station.outlines.size();
    const auto wanted = address.wanted.find("part");
    if (wanted == address.wanted.end()) {
        if (count == 1) return 0;
        throw InputError(fmt::format("{} has {} outlines, expected one of {}, or part=lowest",
                                     station.title(), count, outlines_of(station)));
    }
    if (wanted->second != "lowest") return number_from(wanted->second, "part", count) - 1;
    if (count > 1 && figures_of(station.outlines[1]).low - figures_of(station.outlines[0]).low < 1e-6)
        throw InputError(fmt::format("part=lowest: two outlines of {} are as low, expected one of {}",
                                     station.title(), outlines_of(station)));
    return 0;
}

Row row_of(const SectionFile& file, const SectionAddress& address) {
    const std::vector<Row> rows = rows_of(file);
    const auto find = [&](const char* key) { return address.wanted.find(key); };
    const auto end = address.wanted.end();
    if (find("row") != end) {
        if (find("station") != end || find("layer") != end || find("part") != end)
            throw InputError("row: names a station and its part already, expected it alone");
        return rows[number_from(find("row")->second, "row", rows.size()) - 1];
    }
    const std::string other = file.key == "layer" ? "station" : "layer";
    if (find(other.c_str()) != end)
        throw InputError(fmt::format("{}: a {} has no {}s, expected {}=... or row=...", other, file.format,
                                     other, file.key));
    if (find(file.key.c_str()) == end && file.stations.size() > 1)
        throw InputError(fmt::format("holds {} {}s, expected {}=... with one of {}", file.stations.size(),
                                     file.key, file.key, names_of(file)));
    const Station& station = find(file.key.c_str()) == end ? file.stations.front()
                                                           : station_at(file, find(file.key.c_str())->second);
    if (station.outlines.empty()) return {&station, 0};
    return {&station, part_of(station, address)};
}

/// Corners as a body takes them.
void take_corners(const SectionOutline& outline, const Station& station, ChosenSection& chosen) {
    chosen.corners = outline.corners;
    if (outline.closed) return;
    const SectionFigures figures = figures_of(outline);
    const Vec2 &first = outline.corners.front(), &last = outline.corners.back();
    if (is_half_section(outline)) {
        const double room = 1e-5 * std::max(figures.beam, figures.depth());
        const bool port = std::any_of(outline.corners.begin(), outline.corners.end(),
                                      [room](const Vec2& c) { return c.x() < -room; });
        for (Vec2& corner : chosen.corners)
            corner.x() = std::abs(corner.x()) <= room ? 0 : std::abs(corner.x());
        if (port) chosen.notes.push_back("the half at port was drawn: its mirror image is taken");
        chosen.half = true;
        return;
    }
    const double room = 1e-3 * std::max(figures.beam, figures.depth());
    if (std::abs(first.y() - last.y()) <= room && first.x() * last.x() < 0) {
        chosen.notes.push_back("a straight deck closes the curve");
        return;
    }
    throw InputError(fmt::format(
        "{}: the curve is open, its ends ({:.5g}, {:.5g}) and ({:.5g}, {:.5g}) m are {:.3g} m apart: "
        "expected "
        "a closed curve, a half from the keel on the centre line x = 0 (axis=... moves it) to the deck, or a "
        "whole from deck to deck",
        station.title(), first.x(), first.y(), last.x(), last.y(), (first - last).norm()));
}

std::string printable(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (c == '\n')
            out += " | ";
        else
            out += c >= ' ' && c <= '~' ? c : '?';
    return out;
}

}  // namespace

std::string SectionAddress::text() const {
    std::string out = file.string();
    char before = '#';
    for (const auto& [key, value] : wanted) {
        out += fmt::format("{}{}={}", before, key, encoded(value));
        before = '&';
    }
    return out;
}

SectionOptions SectionAddress::options() const {
    SectionOptions all;
    const auto text_of = [this](const char* key) -> std::optional<std::string> {
        const auto found = wanted.find(key);
        return found == wanted.end() ? std::nullopt : std::optional(found->second);
    };
    all.unit = text_of("unit");
    all.component = text_of("component");
    if (const auto axis = text_of("axis")) {
        const auto value = number_in(*axis);
        if (!value || !std::isfinite(*value))
            throw InputError(fmt::format("axis={}: expected x of the centre line [m]", *axis));
        all.axis = *value;
    }
    if (const auto tolerance = text_of("tolerance")) {
        const auto value = number_in(*tolerance);
        if (!value || !std::isfinite(*value) || *value <= 0)
            throw InputError(fmt::format("tolerance={}: expected a positive length [m]", *tolerance));
        all.tolerance = *value;
    }
    return all;
}

std::optional<SectionAddress> section_address(const std::string& text) {
    const std::size_t mark = text.rfind('#');
    const bool chooses = mark != std::string::npos && text.find('=', mark) != std::string::npos;
    SectionAddress address;
    address.file = chooses ? text.substr(0, mark) : text;
    if (!chooses)
        return named_as_sections(address.file) || is_offset_table(address.file) ? std::optional(address)
                                                                                : std::nullopt;
    std::string_view rest = std::string_view(text).substr(mark + 1);
    while (!rest.empty()) {
        const std::string_view one = rest.substr(0, rest.find('&'));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        const std::size_t equals = one.find('=');
        const std::string key(one.substr(0, equals));
        if (equals == std::string_view::npos || !keys.contains(key))
            throw InputError(fmt::format("{}: '{}', expected KEY=VALUE with a key of {}", text, one,
                                         fmt::join(keys, ", ")));
        if (!address.wanted.emplace(key, decoded(one.substr(equals + 1), text)).second)
            throw InputError(fmt::format("{}: '{}' stands twice", text, key));
    }
    return address;
}

ChosenSection read_section_at(const SectionAddress& address) {
    const SectionFile file = read_sections(address.file, address.options());
    ChosenSection chosen;
    try {
        const Row row = row_of(file, address);
        const Station& station = *row.station;
        if (!station.problem.empty())
            throw InputError(
                fmt::format("{}: no outline can be taken: {}", station.title(), station.problem));
        chosen.title = station.title();
        if (station.outlines.size() > 1)
            chosen.title +=
                fmt::format(", part {} of {} (from the lowest up)", row.part + 1, station.outlines.size());
        chosen.notes = station.notes;
        take_corners(station.outlines[row.part], station, chosen);
        chosen.source = printable(fmt::format("{}: {}, {}, lengths in {}; its lines: {}",
                                              address.file.filename().string(), file.format, chosen.title,
                                              file.unit, station.source));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", address.file.string(), error.what()));
    }
    return chosen;
}

}  // namespace wetdeck

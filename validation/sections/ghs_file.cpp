// SPDX-License-Identifier: BSD-3-Clause
// Reads the records of a GHS geometry file (ghs_model.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/sections/ghs_model.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck::ghs {
namespace {

constexpr std::size_t most_sections = 255, most_points = 255, most_shapes = 1000;

class Reader {
  public:
    Reader(const std::string& name, std::string_view text) : lines_(name, text) {}

    Model read() {
        if (!lines_.next()) lines_.fail("is empty, expected a GHS geometry file");
        model_.title = lines_.line();
        if (marks_record(lines_.line())) lines_.fail("expected a title in the first line");
        read_header();
        while (lines_.line() != "****") {
            if (lines_.line() == "*")
                read_shape();
            else if (lines_.line() == "**")
                read_component();
            else if (lines_.line() == "***")
                read_part();
            else if (lines_.line() == "*CRT")
                skip_record();
            else
                fail_at_record();
        }
        return std::move(model_);
    }

  private:
    static bool marks_record(std::string_view line) { return line.starts_with('*'); }

    [[noreturn]] void fail_at_record() const {
        lines_.fail(fmt::format(
            "'{}' begins no record, expected '*' (shape), '**' (component), '***' (part) or '****' (end)",
            lines_.line().substr(0, 40)));
    }

    void need_line(const std::string& expected) {
        if (!lines_.next())
            lines_.fail(
                fmt::format("the file ends behind this line, expected {} (a complete file ends with "
                            "a line '****')",
                            expected));
    }

    void need_inside(const std::string& expected) {
        need_line(expected);
        if (marks_record(lines_.line()))
            lines_.fail(fmt::format("a record begins, expected {} before it", expected));
    }

    void read_header() {
        for (need_line("a shape"); !marks_record(lines_.line()); need_line("a shape")) {
            const std::string_view line = lines_.line();
            if (line.size() > 2 && (line.starts_with("P:") || line.starts_with("p:")))
                model_.preferred_unit = static_cast<char>(std::toupper(static_cast<unsigned char>(line[2])));
        }
    }

    /// Goes to the next line that begins a record.
    void skip_record() {
        do need_line("another record");
        while (!marks_record(lines_.line()));
    }

    std::vector<double> numbers(std::size_t count, const std::string& expected) {
        const std::vector<std::string_view> cells = cells_of(lines_.line(), ',');
        std::vector<double> values;
        for (const std::string_view cell : cells)
            if (const auto value = number_in(cell); value && std::isfinite(*value)) values.push_back(*value);
        if (cells.size() != count || values.size() != count)
            lines_.fail(fmt::format("'{}': expected {}", lines_.line().substr(0, 40), expected));
        return values;
    }

    std::size_t whole(double value, std::size_t least, std::size_t most, const std::string& what) const {
        if (value != std::floor(value) || value < static_cast<double>(least) ||
            value > static_cast<double>(most))
            lines_.fail(fmt::format("{} is {}, expected {} to {}", what, value, least, most));
        return static_cast<std::size_t>(value);
    }

    void add_source(std::string& source) const {
        if (!source.empty()) source += '\n';
        source += lines_.line();
    }

    Point read_point(std::size_t number, std::size_t count) {
        const std::string expected = fmt::format(
            "point {} of {}: transverse, vertical[, surface code, radius, line code]", number + 1, count);
        need_inside(expected);
        const std::vector<std::string_view> cells = cells_of(lines_.line(), ',');
        Point point;
        point.line = lines_.number();
        const auto cell = [&](std::size_t k, bool required) -> double {
            if (k >= cells.size() || (cells[k].empty() && !required)) return 0;
            const auto value = number_in(cells[k]);
            if (!value || !std::isfinite(*value))
                lines_.fail(fmt::format("'{}': expected {}{}", lines_.line().substr(0, 40), expected,
                                        reading_hint(cells[k])));
            return *value;
        };
        if (cells.size() < 2 || cells.size() > 5)
            lines_.fail(fmt::format("'{}': expected {}", lines_.line().substr(0, 40), expected));
        point.place = {cell(0, true), cell(1, true)};
        point.surface_code = static_cast<int>(whole(cell(2, false), 0, 3, "the surface code"));
        point.radius = cell(3, false);
        if (cells.size() > 4) point.line_code = cells[4];
        return point;
    }

    Section read_section(const Shape& shape, std::size_t number, std::size_t count) {
        const std::string expected =
            fmt::format("section {} of {} of shape {}: its location and the number of its points", number + 1,
                        count, shape.name);
        need_inside(expected);
        const std::vector<double> head = numbers(2, expected);
        Section section;
        section.location = head[0];
        if (!shape.sections.empty() && section.location <= shape.sections.back().location)
            lines_.fail(
                fmt::format("location {} follows {}: sections go from the bow aft, with growing "
                            "locations",
                            section.location, shape.sections.back().location));
        add_source(section.source);
        // "4.,5." is a point: a section before it states fewer points than it has
        const std::string_view count_text = cells_of(lines_.line(), ',')[1];
        if (count_text.find_first_not_of("0123456789") != std::string_view::npos)
            lines_.fail(fmt::format("'{}': expected {}, without a decimal point", lines_.line(), expected));
        const std::size_t points = whole(head[1], 1, most_points, "the number of points");
        for (std::size_t k = 0; k < points; ++k) {
            section.points.push_back(read_point(k, points));
            add_source(section.source);
        }
        return section;
    }

    void read_shape() {
        Shape shape;
        need_inside("the name of the shape");
        shape.name = lines_.line();
        for (const Shape& other : model_.shapes)
            if (other.name == shape.name)
                lines_.fail(fmt::format("a second shape is named '{}'", shape.name));
        if (model_.shapes.size() == most_shapes) lines_.fail("more shapes than expected");
        need_inside("the number of sections");
        const std::size_t count =
            whole(numbers(1, "the number of sections").front(), 1, most_sections, "the number of sections");
        for (std::size_t k = 0; k < count; ++k) shape.sections.push_back(read_section(shape, k, count));
        need_line("another record");
        if (!marks_record(lines_.line()) && !lines_.line().starts_with("PROP")) {
            const std::vector<double> shell = numbers(
                3, fmt::format("the shell's three thicknesses or another record behind the {} sections of "
                               "shape {}",
                               count, shape.name));
            shape.has_shell = std::any_of(shell.begin(), shell.end(), [](double t) { return t != 0; });
            need_line("another record");
        }
        if (lines_.line().starts_with("PROP"))
            skip_record();
        else if (!marks_record(lines_.line()))
            fail_at_record();
        model_.shapes.push_back(std::move(shape));
    }

    void read_component() {
        Component component;
        component.line = lines_.number();
        need_inside("the name of the component");
        component.name = lines_.line();
        add_source(component.source);
        need_inside("the side factor");
        const double side = numbers(1, "the side factor: -1, 0 or 1").front();
        if (side != -1 && side != 0 && side != 1)
            lines_.fail(fmt::format("the side factor is {}, expected -1, 0 or 1", side));
        component.side = static_cast<int>(side);
        add_source(component.source);
        need_inside("the effectiveness");
        component.effectiveness = numbers(1, "the effectiveness, from -1 to 1").front();
        if (std::abs(component.effectiveness) > 1)
            lines_.fail(fmt::format("the effectiveness is {}, expected -1 to 1", component.effectiveness));
        add_source(component.source);
        need_inside("the shift");
        const std::vector<double> shift = numbers(3, "the shift: longitudinal, transverse, vertical");
        component.shift = {shift[0], shift[1], shift[2]};
        add_source(component.source);
        need_inside("the name of its shape");
        add_source(component.source);
        const auto shape = std::find_if(model_.shapes.begin(), model_.shapes.end(),
                                        [&](const Shape& s) { return s.name == lines_.line(); });
        if (shape == model_.shapes.end())
            lines_.fail(fmt::format("no shape '{}' stands before component {}", lines_.line().substr(0, 40),
                                    component.name));
        component.shape = *shape;
        defined_[component.name] = std::move(component);
        skip_record();
    }

    void read_part() {
        Part part;
        need_inside("the name of the part");
        part.name = trimmed(lines_.line().substr(0, lines_.line().find('\\')));
        need_inside("the name of the fluid");
        need_inside("the type of the part");
        const double type = numbers(1, "the type of the part: 1 (hull), 4 (tank) or 10 (windage)").front();
        if (type != 1 && type != 4 && type != 10)
            lines_.fail(fmt::format("the type of part {} is {}, expected 1 (hull), 4 (tank) or 10 (windage)",
                                    part.name, type));
        part.type = static_cast<int>(type);
        need_inside("the specific gravity");
        numbers(1, "the specific gravity");
        need_inside("the reference point");
        numbers(3, "the reference point: three numbers");
        need_inside("the number of components");
        const std::size_t count =
            whole(numbers(1, "the number of components").front(), 1, 10'000, "the number of components");
        for (std::size_t k = 0; k < count; ++k) {
            need_inside(fmt::format("component {} of {} of part {}", k + 1, count, part.name));
            const auto found = defined_.find(std::string(lines_.line()));
            if (found == defined_.end())
                lines_.fail(fmt::format("no component '{}' stands before part {}",
                                        lines_.line().substr(0, 40), part.name));
            part.components.push_back(found->second);
        }
        skip_record();
        model_.parts.push_back(std::move(part));
    }

    TextLines lines_;
    Model model_;
    std::map<std::string, Component> defined_;  ///< a later one of the same name replaces the earlier
};

}  // namespace

Model parse(const std::string& name, std::string_view text) {
    return Reader(name, text).read();
}

}  // namespace wetdeck::ghs

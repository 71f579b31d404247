// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/dxf_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck::dxf {
namespace {

constexpr std::size_t longest_line = 2049;  // of the format [bytes]

class Reader {
  public:
    Reader(const std::string& name, std::string_view text) : lines_(name, text) {}

    Drawing read() {
        next();
        while (!is(0, "EOF")) {
            if (!is(0, "SECTION")) fail("expected 0 SECTION or 0 EOF");
            next();
            if (group_.code != 2) fail("expected the name of the section, a group 2");
            read_section(group_.value);
        }
        return std::move(drawing_);
    }

  private:
    bool is(int code, std::string_view value) const { return group_.code == code && group_.value == value; }

    [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

    void need_line() {
        if (!lines_.next()) fail("the file ends behind this line without its end mark, 0 EOF");
        if (lines_.line().size() > longest_line)
            fail(fmt::format("the line has {} characters, {} at most belong to the format",
                             lines_.line().size(), longest_line));
    }

    /// Goes to the next group that is no comment.
    void next() {
        do {
            need_line();
            group_.line = lines_.number();
            const std::string_view code = trimmed(lines_.line());
            const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group_.code);
            if (error != std::errc{} || end != code.data() + code.size())
                fail(fmt::format("'{}' is no group code, expected a whole number", code.substr(0, 40)));
            need_line();
            group_.value = trimmed(lines_.line());
        } while (group_.code == 999);
    }

    /// From the name of a section to behind its end.
    void read_section(std::string section) {  // a copy: the group changes
        next();
        if (section == "HEADER")
            read_header();
        else if (section == "TABLES")
            read_tables();
        else if (section == "BLOCKS")
            read_blocks();
        else if (section == "ENTITIES")
            while (!is(0, "ENDSEC")) drawing_.entities.push_back(read_entity());
        else
            while (!is(0, "ENDSEC")) skip();
        next();
    }

    void skip() {
        if (is(0, "EOF")) fail("the file ends within a section, expected 0 ENDSEC");
        next();
    }

    void read_header() {
        std::string variable;
        for (; !is(0, "ENDSEC"); skip()) {
            if (group_.code == 9) variable = group_.value;
            if (variable != "$INSUNITS" || group_.code != 70) continue;
            const auto value = number_in(group_.value);
            if (!value || *value != std::floor(*value)) fail("$INSUNITS: expected a whole number");
            drawing_.unit = static_cast<int>(*value);
        }
    }

    void read_tables() {
        while (!is(0, "ENDSEC")) {
            if (!is(0, "LAYER")) {
                skip();
                continue;
            }
            const Entity layer = read_entity();
            const bool frozen = (layer.bits(70) & 1) != 0;
            drawing_.layers[upper_case(layer.text(2).value_or(""))] = frozen                 ? Layer::frozen
                                                                      : layer.number(62) < 0 ? Layer::off
                                                                                             : Layer::shown;
        }
    }

    void read_blocks() {
        while (!is(0, "ENDSEC")) {
            if (!is(0, "BLOCK")) {
                skip();
                continue;
            }
            const Entity head = read_entity();
            Block block;
            block.base = {head.number(10), head.number(20)};
            while (!is(0, "ENDBLK")) block.entities.push_back(read_entity());
            skip();
            drawing_.blocks[upper_case(head.text(2).value_or(""))] = std::move(block);
        }
    }

    /// With the vertices of a polyline.
    Entity read_entity() {
        if (is(0, "EOF")) fail("the file ends within a section, expected 0 ENDSEC");
        if (group_.code != 0) fail("expected an entity, which begins with a group 0");
        if (group_.value == "ENDSEC") fail("the section ends within a block, expected 0 ENDBLK");
        Entity entity;
        entity.type = group_.value;
        entity.line = group_.line;
        for (next(); group_.code != 0; next()) entity.groups.push_back(group_);
        if (entity.type != "POLYLINE") return entity;
        while (is(0, "VERTEX")) entity.vertices.push_back(read_entity());
        if (!is(0, "SEQEND")) fail("the vertices of a POLYLINE end without 0 SEQEND");
        read_entity();
        return entity;
    }

    TextLines lines_;
    Group group_;
    Drawing drawing_;
};

}  // namespace

std::string upper_case(std::string name) {
    for (char& c : name)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return name;
}

std::optional<std::string> Entity::text(int code) const {
    const auto found =
        std::find_if(groups.rbegin(), groups.rend(), [code](const Group& g) { return g.code == code; });
    return found == groups.rend() ? std::nullopt : std::optional(found->value);
}

std::vector<double> Entity::numbers(int code) const {
    std::vector<double> values;
    for (const Group& group : groups) {
        if (group.code != code) continue;
        const auto value = number_in(group.value);
        if (!value || !std::isfinite(*value))
            fail(fmt::format("has '{}' in group {} (line {}), expected a number", group.value.substr(0, 40),
                             code, group.line + 1));
        values.push_back(*value);
    }
    return values;
}

double Entity::number(int code, double otherwise) const {
    const std::vector<double> values = numbers(code);
    return values.empty() ? otherwise : values.back();
}

void Entity::fail(const std::string& what) const {
    throw EntityError(fmt::format("{}: {} {}", line, type, what));
}

std::string Entity::source() const {
    std::string out = fmt::format("0 {}", type);
    for (const Group& group : groups) out += fmt::format("\n{} {}", group.code, group.value);
    for (const Entity& vertex : vertices) out += fmt::format("\n{}", vertex.source());
    return out;
}

Drawing parse(const std::string& name, std::string_view text) {
    if (text.starts_with("AutoCAD Binary DXF"))
        throw DataError(fmt::format("{}: is a binary DXF drawing, expected a text one (ASCII DXF)", name));
    if (text.starts_with("AC10"))
        throw DataError(fmt::format("{}: is a DWG drawing, expected DXF (save it as ASCII DXF)", name));
    try {
        return Reader(name, text).read();
    } catch (const EntityError& error) {
        throw DataError(fmt::format("{}:{}", name, error.what()));
    }
}

}  // namespace wetdeck::dxf

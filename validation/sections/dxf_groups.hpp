// SPDX-License-Identifier: BSD-3-Clause
// The groups of an ASCII DXF drawing, sorted into entities, blocks and layers: Autodesk, DXF Reference
// (2012), "DXF format" and "Group codes in numerical order".
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "solver/core/errors.hpp"
#include "solver/core/vec2.hpp"

namespace wetdeck::dxf {

/// "LINE: ENTITY what", without the name of the file.
class EntityError : public DataError {
  public:
    using DataError::DataError;
};

/// A code and its value, two lines of the file.
struct Group {
    int code = 0;
    std::string value;
    std::size_t line = 0;
};

struct Entity {
    std::string type;
    std::size_t line = 0;
    std::vector<Group> groups;
    std::vector<Entity> vertices;  ///< of a POLYLINE

    /// The last value of a code.
    std::optional<std::string> text(int code) const;
    /// Throws EntityError where the value is no finite number.
    double number(int code, double otherwise = 0) const;
    int bits(int code) const { return static_cast<int>(number(code)); }
    std::vector<double> numbers(int code) const;
    /// Throws EntityError.
    [[noreturn]] void fail(const std::string& what) const;
    std::string source() const;
};

struct Block {
    Vec2 base = Vec2::Zero();
    std::vector<Entity> entities;
};

enum class Layer { shown, off, frozen };

struct Drawing {
    std::optional<int> unit;              ///< of $INSUNITS
    std::map<std::string, Layer> layers;  ///< by name in upper case
    std::map<std::string, Block> blocks;  ///< by name in upper case
    std::vector<Entity> entities;
};

/// Names of layers and blocks are the same in any case.
std::string upper_case(std::string name);

/// Throws DataError "NAME:LINE: what was expected" where the text is no ASCII DXF drawing or is damaged.
Drawing parse(const std::string& name, std::string_view text);

}  // namespace wetdeck::dxf

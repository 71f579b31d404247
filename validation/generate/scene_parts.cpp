// SPDX-License-Identifier: BSD-3-Clause
#include "validation/generate/scene_parts.hpp"

#include <fmt/format.h>

#include <sstream>

namespace wetdeck {

std::string number_text(double value) {
    return fmt::format("{:.10g}", value);
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') out += '\\';
        out += letter;
    }
    return out + "\"";
}

std::string comment(const std::string& text) {
    constexpr std::size_t widest = 118;
    std::string out, line(1, '#');
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (line.size() + 1 + word.size() > widest) {
            out += line + "\n";
            line.resize(1);
        }
        line += " " + word;
    }
    return out + line + "\n";
}

}  // namespace wetdeck

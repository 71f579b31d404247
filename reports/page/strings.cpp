// SPDX-License-Identifier: BSD-3-Clause
#include "reports/page/strings.hpp"

#include <algorithm>

namespace wetdeck::report {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

std::string csv_field(std::string text) {
    replace_all(text, ",", ";");
    replace_all(text, "\"", "'");
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    return text.find('#') == std::string::npos ? text : "\"" + text + "\"";
}

}  // namespace wetdeck::report

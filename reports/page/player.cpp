// SPDX-License-Identifier: BSD-3-Clause
#include "reports/page/player.hpp"

#include <fmt/format.h>

#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

std::string colour_bar_markup(const ColourBar& bar) {
    std::string colours;
    for (const std::string& colour : bar.colours) colours += "," + colour;
    return fmt::format(
        "<div class=\"colourbar\"><span>{}</span><i style=\"background:linear-gradient(to right{})\"></i>"
        "<span>{}</span><span>{}</span></div>\n",
        escape(number(bar.low)), escape(colours), escape(number_with_unit(bar.high, bar.unit)),
        escape(bar.label));
}

std::string instant(const Picture& picture) {
    std::string out = "t = " + number_with_unit(picture.time, "s");
    if (picture.scaled_time) out += ", T = " + number(*picture.scaled_time);
    return out;
}

std::string picture_markup(const Picture& picture) {
    std::string bars;
    for (const ColourBar& bar : picture.colour_bars) bars += colour_bar_markup(bar);
    return fmt::format(
        "<figure data-instant=\"{0}\"><figcaption>{1}</figcaption>\n<img class=\"field\" alt=\"{1}\" "
        "src=\"data:image/png;base64,{2}\">\n{3}</figure>\n",
        escape(instant(picture)), escape(picture.title + ", " + instant(picture)), base64(picture.png), bars);
}

std::string in_grid(const std::vector<Picture>& pictures, const char* css_class) {
    std::string html = fmt::format("<div class=\"{}\">\n", css_class);
    for (const Picture& picture : pictures) html += picture_markup(picture);
    return html + "</div>\n";
}

}  // namespace

std::string picture_grid(const std::vector<Picture>& pictures) {
    return in_grid(pictures, "figures");
}

std::string picture_player(const std::vector<Picture>& pictures) {
    return in_grid(pictures, "figures player");
}

}  // namespace wetdeck::report

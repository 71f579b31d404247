// SPDX-License-Identifier: BSD-3-Clause
// Which section of a file is meant: "hull.gf#station=-12.3&part=1".
//
// Behind the name of the file and '#' stand KEY=VALUE, with '&' between them:
//   station, layer   the name of the station or layer, or the place of a station without a name [m]
//   row              the number of the row that `wetdeck sections` lists, instead of both and of part
//   part             the number of the outline where a station has several, from the lowest up; or "lowest"
//   unit             of a drawing that does not state its own
//   component        of a GHS file, alone
//   axis             x of the centre line in a drawing [m]
//   tolerance        distance of a chord from its arc, at most [m]
// A '%' and two hexadecimal digits stand for a byte, %26 for '&' and %2F for '/'.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/sections/section_file.hpp"

namespace wetdeck {

struct SectionAddress {
    std::filesystem::path file;
    std::map<std::string, std::string> wanted;  ///< by key

    SectionOptions options() const;  ///< throws InputError for a value that is none
    bool names_station() const {
        return wanted.contains("station") || wanted.contains("layer") || wanted.contains("row");
    }
    std::string text() const;
};

/// The address in a text; none where it names a plain file of corners: no KEY=VALUE behind a '#', no
/// extension .gf or .dxf, and no table of offsets. Throws InputError for a key that is unknown.
std::optional<SectionAddress> section_address(const std::string& text);

/// One outline of a file.
struct ChosenSection {
    Outline corners;  ///< closed, counter-clockwise; or the half at x >= 0 from the keel to the deck [m]
    bool half = false;
    std::string title;  ///< "station -12.3 m, part 1 of 2"
    std::vector<std::string> notes;
    std::string source;  ///< in one line of printable ASCII: the file, what was chosen, and its lines
};

/// Throws InputError where the file is damaged, where the address fits no outline or several, and where the
/// outline is none of a body.
ChosenSection read_section_at(const SectionAddress& address);

}  // namespace wetdeck

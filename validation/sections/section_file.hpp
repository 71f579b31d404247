// SPDX-License-Identifier: BSD-3-Clause
// Hull sections as the files of naval architects hold them: GHS geometry (ghs_file.hpp), DXF drawings
// (dxf_file.hpp) and tables of offsets (offset_table.hpp). docs/sections.md says what each may hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// One outline of a station, x to starboard and y up [m].
struct SectionOutline {
    Outline corners;     ///< counter-clockwise where closed, else from one end to the other [m]
    bool closed = true;  ///< false: a curve with two ends, as half a section from the keel to the deck is
};

/// The cut through a hull at one place along it.
struct Station {
    std::string name;                      ///< of the layer, or as the table has it; empty: it has a location
    std::optional<double> location;        ///< along the hull, with the sign of the file [m]
    std::vector<SectionOutline> outlines;  ///< from the lowest up; none where the station is a point
    std::vector<std::string> notes;        ///< what a user should know of it
    std::string problem;                   ///< why no outline may be taken; empty if one may
    std::string source;                    ///< the lines of the file that it comes from

    /// "station 12.3 m", "layer FR12".
    std::string title() const;
};

struct SectionFile {
    std::string format;  ///< "GHS geometry file", "DXF drawing", "table of offsets"
    std::string unit;    ///< in which the file holds its lengths, and who says so
    bool bow_first = false, drawn_as_body_plan = false;
    std::string key;  ///< by which a station is asked for: "station" or "layer"
    std::vector<Station> stations;
    std::vector<std::string> notes;  ///< of the whole file
};

struct SectionOptions {
    std::optional<std::string> unit{};       ///< of a drawing that does not state its own
    std::optional<std::string> component{};  ///< of a GHS file, alone
    std::optional<double> tolerance{};       ///< distance of a chord from its arc, at most [m]
    double axis = 0;                         ///< x of the centre line in a drawing [m]
};

/// Without SectionOptions::tolerance: this share of the larger side of the section.
constexpr double chord_tolerance = 1e-4;

/// Whether the name ends as that of a GHS file (.gf) or a drawing (.dxf), in any case.
bool named_as_sections(const std::filesystem::path& file);

/// Reads a .gf or .dxf file, and as a table of offsets any other. Throws InputError "FILE:LINE: what was
/// expected", EnvironmentError where the file may not be read.
SectionFile read_sections(const std::filesystem::path& file, const SectionOptions& options = {});

/// The same of texts; `name` stands in messages.
SectionFile parse_ghs(const std::string& name, std::string_view text, const SectionOptions& options = {});
SectionFile parse_dxf(const std::string& name, std::string_view text, const SectionOptions& options = {});
SectionFile parse_offsets(const std::string& name, std::string_view text);
/// Whether the first line of the text names a station, as tables of offsets do.
bool looks_like_offsets(std::string_view text);

}  // namespace wetdeck

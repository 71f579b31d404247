// SPDX-License-Identifier: BSD-3-Clause
// Readers of the files of other codes. Which versions they were written for: docs/other_codes.md.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "validation/import/code_record.hpp"

namespace wetdeck {

/// One format of `wetdeck import`.
struct ImportFormat {
    const char* name;
    const char* reads;  ///< in words
    /// Throws InputError for a path that leads to no file of the format, and DataError "FILE:LINE: what was
    /// found, what was expected" for a file that does not follow it.
    CodeRecord (*read)(const std::vector<std::string>& paths);
};

std::span<const ImportFormat> import_formats();

/// Function objects `forces` and `probes`: paths of a case, of folders of postProcessing, of their folders of
/// start times, or of single files. Start times are merged, the later start wins; force_START.dat is newer
/// than force.dat in its folder. Forces in N, moments in N m, for the whole layer; `p` and `p_rgh` in Pa.
CodeRecord read_openfoam(const std::vector<std::string>& paths);

/// Gauges (`time [s];force [N];...`) and FloatingInfo (`part;time [s];fvel.x [m/s];...`), between semicolons
/// or commas. Several files are runs that were continued.
CodeRecord read_dualsphysics(const std::vector<std::string>& paths);

/// Recordings of observed and reduced quantities (.dat): a line of titles with every start of the program,
/// so that one in the middle starts a new run.
CodeRecord read_sphinxsys(const std::vector<std::string>& paths);

/// The values of a PostprocessCallback, .csv or .json.
CodeRecord read_trixiparticles(const std::vector<std::string>& paths);

/// Columns of numbers, with or without a line of titles; the first one is the time.
CodeRecord read_plain(const std::vector<std::string>& paths);

}  // namespace wetdeck

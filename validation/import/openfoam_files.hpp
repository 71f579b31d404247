// SPDX-License-Identifier: BSD-3-Clause
// Which files of a case of OpenFOAM hold the record of a function object, and what the case says of itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wetdeck {

/// A file of a function object.
struct OpenfoamFile {
    std::filesystem::path path;
    std::string object;    ///< name of the function object: the folder of the folders of start times
    std::string quantity;  ///< force, moment, p, U, alpha.water ...
    double start = 0;      ///< start time of the run that wrote it
    bool again = false;    ///< force_START.dat: the newer one of two runs from the same start
};

/// The files under paths of a case, a folder `postProcessing`, a function object, a start time, or of files;
/// older runs first. Throws InputError where a path leads to none, or to several function objects.
std::vector<OpenfoamFile> openfoam_files(const std::vector<std::string>& paths);

/// What the case around a file says: nothing of what it does not hold.
struct OpenfoamCase {
    std::string version;          ///< of a log file
    std::string phase;            ///< "two-phase" where the materials name two phases
    std::optional<double> layer;  ///< between the planes of a mesh of one layer [m]
};
OpenfoamCase openfoam_case(const OpenfoamFile& file);

/// Distance of the two planes that all points of a mesh lie in; nothing for another mesh or no points.
std::optional<double> layer_of_points(const std::string& text);

}  // namespace wetdeck

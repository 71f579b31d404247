// SPDX-License-Identifier: BSD-3-Clause
// From a scene to a case of OpenFOAM, and what differs between the two.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/openfoam/foam_case.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// How a series of the scene is read from the probes of a case.
struct FoamGauge {
    enum class Kind {
        front,     ///< where the share of water along a row of cells falls through a half
        depth,     ///< sum of the shares of water of a column of cells, times their heights
        pressure,  ///< weighted mean
        profile,   ///< pressures, one probe for each place of the abscissa
        film,      ///< along rays from a face: the least distance at which the share of water rises to a half
        surface    ///< along rays downwards, one for each place of the abscissa: height of the first water
    };
    Kind kind = Kind::pressure;
    std::string series, unit, description;
    std::string object;  ///< the function object
    std::vector<double>
        places;  ///< front: x of the probes; film: distances from the face; surface: heights [m]
    std::vector<double> weights;      ///< of the probes; depth: heights of the cells [m]
    std::vector<double> abscissa;     ///< of a profile [m]
    std::vector<std::size_t> rays{};  ///< film, surface: how many probes each ray has, in their order
    double rise = 0;  ///< surface: speed of the frame of the case against that of the scene, up [m/s]

    /// How many numbers it gives at one time.
    std::size_t columns() const { return abscissa.empty() ? 1 : abscissa.size(); }
};

struct SceneCase {
    FoamCase foam;
    std::string shape;        ///< tank, plate, wedge, section
    double cell = 0;          ///< size of the cells that matter [m]
    double force_factor = 1;  ///< 2: half of a symmetric body
    std::vector<FoamGauge> gauges;
    std::vector<std::string> differences;  ///< one sentence each
};

/// What scenes can be written, in one line.
extern const char* const foam_supported;

/// @param cell   size of the cells [m]
/// @param until  end of the run [s]; the scene's if absent
/// The mesh of a section is made by gmsh, here and now.
/// Throws InputError, in one line with the reason and what is supported, for a scene that fits none of the
/// meshes of shapes.hpp and section_mesh.hpp, and what section_mesh throws.
SceneCase scene_case(const Scene& scene, double cell, std::optional<double> until = std::nullopt);

/// DIFFERENCES.md of a case.
std::string foam_differences(const Scene& scene, const SceneCase& written);

}  // namespace wetdeck

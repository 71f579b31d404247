// SPDX-License-Identifier: BSD-3-Clause
// A case of OpenFOAM with water and air, and its files.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/core/vec2.hpp"
#include "validation/openfoam/plane_mesh.hpp"

namespace wetdeck {

/// One fluid.
struct FoamPhase {
    double density = 0;      ///< at rest [kg/m^3]
    double viscosity = 0;    ///< dynamic [Pa s]
    double sound_speed = 0;  ///< compressible [m/s]
    double exponent = 1;     ///< of Tait's law, compressible
};

/// Points at which a function object `probes` reads fields: the value of the cell that holds each.
struct FoamProbes {
    std::string name;
    std::string fields;  ///< "p", "alpha.water"
    std::vector<Vec2> points;
    double interval = 0;  ///< between two rows [s]; 0: every step
};

/// A case. Patches of the mesh: `walls` and `body` (slip), `symmetry`, `inflow` (water at the stream's
/// velocity), `far` (water and air leave at the stream's velocity), `atmosphere`.
struct FoamCase {
    PlaneMesh mesh;
    std::string geometry;        ///< from which gmsh has made the mesh, or empty
    int slanted_correctors = 0;  ///< repeated pressure solutions of a step, for faces not square to the line
                                 ///< between their cells
    bool compressible = false;
    FoamPhase water, air;
    double air_pressure = 0;        ///< of both at rest, compressible, absolute [Pa]
    Vec2 gravity = Vec2::Zero();    ///< [m/s^2]
    Vec2 stream = Vec2::Zero();     ///< velocity of all at the start and of the inflow [m/s]
    double level = 0;               ///< where the pressure of the compressible case is that of the air [m]
    std::vector<Box> water_boxes;   ///< at the start
    std::optional<Vec2> reference;  ///< of a closed tank: where the pressure is 0 [m]
    std::vector<FoamProbes> probes;
    bool has_body = false;
    Vec2 moment_centre = Vec2::Zero();                          ///< of the moment on the body [m]
    double end_time = 0, largest_step = 0, field_interval = 0;  ///< [s]
    double courant_number = 0.4;                                ///< largest, of flow and surface

    /// "interFoam" or "compressibleInterFoam"
    std::string solver() const { return compressible ? "compressibleInterFoam" : "interFoam"; }
};

/// Thickness of the layer of every case [m]: forces are then per metre.
inline constexpr double foam_layer = 1.0;

/// All files of the case but its notes, by path below its folder.
/// @param layer  its thickness [m]
std::map<std::string, std::string> foam_files(const FoamCase& wanted, double layer = foam_layer);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The curves that a DXF drawing shows: entities of the model space and of inserted blocks, in the x, y plane.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "validation/sections/dxf_groups.hpp"
#include "validation/sections/joined_curves.hpp"

namespace wetdeck::dxf {

struct DrawnCurve {
    PlaneCurve curve;   ///< [m]
    std::string layer;  ///< in upper case
    std::string source;
};

struct DrawnCurves {
    std::vector<DrawnCurve> curves;
    std::map<std::string, int> left_out;  ///< how many of each kind, with the reason
};

/// @param metres     in one unit of the drawing
/// @param axis       x of the centre line, which becomes x = 0 [m]
/// @param tolerance  of chords [m], for a layer
///
/// Extrusion (0, 0, -1) mirrors LWPOLYLINE, 2-D POLYLINE, ARC, CIRCLE and INSERT, and leaves LINE and SPLINE
/// as they are (DXF Reference, "Object Coordinate Systems"). Throws EntityError for curves that leave
/// the plane, meshes, and numbers that do not fit.
DrawnCurves drawn_curves(const Drawing& drawing, double metres, double axis,
                         const std::function<double(const std::string& layer)>& tolerance);

}  // namespace wetdeck::dxf

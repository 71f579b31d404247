// SPDX-License-Identifier: BSD-3-Clause
// Where probes lie: on a face of a body or of the tank, as their tables of the scene file say.
#pragma once

#include <string>
#include <vector>

#include "validation/scene/faces.hpp"
#include "validation/scene/probe.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {

/// Number of the body that the probe sits on: the first one if the file does not say. Throws InputError
/// without a body.
std::size_t body_number(const TomlTable& table, const Scene& scene);

/// The key `points`, 2 to 10000.
std::size_t point_count(const TomlTable& table);

/// Middles of `count` equal parts of an interval.
std::vector<double> midpoints(double low, double high, std::size_t count);

/// A straight face of a body; all of it lies on the outline, as a probe inside the body would read nothing.
struct Face {
    std::size_t body;
    Vec2 from, to;  ///< in the frame of the outline [m]
    ProbePlace place;
    std::vector<std::string> notes;
};

/// The keys `body`, `from` and `to`. Throws InputError for a line that leaves the outline.
Face read_face(const TomlTable& table, const Scene& scene);

/// A disc on a face, over which a gauge takes its mean.
struct Disc {
    Vec2 centre;  ///< in the frame of the key [m]
    double diameter;
    std::vector<std::string> notes;
};

/// The keys `centre` and `diameter`. Refuses a centre that lies on no face, and a disc that reaches beyond
/// its end.
/// @param origin  of the frame of the key in the frame of the face
Disc read_disc(const TomlTable& table, const Scene& scene, const FacePlace& face, Vec2 origin,
               const std::string& expected);

/// Whether a face of the tank is meant: where the file says so, or there is no body.
bool on_tank(const TomlTable& table, const Scene& scene);

/// Refuses a line that leaves one side of the tank.
void check_wall_line(const TomlTable& table, const Scene& scene);

}  // namespace wetdeck

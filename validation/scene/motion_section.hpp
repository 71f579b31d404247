// SPDX-License-Identifier: BSD-3-Clause
// Prescribed motions of bodies and of the tank, from a file of samples or from formulas:
//
//     motion = "carriage.csv"                                       # columns t, x, y, angle, velocity_x, ...
//     motion.y = { formula = "ramp", velocity = -2.0, over = 0.05 }
//     motion.rotation = { formula = "harmonic", amplitude = "5 deg", period = 1.2 }
//     motion.x = { formula = "piecewise", times = [0.0, 0.5], velocities = [0.0, 1.0] }
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "solver/bodies/motion.hpp"
#include "validation/scene/toml_reader.hpp"

namespace wetdeck {

/// The motions that a table gives, for x, y and rotation, and what they are made of, for the identity of a
/// run.
struct GivenMotions {
    std::array<Motion, 3> motion;
    std::string text;
};

/// Reads the entry `motion` of a table, if there is one. Displacements count from the start.
/// @param end_time     of the run: samples must reach it [s]
/// @param sound_speed  of the water: no motion is as fast [m/s]
/// Throws InputError "file:line: key ...: what was expected".
GivenMotions read_motions(const TomlTable& table, double end_time, double sound_speed);

/// The text of a scene file with the numbers in place of each `motion` and each `table` of a spring that
/// names a file, whose path begins at the folder of the scene. Lines keep their numbers.
std::string with_sample_files(std::string text, const std::filesystem::path& scene);

/// An angle [rad]: a number, or a text with its unit as in "8 deg".
double read_angle(const TomlTable& table, const std::string& key, double fallback);

}  // namespace wetdeck

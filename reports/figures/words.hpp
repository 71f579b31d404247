// SPDX-License-Identifier: BSD-3-Clause
// Words for the identifiers of scene files and stores: what a reader sees, while the identifier, which
// scripts use, stands in the tooltip.
#pragma once

#include <string>

#include "validation/metrics/summary.hpp"

namespace wetdeck::report {

/// A name with spaces for its underscores.
std::string spaced(std::string name);

/// "vertical force, filtered" for body_force_y_filtered; a name without a meaning of its own with spaces for
/// underscores.
std::string series_words(const std::string& series);

/// The same; a series of the scene's own has the words with which the titles of its comparisons begin, if all
/// begin alike: "pressure at 0.19 h_w" of "Pressure at 0.19 h_w, AUTHOR (YEAR)".
std::string series_words(const AnalysisSpec& scene, const std::string& series);

/// "largest vertical force, filtered" for a quantity of the scene, made from its metric, its series and,
/// where others differ by these alone, its window. Also for the values that are taken from a comparison of
/// curves, "SERIES: peak against REFERENCE" and "TITLE: mean", without the reference.
std::string quantity_words(const AnalysisSpec& scene, const std::string& name);

/// The same of a scene of the summary; the name with spaces if the summary lacks the scene.
std::string quantity_words(const Summary& summary, const std::string& scene, const std::string& name);

/// The scene's title; its name where it has none.
std::string scene_words(const Summary& summary, const std::string& scene);

/// The name of a scene with spaces, short enough for the line of links and narrow columns.
std::string scene_label(std::string name);

/// The unit of a value of the scene as a reader needs it: that of the row, or of the scaled axis: "kN/m",
/// "p/(rho g h_w)".
std::string unit_words(const AnalysisSpec& scene, const ValidationRow& row);

/// The verdict in words for what the value is: "too slow" of a speed and "too late" of a time where the row
/// says "too low" or "too high", whatever the sign of the axis.
std::string verdict_words(const AnalysisSpec& scene, const ValidationRow& row);

/// The scene of that name, or one without a definition.
AnalysisSpec scene_named(const Summary& summary, const std::string& name);

}  // namespace wetdeck::report

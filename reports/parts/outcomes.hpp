// SPDX-License-Identifier: BSD-3-Clause
// What each scene reached, in one line: the main quantity of its default variant at its finest spacing.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reports/figures/selection.hpp"
#include "reports/page/figure.hpp"

namespace wetdeck::report {

/// A verdict as the colour of its mark.
enum class Tone { good, open, bad };

struct Outcome {
    std::string scene, title;
    std::string quantity, words;  ///< its identifier, empty where nothing was evaluated, and what it is
    std::optional<double> expected, tolerance, reached;
    std::string unit = "-";
    std::string kind, against;  ///< of the expected value; who says so
    std::string verdict;
    std::string open;  ///< what an open verdict needs
    Tone tone = Tone::open;
    const RunSummary* run = nullptr;          ///< null where the directory holds none
    const ComparisonResult* curve = nullptr;  ///< of the quantity's series; null without one
    std::string series;                       ///< of the quantity
};

/// One outcome a scene. The main quantity is, in this order: the scene's `error_quantity` if it has a
/// verdict; a value of the same series that has one, measurements before exact solutions before others;
/// the `error_quantity` within its tolerance; a value of another series with a verdict; a curve within its
/// tolerance; a quantity without an expected value.
Outcome outcome_of(const Summary& summary, const AnalysisSpec& scene);
/// Of all scenes.
std::vector<Outcome> outcomes_of(const Summary& summary);

/// What the finest runs of a scene were judged by: values with a tolerance, and curves.
struct Judged {
    std::size_t points = 0, within = 0;
    std::set<std::string> kinds;  ///< of the references, in words
};
/// @param runs  of the scene
Judged judged_in(const AnalysisSpec& scene, const Runs& runs);

/// A case of the library: a scene that was run, what it was judged by, and the cost of all its runs.
struct LibraryCase {
    AnalysisSpec scene;
    Runs runs;
    Judged judged;
    Outcome outcome;
    double core_seconds = 0;
};
std::vector<LibraryCase> library_of(const Summary& summary);
/// "15 cases with 375 judged values and curves at their finest spacings, 214 of them within tolerance."
std::string counted(const std::vector<LibraryCase>& library);

/// The curve of the main quantity over its reference; without series where the run has none.
Figure outcome_figure(const Outcome& outcome);

/// "experiment", "exact solution", "other code", "stated in a publication".
std::string kind_words(std::optional<ReferenceKind> kind);

/// Of a verdict of verdict.hpp.
Tone tone_of(const ValidationRow& row);
std::string badge(const std::string& words, Tone tone);

}  // namespace wetdeck::report

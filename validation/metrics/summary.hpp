// SPDX-License-Identifier: BSD-3-Clause
// The result of the analysis of a directory of runs, as plain data: what summary.json and the report show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/metrics/curve.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/metrics/verification.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

struct QuantityResult {
    std::string name;
    std::string unit;
    std::optional<double> value;  ///< empty if the run did not reach it
    std::string note;             ///< why it is empty
    std::optional<double> expected;
    std::optional<double> tolerance;
    std::string expected_source;
    std::optional<bool> within;  ///< empty where nothing is expected or nothing was computed
};

struct ComparisonResult {
    std::string title;
    std::string quantity;
    std::string reference;
    std::string kind;  ///< experiment, peer-simulation, analytic, stated
    std::string citation;
    std::optional<double> nrmse;       ///< rms difference over the range of the reference in the window
    std::optional<double> peak_error;  ///< (max simulated - max reference) / |max reference| in the window
    std::optional<double> time_error;  ///< scaled time of the maximum, simulated minus reference
    std::optional<double> reference_uncertainty;  ///< relative standard, k = 1; empty if unknown
    double tolerance = 0;
    bool within =
        false;  ///< nrmse was computed and is at most the tolerance; says nothing unless `available`
    bool available = true;  ///< false: there is no such reference file; neither a success nor a failure
    std::string note;
    std::string x_label;
    std::string y_label;
    std::optional<Window> window;
    Curve simulated;  ///< scaled
    Curve measured;   ///< scaled
};

struct RunSummary {
    RunRecord record;
    std::string directory;                 ///< relative to the suite's directory
    std::optional<double> energy_error;    ///< see conservation.hpp
    std::optional<double> momentum_error;  ///< see conservation.hpp
    std::vector<QuantityResult> quantities;
    std::vector<ComparisonResult> comparisons;
};

struct ConvergenceRow {
    std::string scene, variant, qoi;
    std::vector<double> dx;  ///< [m], coarse to fine
    std::vector<double> value;
    std::optional<double> order, extrapolated, gci_fine;  ///< see convergence.hpp
    std::optional<double> asymptotic_ratio;  ///< 1 if a fourth spacing lies on the curve of the finest three
    bool monotone = false;
    std::string verdict;  ///< monotonic, oscillatory, divergent, not asymptotic, too few spacings
};

struct SpeedErrorPoint {
    std::string scene, variant;
    double dx = 0, core_s = 0;
    std::optional<double> error;
    bool pareto = false;
};

struct Summary {
    std::string tier;
    std::vector<AnalysisSpec> scenes;
    std::vector<RunSummary> runs;
    std::vector<ConvergenceRow> convergence;
    std::vector<SpeedErrorPoint> speed_error;
    std::vector<VerificationProblem> verification;
    std::vector<std::string> missing;  ///< runs that the tier asks for and the directory lacks
};

}  // namespace wetdeck

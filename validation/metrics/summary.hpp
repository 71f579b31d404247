// SPDX-License-Identifier: BSD-3-Clause
// The result of the analysis of a directory of runs, as plain data: what summary.json and the report show.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solver/core/curve.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/metrics/standard_uncertainty.hpp"
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

/// One number taken from both curves of a comparison, in its window and on its scaled axes.
struct CurveFeature {
    std::string name;  ///< peak, time of peak, rise time, impulse, mean
    std::optional<double> simulated, reference;
};

/// How two curves differ, amplitude, timing and shape apart; see curve_metrics.hpp.
struct CurveAgreement {
    std::optional<double> magnitude, phase, combined;  ///< Sprague and Geers
    std::optional<double> amplitude_factor;  ///< of the reference over the simulation, where shapes meet best
    std::optional<double> time_shift;        ///< scaled; positive if the simulation is late
    std::optional<double> shape_error;       ///< rms difference left after both, over the reference's range
};

struct ComparisonResult {
    std::string title;
    std::string quantity;
    std::string reference;
    std::optional<ReferenceKind> kind;  ///< empty if the reference is not available
    std::string citation;
    std::optional<double> nrmse;       ///< rms difference over the range of the reference in the window
    std::optional<double> peak_error;  ///< (max simulated - max reference) / |max reference| in the window
    std::optional<double> time_error;  ///< scaled time of the maximum, simulated minus reference
    std::optional<StandardUncertainty> reference_uncertainty;  ///< scaled; empty if unknown
    std::optional<StandardUncertainty> assumed_uncertainty;    ///< by judgement, where nobody states it
    std::string assumed_reason = {};                           ///< of the judgement
    std::optional<double> abscissa_uncertainty;                ///< standard, scaled; empty if unknown
    double tolerance = 0;
    bool within =
        false;  ///< nrmse was computed and is at most the tolerance; says nothing unless `available`
    bool available = true;  ///< false: no usable reference file, or a run that was asked to stop before the
                            ///< window; neither a success nor a failure
    bool unusable = false;  ///< why not `available`: the reference is there, but not sound or not comparable
    bool judged = true;     ///< false: shown beside other references, without metrics and verdict
    std::string note;
    std::string x_label;
    std::string y_label;
    std::optional<Window> window;
    Curve simulated;  ///< scaled
    Curve measured;   ///< scaled
    std::string reference_hash;
    std::vector<CurveFeature> features;
    CurveAgreement agreement;
};

struct RunSummary {
    RunRecord record;
    std::string directory;                 ///< relative to the suite's directory
    std::optional<double> energy_error;    ///< see conservation.hpp
    std::optional<double> momentum_error;  ///< see conservation.hpp
    bool expected_unstable = false;        ///< its variant is known to become unstable
    std::vector<QuantityResult> quantities;
    std::vector<ComparisonResult> comparisons;
};

struct ConvergenceRow {
    std::string scene, variant, qoi;
    std::vector<double> dx;  ///< [m], coarse to fine
    std::vector<double> value;
    std::optional<double> order, extrapolated, gci_fine;  ///< see convergence.hpp
    std::optional<double> least_squares;     ///< 95 % uncertainty at the finest, see least_squares_fit.hpp
    std::optional<double> asymptotic_ratio;  ///< 1 if a fourth spacing lies on the curve of the finest three
    bool monotone = false;
    std::string verdict;  ///< monotonic, oscillatory, divergent, not asymptotic, too few spacings
};

/// Convergence of a whole curve; see curve_convergence.hpp.
struct CurveConvergenceRow {
    std::string scene, variant, series;
    Window window;
    std::vector<double> dx;                 ///< [m], coarse to fine
    std::vector<double> difference;         ///< rms, each spacing against the next finer one, scaled
    double range = 0;                       ///< of the finest curve in the window, scaled
    std::optional<double> order, gci_fine;  ///< the latter in the scaled unit
    double monotone_share = 0;              ///< of the instants
    std::string verdict;                    ///< as for quantities
};

/// Comparison error of one quantity of the finest run of a variant and what is known of its uncertainty, in
/// the sense of ASME V&V 20. All uncertainties are standard (k = 1), in the unit of the quantity.
struct ValidationRow {
    std::string scene, variant, quantity, unit;
    std::string against;                ///< who measured or computed
    std::optional<ReferenceKind> kind;  ///< empty if the scene does not say
    double dx = 0;
    double simulated = 0, reference = 0, error = 0;  ///< S, D, E = S - D
    std::optional<double> u_num, u_input, u_data;
    std::optional<double> u_grid;                   ///< the spacing's part of u_num
    std::optional<double> u_scatter;                ///< that of the particles' arrangement, from replicates
    std::optional<double> u_val;                    ///< only if all three are known
    double u_known = 0;                             ///< root of the sum of squares of those that are known
    std::string u_num_source;                       ///< GCI, range, or why there is none
    std::string u_input_variant;                    ///< whose study gave u_input
    std::string largest_input;                      ///< the input that most of u_input comes from
    std::vector<std::string> assumed;               ///< which of the three rest on a judgement
    std::string assumed_reason;                     ///< of that on u_data
    std::optional<std::array<double, 2>> interval;  ///< of the model error, 95 %; only with u_val
    std::optional<double> required;                 ///< relative accuracy that the user asks for
    std::string verdict;                            ///< one of those of verdict.hpp
    std::string
        largest_part;      ///< of u_known: spacing, arrangement, inputs or reference; empty: nothing is known
    std::string sentence;  ///< what it says, for a person
};

/// Why a run should not be trusted: a time origin stated by hand that differs from what the run found, or the
/// state of its flow.
struct RunDoubt {
    enum class About { time_origin, flow };
    About about = About::time_origin;
    std::string scene, variant;
    double dx = 0;
    std::string overrides;  ///< of the run, as given with --set
    std::string sentence;
};

/// One pair of a measured or exact value and its prediction, in SI units.
struct ScatterPoint {
    std::string scene, variant, quantity, quantity_class, unit, against;
    std::optional<ReferenceKind> kind;  ///< empty if the scene does not say
    double dx = 0, expected = 0, predicted = 0;
    std::optional<double> u_data;  ///< relative standard
    bool counted = false;          ///< in the statistics
    std::string dropped;           ///< why not
};

/// Bias and scatter of one class of quantities over all scenes; see statistics.hpp.
struct ClassStatistics {
    std::string quantity_class;
    ReferenceKind against = ReferenceKind::experiment;
    std::size_t count = 0;
    std::optional<double> bias, bias_low, bias_high;  ///< factor, with its 95 % confidence interval
    std::optional<double> scatter;                    ///< relative standard deviation of all that differs
    std::optional<double> sigma_data, sigma_model;    ///< its two parts, where the data's is known
};

/// A run with one input changed: of the sensitivity study, of that of the sound speed, or a replicate.
struct SensitivityRun {
    std::string key;
    double value = 0;
    RunSummary run;
};

/// How a quantity scatters among runs that differ by the arrangement of the particles; see replicates.hpp.
struct ReplicateRow {
    std::string scene, variant, quantity, unit;
    double dx = 0;                                 ///< [m]
    std::vector<double> value;                     ///< of each run, rising
    double mean = 0, deviation = 0;                ///< sample standard deviation
    double low = 0, high = 0;                      ///< 95 % confidence interval of the mean
    std::optional<double> reference, u_reference;  ///< what it is compared with, standard (k = 1)
    std::optional<double> area;  ///< area metric between both distributions, where both are known
};

/// The effect of an input's uncertainty on a quantity.
struct SensitivityRow {
    std::string scene, variant, quantity, unit, key;
    double dx = 0, low = 0, high = 0, uncertainty = 0;
    double value_low = 0, value_high = 0;
    double u_input = 0;  ///< |value_high - value_low| / |high - low| * uncertainty
};

/// A quantity at several sound speeds; see sound_speed.hpp. Uncertainties are standard (k = 1).
struct SoundSpeedRow {
    std::string scene, variant, quantity, unit;
    double dx = 0;                    ///< of the runs at several sound speeds [m]
    std::vector<double> sound_speed;  ///< [m/s], rising
    std::vector<double> value;        ///< at each
    double sound_part = 0;            ///< of the value at the variant's sound speed: f(c) - f_inf
    double u_sound = 0;               ///< of f_inf
    double finest_dx = 0;             ///< of the suite [m]
    double finest_value = 0;
    std::optional<double> spacing_part;  ///< of it; empty unless the values converge monotonically
    std::optional<double> u_num;
    double limit = 0;  ///< finest_value - sound_part - spacing_part
    std::optional<double> u_limit;
    std::optional<double> expected;
};

/// Another code against the reference that gives the scene its error.
struct PeerPoint {
    std::string scene, name, reference;
    double error = 0;
    std::optional<double> core_s;
    std::string conditions;
};

struct SpeedErrorPoint {
    std::string scene, variant;
    double dx = 0, core_s = 0;
    std::optional<double> error;  ///< see speed_error.hpp
    bool pareto = false;
    std::string against = {};  ///< where the value without error comes from
    bool relative = false;     ///< to that value; otherwise the error has the quantity's unit
};

/// The cheapest run of a scene that meets one value or curve to a given relative error.
struct CheapestRow {
    std::string scene, quantity, against;
    std::optional<SpeedErrorPoint> within_5, within_10;  ///< with the relative error
    std::optional<SpeedErrorPoint> best;                 ///< the smallest error of all
};

/// The effect of leaving out one ingredient of the model; from DIR/ablation.json.
struct AblationRow {
    std::string scene;
    double dx = 0;
    std::string ingredient;
    std::optional<double> core_s_ratio;  ///< without it over with it
    std::optional<double> error_change;  ///< of the scene's error, without it minus with it
    bool needed = false;
};

/// Whether a hard case was survived; from DIR/stress.json.
struct StressRow {
    std::string stress_case, setting;
    bool survived = false;
    std::string note;
    std::string picture = {};  ///< of the instability, relative to the directory; empty if there is none
};

/// Whether a run takes part in what is computed from several runs: it has reached its end.
inline bool counts(const RunSummary& run) {
    return run.record.status == RunStatus::ok;
}

/// A stored run of another set-up than that of the latest run of its scene: nothing of it is shown.
struct LeftOutRun {
    std::string directory;  ///< relative to the suite's directory
    std::string scene, variant;
    double dx = 0;                         ///< [m]
    std::vector<std::string> differences;  ///< in words, at least one
};

/// A statement of a scene's source against the runs; see statements.hpp.
struct StatementResult {
    std::string scene, says;
    std::string variant, against;  ///< against: variant, quantity, or the value that the source states
    std::string measure = {};      ///< in words
    double dx = 0;                 ///< of the runs [m]
    std::optional<double> value = {};
    std::string unit = "-";
    double low = 0, high = 0;  ///< the statement holds between them
    std::string note = {};     ///< why there is no value

    std::optional<bool> holds() const {
        return value ? std::optional(low <= *value && *value <= high) : std::nullopt;
    }
};

/// Whether a specification applies to a run.
inline bool applies(const AnalysisSpec& spec, const RunRecord& record) {
    return record.scene == spec.scene && (spec.variant.empty() || record.variant == spec.variant);
}

struct Summary {
    std::string tier;
    std::vector<AnalysisSpec> scenes;
    std::vector<RunSummary> runs;
    std::vector<ConvergenceRow> convergence;
    std::vector<CurveConvergenceRow> curve_convergence;
    std::vector<ValidationRow> validation;
    std::vector<ValidationRow> agreement;  ///< the same against exact solutions and other codes
    std::vector<ReplicateRow> replicates;
    std::vector<StatementResult> statements;
    std::vector<ScatterPoint> scatter;
    std::vector<ClassStatistics> statistics;
    std::vector<SpeedErrorPoint> speed_error;
    std::vector<VerificationProblem> verification;
    std::vector<PeerPoint> peers;
    std::vector<CheapestRow> cheapest;
    std::vector<SensitivityRow> sensitivity;
    std::vector<SoundSpeedRow> sound_speed;
    std::vector<AblationRow> ablation;
    std::vector<StressRow> stress;
    std::vector<RunDoubt> doubts;
    std::vector<LeftOutRun> left_out;
    std::vector<std::string> missing;  ///< runs that the tier asks for and the directory lacks
};

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// What a scene file asks of its runs: quantities of interest and comparisons with references.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "validation/metrics/metric.hpp"
#include "validation/metrics/reference_kind.hpp"
#include "validation/metrics/window.hpp"

namespace wetdeck {

/// An instant that a run finds: the first at which a series goes through a level; see time_origin.hpp.
struct OriginEvent {
    enum class Crossing { either, falling, rising };
    std::string series;
    double level = 0;     ///< in the unit of the series
    double spacings = 0;  ///< particle spacings added to the level
    Crossing crossing = Crossing::either;
    bool counts_at_start = false;  ///< a falling series that starts below the level has crossed it then
    std::string meaning;           ///< "geometric contact of body"

    bool operator==(const OriginEvent&) const = default;
};

/// A number that the scene states, or an event.
struct TimeOrigin {
    double typed = 0;  ///< without an event [s, or m along a profile]
    std::optional<OriginEvent> event;
    std::string unit = {};  ///< that the scene states, or empty
};

/// How a series becomes a curve: ((time - x_offset) / x_scale, value / y_scale - y_offset); of a profile, the
/// row at one instant or the mean of an interval, with its abscissa in place of the time.
struct SeriesScaling {
    double x_offset = 0;  ///< where the scaled abscissa is zero: an instant [s], or a place [m]
    double x_scale = 1;   ///< SI units per unit of the scaled abscissa
    double y_scale = 1;   ///< SI units per unit of the scaled value
    double y_offset =
        0;  ///< subtracted from the scaled value (for example 2, where a front is counted from the gate)
    std::optional<double> instant = {};     ///< of the row of a profile, on the clock of the run [s]
    std::string origin = {};                ///< name of the time origin, empty if there is none
    std::optional<OriginEvent> event = {};  ///< of the time origin, instead of x_offset
    double interval = 0;  ///< from the instant on, over which a profile is averaged [s]; 0: the row

    bool operator==(const SeriesScaling&) const = default;
};

/// What is known of the units along one axis of a series.
struct AxisUnits {
    std::string series;      ///< SI unit of the values, or of the abscissa; empty: unknown
    std::string scale;       ///< name of the scale; empty: none
    std::string scale_unit;  ///< of a scale that has one; empty: a plain number
};

/// Both axes, and where the scene file asks for them: "FILE:LINE: key '...'".
struct SeriesUnits {
    AxisUnits x, y;
    std::string place;
};

/// A place on a curve that several quantities of a scene make up: pressure against the size of a patch, say.
struct CurvePlace {
    std::string title;  ///< the same for all quantities of the curve
    std::string label;  ///< of the abscissa, with its unit
    double x = 0;
};

/// A scalar taken from one series. Abscissa and ordinate are divided by the scales before anything else.
struct QuantitySpec : SeriesScaling {
    SeriesUnits units;
    std::string name;
    const Metric* metric = nullptr;  ///< a row of metrics()
    std::string series;
    std::optional<Window> window;
    std::optional<double> threshold;
    std::string reference;  ///< as in ComparisonSpec, for a metric that needs one
    std::string y_column;   ///< column of the reference
    std::string unit = "-";
    /// The expected value, if one is known, its tolerance and its source.
    std::optional<double> expected;
    std::optional<double> tolerance;
    std::string expected_source;
    std::optional<ReferenceKind> expected_kind;         ///< empty if the scene does not say
    std::optional<double> expected_uncertainty;         ///< standard, k = 1, in the unit; empty if unknown
    std::string assumed_reason = {};                    ///< of a judgement; empty: the uncertainty is stated
    std::optional<double> required;                     ///< relative accuracy that the user asks for
    std::vector<std::pair<std::string, double>> lines;  ///< values of other methods by name, to be drawn
    std::optional<CurvePlace> curve;
};

/// One pair of curves: a series against a column of a reference file.
struct ComparisonSpec : SeriesScaling {
    SeriesUnits units;
    std::string title;
    std::string quantity;   ///< name of the series
    std::string reference;  ///< file stem in reference_data/SCENE/, or "analytic:NAME key=value ..."
    std::string x_column;
    std::string y_column;
    std::optional<Window> window;  ///< where the metrics are taken; the whole overlap if absent
    double tolerance = 0;          ///< on nrmse: rms difference over the range of the reference in the window
    std::string x_label;
    std::string y_label;
    bool judged = true;  ///< else the reference is drawn beside the others and nothing is measured
    std::optional<double> required = {};  ///< relative accuracy that the user asks for
    bool align_peaks = false;             ///< each curve is shifted until its largest value is at zero
};

/// A reference file of the scene that no comparison uses.
struct UnusedReference {
    std::string file;  ///< stem in reference_data/SCENE/
    std::string reason;
};

/// A value in the source, what the scene uses instead, and why.
struct Deviation {
    std::string item;
    std::string source;
    std::string used;
    std::string reason;
};

/// An input that is varied alone to find the effect of its uncertainty on the results.
struct SensitivitySpec {
    std::string key;  ///< dotted, as for --set
    double low = 0, high = 0;
    double uncertainty = 0;  ///< standard, k = 1, in the unit of the key
    std::string source;      ///< of the uncertainty, or the reason for which it is assumed
    bool assumed = false;    ///< a judgement: nobody states it
    std::vector<std::string> low_with, high_with;  ///< KEY=VALUE that must change with the key
};

/// The key that tells replicates from each other: the seed of an arrangement of the particles, 0 the lattice.
inline constexpr const char* arrangement_key = "initial.arrangement";

/// The key that the study of the sound speed varies, and its shares of the variant's own.
inline constexpr const char* sound_speed_key = "water.sound_speed";
inline constexpr double sound_speed_shares[] = {0.5, 2.0};

/// The cost of the source's own computation.
struct SourceRun {
    double particles = 0;
    double steps = 0;
    std::string conditions;  ///< its spacing, its step, its time, and where they are stated
};

/// A measured or computed curve of others that a figure of the source shows.
struct SourceCurve {
    std::string reference;   ///< file stem in reference_data/SCENE/
    bool available = false;  ///< the file exists; the analysis finds out
};

/// A figure of a source of the scene, and where the report shows the same.
struct SourceFigure {
    std::string number;  ///< as printed in the source, "3" or "12a"
    std::string shows;
    std::vector<std::string> places;  ///< anchors of the report; those that exist are linked
    std::string remark;
    std::string source;                    ///< citation
    std::vector<SourceCurve> curves = {};  ///< of others, beside the source's own
};

/// A statement in the text of the scene's source that relates two runs, or two quantities of one run.
struct SourceStatement {
    enum class Measure { difference, ratio, curve_difference };
    std::string says;                   ///< the statement in own words
    std::vector<std::string> variants;  ///< it is judged for each of them ...
    std::vector<std::string> against;   ///< ... against the variant in the same place; empty: the same run
    Measure measure = Measure::difference;
    std::string quantity;          ///< of the variant; for a curve difference the name of a series
    std::string against_quantity;  ///< the same unless the statement relates two quantities
    std::optional<Window> window;  ///< of a curve difference, on the clock of the run [s]
    double low = 0, high = 0;      ///< the measure of the statement lies between them; may be infinite
};

/// Variants that the report shows beside each other: their fields at one time, or one series of all.
struct SideBySide {
    std::string title;
    std::vector<std::string> variants;
    std::optional<double> time;  ///< of the fields, on the clock of the run [s]
    std::string series;          ///< drawn for all variants; empty: none
};

/// The part of a scene that analysis and report need.
struct AnalysisSpec {
    std::string scene;
    std::string variant;  ///< to which it applies; empty: all variants
    std::string title;
    std::string purpose;
    std::string source;
    std::vector<QuantitySpec> quantities;
    std::vector<ComparisonSpec> comparisons;
    std::map<std::string, TimeOrigin> origins;  ///< by name
    std::vector<std::string> stated_contacts;   ///< origins named after a contact that are numbers
    std::vector<OriginEvent> contacts;          ///< geometric, of each body
    double sample_interval = 0;                 ///< of the series [s]
    std::vector<std::string> probes;            ///< names of the series of the scene's probes
    std::vector<SensitivitySpec> sensitivities;
    std::vector<std::string> sound_speed_variants;    ///< run at other sound speeds, too
    std::vector<std::string> twice_sound_speed_with;  ///< KEY=VALUE of the run at twice the sound speed
    double sound_speed = 0;                           ///< of the water in this variant [m/s]
    std::vector<std::string> replicated_variants;     ///< run with disturbed arrangements of the particles
    int replicates = 20;                              ///< of each, unless the suite is told otherwise
    std::vector<Deviation> deviations;
    std::vector<SourceFigure> source_figures;
    std::vector<SourceStatement> statements;
    std::vector<SideBySide> side_by_side;
    std::vector<UnusedReference> unused_references;
    std::vector<std::string> limits;  ///< statements of what was not shown
    std::optional<SourceRun> source_run;
    std::string error_quantity;  ///< the quantity whose error the speed-error diagram shows
    std::string default_variant;
    bool expected_unstable =
        false;                     ///< the variant is known to become unstable: that is a result, no failure
    std::filesystem::path folder;  ///< of the scene file: its own curves come before those of the program
};

}  // namespace wetdeck

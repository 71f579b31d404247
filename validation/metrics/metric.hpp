// SPDX-License-Identifier: BSD-3-Clause
// Metrics: the ways to take one number from a series. One table drives the reading of scene files, the
// evaluation, the statistics, the messages and the documentation: a new metric is a row and a function in
// metric.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/core/curve.hpp"
#include "validation/metrics/window.hpp"

namespace wetdeck {

/// How the unit of the number follows from those of the series and of its abscissa.
enum class Dimension { series, abscissa, series_per_abscissa, series_times_abscissa };

/// What a scene file must give besides the series, and how much of the window the run must have reached.
struct MetricNeeds {
    bool threshold = false;
    bool reference = false;     ///< a curve, its column and a window
    bool whole_window = false;  ///< else a run may end inside the window
};

/// What a metric is taken from; all on scaled axes.
struct MetricInput {
    const Curve& series;     ///< the whole series
    const Curve& part;       ///< the series inside the window, with interpolated ends
    Window window;           ///< of the scene file, or the extent of the series
    double threshold = 0;    ///< if the metric needs one
    const Curve& reference;  ///< if the metric needs one, else empty
};

/// A number, or why there is none.
struct MetricResult {
    std::optional<double> value;
    std::string note;
};

struct Metric {
    const char* name;
    Dimension dimension;
    MetricNeeds needs;
    bool is_error;  ///< measures a deviation or a scatter: no experiment gives a value for it
    const char* meaning;
    MetricResult (*evaluate)(const MetricInput&);
};

/// All metrics, in the order in which messages list them.
const std::vector<Metric>& metrics();
std::vector<std::string> metric_names();

/// The metric of that name; it lives as long as the program. Throws InputError that lists the names.
const Metric& metric_named(const std::string& name);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The result of a sweep: the quantities of one scene over a grid of the values of its keys.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "validation/metrics/specification.hpp"

namespace wetdeck {

/// A key of a scene file and the values that it takes: evenly spaced, both ends among them.
struct SweepAxis {
    std::string key;  ///< dotted, as for --set
    double from = 0, to = 0;
    int count = 1;
    std::string unit;  ///< of the values as written, "deg"; empty: that of the key

    double value(int number) const { return count == 1 ? from : from + (to - from) * number / (count - 1); }
    /// "deadrise [deg]"; without the table [parameters] in front.
    std::string title() const;
};

/// One quantity at one point; see QuantityResult.
struct SweepQuantity {
    std::string name, unit;
    std::optional<double> value;
    std::string note;             ///< why there is none
    std::optional<double> u_num;  ///< standard uncertainty of the spacing; empty with fewer than three
    std::optional<double> expected, tolerance;
    std::vector<std::pair<std::string, double>> lines;  ///< values of other methods by name
    std::optional<CurvePlace> curve;
};

struct SweepPoint {
    std::vector<double> at;   ///< one value for each axis, in its unit
    std::string status;       ///< of the finest run: ok, unstable, failed or missing
    std::string directory;    ///< relative to that of the sweep
    std::vector<double> dx;   ///< of the runs that reached their end [m], coarse to fine
    double core_seconds = 0;  ///< of all runs of the point
    std::vector<SweepQuantity> quantities = {};
};

struct SweepResult {
    std::string scene, variant, title, purpose;
    std::vector<SweepAxis> axes;
    std::vector<SweepPoint> points;  ///< the first axis changes fastest
    std::string expected_source;     ///< of the expected values, as the scene says
    std::vector<std::pair<std::string, std::string>> provenance;  ///< of the runs: name and value
};

/// One row a point: the values of the keys, then for each quantity its value, u_num and what is expected, in
/// the unit in brackets; an empty cell is a number that is not known. Lines that begin with # say what it is.
std::string sweep_csv(const SweepResult& result);

}  // namespace wetdeck

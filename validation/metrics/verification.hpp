// SPDX-License-Identifier: BSD-3-Clause
// Results of problems with exact solutions, as plain data: what verification.json, summary.json and the
// report show. A problem states each of its claims before it is run; whether a claim held is decided here, by
// one rule.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/core/curve.hpp"
#include "validation/metrics/window.hpp"

namespace wetdeck {

/// The bound and the order that a problem states for one of its errors before it is run.
struct Claim {
    std::string quantity;    ///< name of the error
    std::string meaning;     ///< the difference and its scale, in words
    std::string resolution;  ///< its definition: "dx / depth"
    double bound = 0;        ///< largest error at the coarsest resolution
    std::optional<Window>
        order;           ///< range of the slope of log error over log resolution; empty: none expected
    std::string reason;  ///< where the bound and the order come from
    std::string known_miss = {};  ///< why the scheme misses the claim, and by how much; empty: it should hold
};

/// A claim and its result. Resolutions are lengths (or amplitudes): smaller is finer. Coarse to fine.
struct VerificationRow {
    Claim claim;
    std::vector<double> resolution, error;
    std::optional<double> order;  ///< least-squares slope of log error over log resolution
    bool within = false;
};

struct LabelledCurve {
    std::string label;
    Curve curve;
};

/// Computed curves against the exact one.
struct VerificationFigure {
    std::string title, x_label, x_unit, y_label, y_unit;
    Curve exact;  ///< may be empty
    std::vector<LabelledCurve> computed;
};

struct VerificationProblem {
    std::string name, title;
    std::string exact;  ///< the exact solution, in words and formulas
    std::vector<VerificationRow> rows;
    std::vector<VerificationFigure> figures;
    std::vector<std::string> notes;  ///< claims that are missed, and why
    std::string unstable;            ///< where and how a run became unstable; empty if none did
    double wall_s = 0;
};

/// Slope of the least-squares line through (log resolution, log error); empty with fewer than two positive
/// errors.
std::optional<double> observed_slope(const std::vector<double>& resolution, const std::vector<double>& error);

/// Fills order and within. A claim holds if every error is finite and at most
///     bound (resolution / coarsest resolution)^(low end of the order's range, 0 without one)
/// and the order, where one is expected, lies in its range.
void judge(VerificationRow& row);

/// Whether a run of one of the problems became unstable.
bool any_unstable(const std::vector<VerificationProblem>& problems);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The curve that a series is compared with, or the reason why there is none.
#pragma once

#include <string>

#include "validation/metrics/quantities.hpp"

namespace wetdeck {

/// Which columns of which reference are compared with a series, on which axes.
struct ReferenceRequest {
    const SeriesScaling& scaling;
    const SeriesUnits& units;
    const std::string& series;
    const std::string& reference;
    std::string x_column;  ///< empty: the first one
    const std::string& y_column;
};
ReferenceRequest request_of(const ComparisonSpec& spec);
ReferenceRequest request_of(const QuantitySpec& spec);

struct ReferenceCurve {
    const Reference* reference = nullptr;
    std::size_t empty_cells = 0;                                          ///< of the column of the ordinate
    Curve curve;                                                          ///< scaled
    std::optional<StandardUncertainty> u_data = {}, u_data_assumed = {};  ///< of it, scaled
    std::optional<double> u_abscissa = {};  ///< standard, scaled; empty if unknown
    std::string problem;                    ///< why there is none; else empty
    bool unusable = false;                  ///< there is a reference, but it is not sound or not comparable
};

/// Never throws for the file of the reference: one that is missing, not sound, without the column, or of
/// another dimension than the series is a problem of this curve alone.
ReferenceCurve reference_curve(const ReferenceRequest& request, ReferenceShelf& references);

}  // namespace wetdeck

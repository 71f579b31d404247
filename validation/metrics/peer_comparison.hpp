// SPDX-License-Identifier: BSD-3-Clause
// How far other codes, and a run of this one, are from the same measurements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Of the comparisons of pressures (series in Pa) of one run.
struct PeerComparison {
    struct Name {
        std::string title, reference;  ///< of the comparison
    };
    struct Row {
        Name name;
        std::string series;  ///< of the run
        std::vector<std::optional<double>>
            rms;  ///< against each measured curve; empty where one is too short
    };
    Window window;               ///< common to all comparisons, scaled
    std::vector<Name> measured;  ///< experiments
    std::vector<Row> peers;      ///< peer simulations
    std::vector<Row> own;        ///< series of the run, one for each scaling
};

/// Root mean square differences (rms_difference) over the part of the common window that both curves span;
/// none where a curve does not span `required_coverage` of it. The same curve is taken once. Empty without
/// experiments, without peer simulations, or if the windows of the comparisons do not overlap.
std::optional<PeerComparison> compare_with_peers(const RunSummary& run);

}  // namespace wetdeck

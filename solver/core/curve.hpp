// SPDX-License-Identifier: BSD-3-Clause
// A sampled curve y(x), the common currency of probes, references and figures.
#pragma once

#include <vector>

namespace wetdeck {

/// Samples of y(x): x strictly increasing, same length as y, all finite.
struct Curve {
    std::vector<double> x;
    std::vector<double> y;
};

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// A sampled curve y(x), as probes, references and figures have it.
#pragma once

#include <vector>

namespace wetdeck {

/// Samples of y(x): x strictly increasing, same length as y, all finite.
struct Curve {
    std::vector<double> x;  ///< abscissae
    std::vector<double> y;  ///< values
};

}  // namespace wetdeck

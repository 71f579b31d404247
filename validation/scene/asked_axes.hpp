// SPDX-License-Identifier: BSD-3-Clause
// Where quantities and comparisons of a scene ask for times that its runs do not reach, or divide by one
// plain number what has two dimensions.
#pragma once

#include <string>
#include <vector>

#include "validation/scene/scene.hpp"

namespace wetdeck {

/// One line for each quantity and comparison of the variant whose window, threshold or instant lies after
/// the end of the run, wholly, or by more than a metric of the whole window bears, or that counts from an
/// instant after it. A contact is expected where the motion of the body leads to the water; times that count
/// from another event are not known before the run and pass.
std::vector<std::string> unreached_times(const Scene& scene);

/// The last time that a quantity or comparison of the variant asks for.
struct AskedTime {
    std::string name;  ///< "quantity 'force_peak'"
    std::string unit;  ///< of the series
    double last = 0;   ///< on the clock of the run, its end at the latest [s]
};

/// Of all that count from a known time.
std::vector<AskedTime> asked_times(const Scene& scene);

/// One line for each plain scale that divides values of two dimensions, such as seconds and pascals, and for
/// each scale with a unit that leaves one without a name.
std::vector<std::string> doubtful_scales(const Scene& scene);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/shown_frames.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace wetdeck {

std::vector<double> wanted_pictures(const Scene& scene, const std::string& variant) {
    constexpr std::size_t enough = 12;
    std::vector<double> times = scene.picture_times;
    if (variant != scene.analysis.default_variant) return times;
    for (std::size_t k = 1; times.size() < enough; ++k)
        times.push_back(scene.end_time * static_cast<double>(k) / enough);
    return times;
}

std::vector<double> shown_frames(const Scene& scene) {
    std::set<double> shown;
    for (const double wanted : wanted_pictures(scene, scene.variant)) {
        const auto nearest = std::min_element(
            scene.frame_times.begin(), scene.frame_times.end(),
            [wanted](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
        if (nearest != scene.frame_times.end()) shown.insert(*nearest);
    }
    return {shown.begin(), shown.end()};
}

}  // namespace wetdeck

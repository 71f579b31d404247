// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/wet_bodies.hpp"

#include <algorithm>

namespace wetdeck {

bool starts_in_water(const Scene& scene, const BodySpec& body) {
    return std::any_of(scene.water_boxes.begin(), scene.water_boxes.end(),
                       [&](const Box& box) { return overlap(body.outline, corners_of(box)); });
}

}  // namespace wetdeck

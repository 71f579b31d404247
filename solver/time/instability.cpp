// SPDX-License-Identifier: BSD-3-Clause
#include "solver/time/instability.hpp"

#include <cstdio>

namespace wetdeck {

std::string Instability::describe() const {
    char name[32] = "";
    if (particle) std::snprintf(name, sizeof name, ", particle %u", *particle);
    char text[288];
    std::snprintf(text, sizeof text, "at t = %.6g s (step %llu): %s%s at (%.4g, %.4g) m", time,
                  static_cast<unsigned long long>(step), quantity.c_str(), name, position.x(), position.y());
    return text;
}

}  // namespace wetdeck

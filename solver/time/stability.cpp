// SPDX-License-Identifier: BSD-3-Clause
#include "solver/time/stability.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace wetdeck {

std::string Instability::describe() const {
    char name[32] = "";
    if (particle) std::snprintf(name, sizeof name, ", particle %u", *particle);
    char text[288];
    std::snprintf(text, sizeof text, "at t = %.6g s (step %llu): %s%s at (%.4g, %.4g) m", time,
                  static_cast<unsigned long long>(step), quantity.c_str(), name, position.x(), position.y());
    return text;
}

namespace {

double highest_ratio_of_air(const Model& model) {
    const double c = model.water.eos.sound_speed;
    const double impact = highest_impact_mach_number * model.water.eos.reference_density * c * c;
    const TaitEquationOfState& air = model.air.eos;
    if (!(air.coefficient() > 0)) return highest_density_ratio;  // there is none
    const double ratio = std::pow(1 + impact / air.coefficient(), 1 / air.exponent);
    return std::max(highest_density_ratio, ratio);
}

}  // namespace

StabilityBounds::StabilityBounds(const Model& model, Box domain, double margin)
    : reference_densities_{model.water.eos.reference_density, model.air.eos.reference_density},
      lowest_densities_{lowest_density_ratio * reference_densities_[0],
                        lowest_density_ratio * reference_densities_[1]},
      highest_densities_{highest_density_ratio * reference_densities_[0],
                         highest_ratio_of_air(model) * reference_densities_[1]},
      highest_speeds_{highest_mach_number * model.water.eos.sound_speed,
                      highest_mach_number * model.air.eos.sound_speed},
      tank_{{model.mirror_x ? -std::numeric_limits<double>::infinity() : domain.low.x(), domain.low.y()},
            domain.high},
      outer_{domain.low - Vec2::Constant(margin), domain.high + Vec2::Constant(margin)} {}

Instability StabilityBounds::instability_of(const FluidParticles& fluid, std::size_t particle) const {
    const FluidState& bad = fluid.state[particle];
    const bool escaped =
        (bad.position() - outer_.low).minCoeff() <= 0 || (outer_.high - bad.position()).minCoeff() <= 0;
    char text[160];
    std::snprintf(text, sizeof text, "%s density %.4g kg/m3 and speed %.4g m/s %s",
                  fluid.phase(particle) == Phase::water ? "water" : "air", bad.density, bad.velocity().norm(),
                  escaped ? "escaped from the tank" : "left the range of a fluid");
    return {0, 0, fluid.id[particle], bad.position(), text};
}

std::optional<Instability> StabilityBounds::of_bodies(const std::vector<RigidBody>& bodies) const {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody& body = bodies[b];
        const double fastest = body.fastest();
        const bool in_tank =
            (body.position - tank_.low).minCoeff() > 0 && (tank_.high - body.position).minCoeff() > 0;
        if (in_tank && fastest < highest_speeds_[0]) continue;
        char text[160];
        std::snprintf(text, sizeof text, "body %zu with speed %.4g m/s %s", b + 1, fastest,
                      in_tank ? "left the range of a body" : "left the tank");
        return Instability{0, 0, std::nullopt, body.position, text};
    }
    return std::nullopt;
}

}  // namespace wetdeck

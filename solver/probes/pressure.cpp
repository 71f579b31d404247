// SPDX-License-Identifier: BSD-3-Clause
#include "solver/probes/pressure.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {
constexpr int height_count = 16;
}

WallPressureProbe::WallPressureProbe(Vec2 centre, double diameter) : centre_(centre), diameter_(diameter) {
    double sum = 0;
    for (int k = 0; k < height_count; ++k) {
        const double offset = ((k + 0.5) / height_count - 0.5) * diameter;
        height_.push_back(centre.y() + offset);
        weight_.push_back(std::sqrt(0.25 * diameter * diameter - offset * offset));
        sum += weight_.back();
    }
    for (double& weight : weight_) weight /= sum;
}

void WallPressureProbe::check(double particle_spacing) const {
    if (diameter_ >= particle_spacing * (1 - 1e-9)) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "a pressure gauge of %.4g m is smaller than the particle spacing %.4g m: too few particles "
                  "to average",
                  diameter_, particle_spacing);
    throw InputError(text);
}

double WallPressureProbe::sample(const Simulation& simulation) const {
    const WendlandC2 kernel = simulation.kernel();
    const double reach = kernel.support_radius();
    std::array<double, height_count> pressure_sum{}, weight_sum{};
    const FluidParticles& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        if (std::abs(p.x - centre_.x()) > reach || std::abs(p.y - centre_.y()) > reach + 0.5 * diameter_)
            continue;
        const Model& model = simulation.model();
        const TaitEquationOfState& eos = fluid.phase(i) == Phase::water ? model.water.eos : model.air.eos;
        for (std::size_t k = 0; k < height_count; ++k) {
            const double weight = p.volume * kernel.value(std::hypot(p.x - centre_.x(), p.y - height_[k]));
            pressure_sum[k] += weight * (p.pressure - eos.background_pressure);
            weight_sum[k] += weight;
        }
    }
    double mean = 0;
    for (std::size_t k = 0; k < height_count; ++k) {
        mean += weight_[k] * pressure_sum[k] / std::max(weight_sum[k], 0.25);
    }
    return mean;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "solver/particles/mixed.hpp"

#include <cmath>

namespace wetdeck {

MixedFluid::MixedFluid(Box domain, double support_radius) {
    const Vec2 length = domain.high - domain.low + Vec2::Constant(8 * support_radius);
    fixed_point_.per_metre = std::exp2(32 - std::ceil(std::log2(length.maxCoeff())));
    const Vec2 centre = 0.5 * (domain.low + domain.high);
    constexpr std::uint32_t half_period = std::uint32_t{1} << 31;
    nowhere_.x = fixed_point_.fixed(centre.x()) + half_period;
    nowhere_.y = fixed_point_.fixed(centre.y()) + half_period;
}

void MixedFluid::copy(const FluidState* fluid, std::size_t count, int threads) {
    state_.resize(count);
    const auto size = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::int64_t n = 0; n < size; ++n) {
        const auto i = static_cast<std::size_t>(n);
        state_[i] = fixed_point_(fluid[i]);
    }
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/periodic_images.hpp"

#include <algorithm>

#include "solver/core/errors.hpp"

namespace wetdeck {

PeriodicImages::PeriodicImages(Box domain, double depth)
    : low_(domain.low.x()), high_(domain.high.x()), depth_(depth) {
    if (high_ - low_ < depth)
        throw InputError("a periodic domain must be two supports of the kernel and two skins wide");
}

void PeriodicImages::wrap(FluidParticles& fluid) const {
    const double period = high_ - low_;
    for (FluidState& p : fluid.state) {
        if (p.x < low_) p.x += period;
        if (p.x >= high_) p.x -= period;  // also where the sum above was rounded to the end
    }
}

void PeriodicImages::choose(const FluidParticles& fluid) {
    const double period = high_ - low_;
    images_.clear();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const auto source = static_cast<std::uint32_t>(i);
        const double x = fluid.state[i].x;
        if (x < low_ + depth_) images_.push_back({source, period});
        if (x >= high_ - depth_) images_.push_back({source, -period});
    }
}

void PeriodicImages::reorder(const std::vector<std::uint32_t>& order) {
    reordered_.clear();
    for (const std::uint32_t n : order) reordered_.push_back(images_[n]);
    std::swap(images_, reordered_);
}

const FluidState* PeriodicImages::appended_to(const FluidParticles& fluid) const {
    all_.resize(fluid.size() + images_.size());
    auto next = std::copy(fluid.state.begin(), fluid.state.end(), all_.begin());
    for (const Image& image : images_) {
        *next = fluid.state[image.source];
        next->x += image.shift;
        ++next;
    }
    return all_.data();
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/domain_images.hpp"

#include <algorithm>

#include "solver/core/errors.hpp"

namespace wetdeck {

DomainImages::DomainImages(DomainEnds ends, Box domain, double depth)
    : mirrors_(ends == DomainEnds::mirror_left), low_(domain.low.x()), high_(domain.high.x()), depth_(depth) {
    if (high_ - low_ < depth)
        throw InputError(std::string(mirrors_ ? "half a domain" : "a periodic domain") +
                         " must be two supports of the kernel and two skins wide");
}

void DomainImages::wrap(FluidParticles& fluid) const {
    const double period = high_ - low_;
    for (FluidState& p : fluid.state) {
        if (mirrors_) {
            if (p.x >= low_) continue;
            p.x = 2 * low_ - p.x;
            p.vx = -p.vx;
            continue;
        }
        if (p.x < low_) p.x += period;
        if (p.x >= high_) p.x -= period;  // also where the sum above was rounded to the end
    }
}

void DomainImages::choose(const FluidParticles& fluid) {
    const double period = high_ - low_;
    images_.clear();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const auto source = static_cast<std::uint32_t>(i);
        const double x = fluid.state[i].x;
        if (mirrors_) {
            if (x < low_ + depth_) images_.push_back({source, -1, 2 * low_});
            continue;
        }
        if (x < low_ + depth_) images_.push_back({source, 1, period});
        if (x >= high_ - depth_) images_.push_back({source, 1, -period});
    }
}

void DomainImages::reorder(const std::vector<std::uint32_t>& order) {
    reordered_.clear();
    for (const std::uint32_t n : order) reordered_.push_back(images_[n]);
    std::swap(images_, reordered_);
}

const FluidState* DomainImages::appended_to(const FluidParticles& fluid) const {
    all_.resize(fluid.size() + images_.size());
    auto next = std::copy(fluid.state.begin(), fluid.state.end(), all_.begin());
    for (const Image& image : images_) {
        *next = fluid.state[image.source];
        next->x = image.sign * next->x + image.shift;
        next->vx *= image.sign;
        ++next;
    }
    return all_.data();
}

}  // namespace wetdeck

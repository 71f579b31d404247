// SPDX-License-Identifier: BSD-3-Clause
// Fluid near either end of a domain that is periodic along x, once more beyond the other end. Images are
// neighbours like any other particle and owners of nothing: they are copies of their sources, made anew
// before each pass.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/core/vec2.hpp"
#include "solver/particles/fluid.hpp"

namespace wetdeck {

class PeriodicImages {
  public:
    struct Image {
        std::uint32_t source;
        double shift;  ///< of x [m]
    };

    /// @param depth  how far beyond the ends images are needed [m]. Throws InputError for a domain that is
    /// narrower: a particle would need several at one end.
    PeriodicImages(Box domain, double depth);

    /// Takes particles that have left at one end in at the other.
    void wrap(FluidParticles& fluid) const;

    /// Chooses the images that the fluid needs where it stands, in the order of their sources.
    void choose(const FluidParticles& fluid);
    const std::vector<Image>& images() const { return images_; }
    void reorder(const std::vector<std::uint32_t>& order);

    /// The fluid as it is now with its images behind it; valid until the next call.
    const FluidState* appended_to(const FluidParticles& fluid) const;

  private:
    double low_, high_, depth_;
    std::vector<Image> images_, reordered_;
    mutable std::vector<FluidState> all_;  ///< scratch of appended_to
};

}  // namespace wetdeck

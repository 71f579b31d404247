// SPDX-License-Identifier: BSD-3-Clause
// Fluid near the ends of a domain, once more beyond them: of a domain that is periodic along x, shifted to
// the other end; of one whose left end is a plane of symmetry, reflected there. Images are neighbours like
// any other particle and owners of nothing: they are copies of their sources, made anew before each pass.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/core/domain_ends.hpp"
#include "solver/core/vec2.hpp"
#include "solver/particles/fluid.hpp"

namespace wetdeck {

class DomainImages {
  public:
    struct Image {
        std::uint32_t source;
        double sign;   ///< of x and of the velocity along it: -1 for a reflection
        double shift;  ///< of x, after the sign [m]

        Vec2 place(Vec2 at) const { return {sign * at.x() + shift, at.y()}; }
        Vec2 turn(Vec2 vector) const { return {sign * vector.x(), vector.y()}; }
    };

    /// @param depth  how far beyond the ends images are needed [m]. Throws InputError for a domain that is
    /// narrower: a particle would need several at one end.
    DomainImages(DomainEnds ends, Box domain, double depth);

    /// Changes that depth; the domain has room for the largest [m].
    void set_depth(double depth) { depth_ = depth; }
    double largest_depth() const { return high_ - low_; }

    /// Takes particles that have left at one end in at the other, or back from behind the plane.
    void wrap(FluidParticles& fluid) const;

    /// Chooses the images that the fluid needs where it stands, in the order of their sources.
    void choose(const FluidParticles& fluid);
    const std::vector<Image>& images() const { return images_; }
    void reorder(const std::vector<std::uint32_t>& order);

    /// The fluid as it is now with its images behind it; valid until the next call.
    const FluidState* appended_to(const FluidParticles& fluid) const;

  private:
    bool mirrors_;
    double low_, high_, depth_;
    std::vector<Image> images_, reordered_;
    mutable std::vector<FluidState> all_;  ///< scratch of appended_to
};

}  // namespace wetdeck

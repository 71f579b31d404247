// SPDX-License-Identifier: BSD-3-Clause
// The bounds of a stable state: what ends a run, and why.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "solver/bodies/flow.hpp"
#include "solver/physics/density_bounds.hpp"
#include "solver/physics/model.hpp"

namespace wetdeck {

/// Speeds beyond this multiple of the sound speed end a run; with the bound on densities that keeps the step,
/// C h/(c + v), from creeping towards zero.
inline constexpr double highest_mach_number = 10;

/// So do densities beyond this multiple of the reference, or, for air, beyond that at which it bears the
/// pressure of water that stops at a tenth of its sound speed: air that is caught under a plate is
/// squeezed that far.
inline constexpr double highest_density_ratio = 10, highest_impact_mach_number = 0.1;

/// Why a run cannot go on.
struct Instability {
    double time = 0;                        ///< [s]
    std::uint64_t step = 0;                 ///< steps done by then
    std::optional<std::uint32_t> particle;  ///< id; none where a body is unstable
    Vec2 position = Vec2::Zero();           ///< of the particle or of the body [m]
    std::string quantity;                   ///< what left its range, with its value

    /// One sentence for a person.
    std::string describe() const;
};

/// The ranges that particles and bodies must stay in.
class StabilityBounds {
  public:
    /// @param margin  how far beyond the tank a particle may be [m]
    StabilityBounds(const Model& model, Box domain, double margin);

    /// Whether a particle is within its ranges; its density rate must be a number, too, because the bounds of
    /// the density would hide one that is not.
    bool hold(const FluidState& p, double density_rate, Phase phase) const {
        const auto k = static_cast<std::size_t>(phase);
        // no branches: all of them hold for all particles of a sound step
        int sound = density_rate == density_rate;
        sound &= p.density > lowest_densities_[k];
        sound &= p.density < highest_densities_[k];
        sound &= p.vx * p.vx + p.vy * p.vy < highest_speeds_[k] * highest_speeds_[k];
        sound &= p.x > outer_.low.x();
        sound &= p.y > outer_.low.y();
        sound &= p.x < outer_.high.x();
        sound &= p.y < outer_.high.y();
        return sound != 0;
    }
    /// What is wrong with a particle that is not; time and step are left to the caller.
    Instability instability_of(const FluidParticles& fluid, std::size_t particle) const;
    /// The first body that has left the tank or its range of speeds. The fluid does not notice it: nothing is
    /// near.
    std::optional<Instability> of_bodies(const std::vector<RigidBody>& bodies) const;

    /// Of water and air [kg/m^3].
    const std::array<double, phase_count>& reference_densities() const { return reference_densities_; }

  private:
    std::array<double, phase_count> reference_densities_, lowest_densities_, highest_densities_,
        highest_speeds_;
    Box tank_, outer_;
};

}  // namespace wetdeck

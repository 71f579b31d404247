// SPDX-License-Identifier: BSD-3-Clause
// Every choice that a scene makes about the physics. Each ingredient is one enumeration or one number here
// and one file in physics/.
#pragma once

#include "solver/core/domain_ends.hpp"
#include "solver/core/vec2.hpp"
#include "solver/physics/contact.hpp"
#include "solver/physics/dissipation.hpp"
#include "solver/physics/equation_of_state.hpp"
#include "solver/physics/interparticle_mean.hpp"
#include "solver/physics/sponge.hpp"
#include "solver/physics/viscosity.hpp"
#include "solver/physics/wall_boundary.hpp"

namespace wetdeck {

/// One fluid.
struct Material {
    TaitEquationOfState eos;  ///< pressure from density
    double viscosity = 0;     ///< dynamic [Pa s]

    /// rho0 c [kg/(m^2 s)]
    double impedance() const { return eos.reference_density * eos.sound_speed; }
};

/// Fluids, forces and scheme. The defaults are the scheme that docs/theory.md explains.
struct Model {
    Material water;                ///< phase 0
    Material air;                  ///< phase 1; unused where there is none
    Vec2 gravity = Vec2::Zero();   ///< [m/s^2]
    double central_frequency = 0;  ///< of a pull towards the origin, -frequency^2 r [1/s]; fluid only

    Mean velocity_mean = Mean::impedance_weighted;             ///< of the two particles in u*
    Mean pressure_mean = Mean::impedance_weighted;             ///< of the two particles in P*
    MeanGuard mean_guard = MeanGuard::division;                ///< of harmonic means
    ImpedanceMean impedance_mean = ImpedanceMean::arithmetic;  ///< of rho c in u*
    double pressure_diffusion = 1;       ///< factor on the pressure jump in u*, 1 is the Riemann value
    bool hydrostatic_correction = true;  ///< the jump counts only beyond the hydrostatic one
    Dissipation dissipation = Dissipation::low_dissipation;  ///< of approaching pairs
    double dissipation_slope = 10;          ///< of the limiter min(slope du / c, 1), water with water
    double air_dissipation = 0.03;          ///< share of the full Riemann dissipation in pairs with air
    Viscosity viscosity = Viscosity::none;  ///< form of the viscous force
    bool dissipation_switch = false;        ///< Yang et al. (2020), Eqs. (14)-(15)
    SwitchVelocity switch_velocity = SwitchVelocity::arithmetic;  ///< the switch's velocity factor, Eq. (14)
    WallSlip wall_slip = WallSlip::free;                          ///< whether walls drag the fluid along
    WallPressure wall_pressure = WallPressure::shepard_water;     ///< pressure of a dummy particle
    WallVelocity wall_velocity = WallVelocity::mirrored;          ///< velocity of a dummy particle
    WallPairMean wall_pair_mean = WallPairMean::arithmetic;       ///< of the pressures in P* at a wall
    bool wall_pressure_jump = false;  ///< the pressure jump of Eq. (17) enters u* at a wall
    double wall_dissipation = 3;      ///< limiter slope of the wall-normal dissipation, 0 for none
    double sponge_thickness = 0;      ///< of the layer along the tank's walls [m], 0 for none
    SpongeRamp sponge_ramp = SpongeRamp::exponential;  ///< reading of Eq. (25)
    bool negative_pressure = true;  ///< false: density is kept at or above the reference (water without air)
    double full_kernel_sum = 0.9;   ///< kernel sum from which the density of water may rise, 0 for any
    bool wall_wetting = true;       ///< water without air feels a wall once it touches it

    ContactLaw contact;  ///< of bodies with the tank and each other

    bool periodic_x = false;  ///< the domain's left and right end are joined; no bodies, no sponge

    bool mirror_x = false;  ///< the domain's left end is a plane of symmetry of fluid and bodies

    double smoothing_ratio = 1.5;  ///< smoothing length / particle spacing
    double courant_number = 0.5;   ///< of the acoustic criterion, Eq. (26) has 0.25
    double fixed_step = 0;         ///< size of every step [s], 0: the stable step, Eq. (26)
    int air_substeps = 1;          ///< steps of the air in one of the water, odd; 0: from the sound speeds
    int coarse_substeps = 1;       ///< of fine water in one of coarse, odd; 0: as many as pay

    /// What is beyond the ends of the domain.
    DomainEnds ends() const {
        return mirror_x ? DomainEnds::mirror_left : periodic_x ? DomainEnds::periodic : DomainEnds::walls;
    }
};

}  // namespace wetdeck

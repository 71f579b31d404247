// SPDX-License-Identifier: BSD-3-Clause
// Contact of bodies with the tank and with each other, corner by corner, under the law of
// physics/contact.hpp.
//
// The effective mass of corner i is 1 / a_i, with a_i its approach under unit forces at all corners that
// touch the same surface: the restitution is that of the law for one corner and for a flat face alike.
#pragma once

#include <vector>

#include "solver/bodies/rigid_body.hpp"
#include "solver/core/vec2.hpp"
#include "solver/physics/contact.hpp"

namespace wetdeck {

/// Sets the contact loads of all bodies in their present poses and motions.
void set_contact_loads(std::vector<RigidBody>& bodies, Box tank, const ContactLaw& law);

/// An upper bound of the angular frequency of the contacts of all corners that are in contact or closer to it
/// than `margin` [m]; 0 where there is none [1/s].
double contact_frequency(const std::vector<RigidBody>& bodies, Box tank, const ContactLaw& law,
                         double margin);

}  // namespace wetdeck

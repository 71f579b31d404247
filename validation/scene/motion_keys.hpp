// SPDX-License-Identifier: BSD-3-Clause
// The keys of given motions, springs, solids, planes of symmetry and differing spacings, in the form of
// scene_keys.cpp.
#pragma once

namespace wetdeck {

inline constexpr const char* motion_keys = R"(# Poses, motions, springs
body.outline.diameter | m | | positive number | in place of a list of corners: a circle about the origin |
body.outline.corners | - | 96 | 8 to 1000 | of the polygon that stands for the circle | sides of two spacings or less
body.angle | rad | 0 | number, or "8 deg" | heel at the start: the outline is drawn upright and turned about the mass centre, counter-clockwise |
body.density | kg/m^3 | | positive number | in place of `body.mass`: the mass follows from the area of the outline |
body.speed | m/s | | zero or a positive number | in place of velocity_x and velocity_y: speed at the start, in `body.direction` |
body.direction | rad | 0 | number, or "20 deg" | direction of `body.speed` from straight down, towards the right |
body.joined_to | | none | a body before this one | the outline is fixed to that body and moves with it, as the second hull of a catamaran: mass, inertia and
  mass centre of that body are those of both, and so are the forces that it records. Of the other keys only outline, mirrored and position apply |
body.pivot | m | none | [x, y] | a hinge, in the frame of the outline: this point stays where it is, or moves as `motion` says, and the body turns
  about it if "rotation" is in `free` |
body.release | s | 0 | positive number, or "contact" | until then the motions in `free` keep their velocity or follow `motion`; "contact": until water
  first touches the body |
body.motion | | none | "FILE.csv", or a table of formulas | motion that is given. A file has the columns t and one or more of x, y, angle, velocity_x,
  velocity_y, angular_velocity, with units in brackets, "t [ms]"; a motion between samples of x, y and angle is a monotone cubic, between
  velocities the velocity is linear. Displacements count from the start | a carriage signal as it was measured; samples closer than a tenth of
  the shortest time that matters
body.motion.x | | | table with a formula | given motion along x |
body.motion.y | | | table with a formula | given motion along y |
body.motion.rotation | | | table with a formula | given rotation |
body.motion.t | s | | list of numbers | times of samples, what a file stands for; beside it lists named as its columns |
body.motion.angle | rad | | list of numbers | rotation at these times |
body.motion.x.formula | | required | constant, ramp, harmonic or piecewise | form of the motion |
body.motion.x.velocity | m/s or rad/s | 0 | number, or "3 kn" | of constant: from the start on; of ramp: at its end and after |
body.motion.x.begins | s | 0 | zero or a positive number | of ramp: when the velocity begins to grow |
body.motion.x.over | s | required by ramp | positive number | of ramp: how long it grows |
  sound must cross the body many times meanwhile, or the added mass answers too late: 40 radii in the scene water_exit
body.motion.x.amplitude | m or rad | 0 | number, or "5 deg" | of harmonic |
body.motion.x.period | s | required by harmonic | positive number | of harmonic |
body.motion.x.phase | rad | 0 | number, or "90 deg" | of harmonic: amplitude sin(2 pi t / period + phase), less its value at the start |
body.motion.x.ramp | s | 0 | zero or a positive number | of harmonic: it grows to its size over this time | one or two periods
body.motion.x.times | s | required by piecewise | list of numbers | of piecewise: times of the velocities |
body.motion.x.velocities | m/s or rad/s | required by piecewise | list of numbers | of piecewise: linear between them |
body.springs[].direction | | required | x, y or rotation | a spring along a degree of freedom between the body and the earth |
body.springs[].rest | m or rad | 0 | number | displacement from the start at which it does not pull |
body.springs[].play | m or rad | none | [low, high] | displacements about the rest between which it does not act: an end stop |
body.springs[].on_body | m | | [x, y] | in place of `direction`: a line from this point of the body, in the frame of the outline |
body.springs[].on_earth | m | required by on_body | [x, y] | to this point of the tank |
body.springs[].free_length | m | that of the start | zero or a positive number | of the line |
body.springs[].slack | | false | true or false | the line pulls and never pushes: a rope |
body.springs[].stiffness | N/m^2 or N/rad | 0 | zero or a positive number | force per metre of span and metre of elongation |
  refused where the body would swing to and fro in fewer than twelve time steps
body.springs[].damping | N s/m^2 or N s/rad | 0 | zero or a positive number | force per metre of span and velocity |
body.springs[].table | | none | "FILE.csv", or rows [elongation, pull] | in place of `stiffness`: linear between the rows and beyond them |
tank.outline | m | | list of [x, y] | in place of `tank.size`: a polygon whose lowest x and y are 0. What it leaves of the box around it are
  solids named tank_wall, tank_wall_2, ... |
tank.motion | | none | "FILE.csv", or a table of formulas | sway (x), heave (y) and roll (rotation) of the tank in the earth's frame, as of a body.
  All positions and velocities of the run are those in the tank; energies are no longer kept there |
tank.roll_centre | m | required by a roll | [x, y] | point of the tank about which it rolls |
water.velocities | m/s | at rest | list of [x, y], one for each box | velocity of the water at the start |
solids[].outline | m | required | as `body.outline` | a solid that is fixed in the tank: step, beach, obstacle, baffle. Its sides may lie on the tank's
  faces; forces on it are recorded as those of bodies, behind the last body |
solids[].name | | solid, solid_2, ... | text | of the solid, for probes and messages |
solids[].position | m | [0, 0] | [x, y] | where the origin of the outline lies in the tank |
symmetry.x | m | none | the middle of the tank, or "none" | a plane of symmetry: the half to the right of it is computed, and forces, masses and energies are
  those of the whole; refused where anything is not symmetric | an upright section at half the cost
resolution.around | m | none: equal spacings | "body", "surface", [x, y] or [x_low, y_low, x_high, y_high] | where particles are finest, as fine as --dx says:
  a box around the bodies and where they go, the level, a point or a box. From there spacings grow. The water is one layer from wall to wall, without
  solids, and bodies lie in the box | a slam of some tens of milliseconds, in which far water hardly moves: "body"
resolution.growth | - | 0.05 | above 0, at most 0.2 | growth of the spacing from one particle to the next, away from the box | 0.05; at 0.1 twice the reflected
  sound for a few per cent less work
resolution.coarsest | - | 8 | 1 to 16 | largest spacing over the finest; 1: all are equal | 4 to 8
resolution.finest | m | | positive number | spacing of a run without --dx |
)";

}  // namespace wetdeck

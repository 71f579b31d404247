// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "solver/probes/front.hpp"
#include "solver/probes/phase_defects.hpp"
#include "validation/metrics/energy_budget.hpp"

namespace wetdeck {
namespace {

using Fluid = const Balance&;
using State = const Simulation&;
using Body = const BodyNow&;

std::vector<Vec2> corners(Body b) {
    std::vector<Vec2> placed;
    for (const Vec2& corner : b.outline) placed.push_back(b.body.placed(corner));
    return placed;
}

/// Height of the water at the start below or above x; of the scene's surface where there was none.
double level_at(Body b, double x) {
    std::optional<double> top;
    for (const Box& box : b.water)
        if (box.low.x() <= x && x <= box.high.x()) top = std::max(top.value_or(box.high.y()), box.high.y());
    return top.value_or(b.surface);
}

double clearance(Body b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& corner : corners(b)) least = std::min(least, corner.y() - level_at(b, corner.x()));
    return least;
}

double water_gap(Body b) {
    return gap_around(b.simulation, corners(b));
}

}  // namespace

const std::vector<FluidSeries>& every_run_series() {
    static const std::vector<FluidSeries> table = {
        {{"energy_kinetic", "J/m", "kinetic energy of all fluid"}, [](State, Fluid f) { return f.kinetic; }},
        {{"energy_potential", "J/m", "potential energy of all fluid, zero at the tank's corner"},
         [](State, Fluid f) { return f.potential; }},
        {{"energy_compression", "J/m", "elastic energy of all fluid against its reference density"},
         [](State, Fluid f) { return f.compression; }},
        {{"momentum_x", "N s/m", "momentum of all fluid along x"},
         [](State, Fluid f) { return f.momentum.x(); }},
        {{"momentum_y", "N s/m", "momentum of all fluid along y"},
         [](State, Fluid f) { return f.momentum.y(); }},
        {{"mass", "kg/m", "mass of all fluid"}, [](State, Fluid f) { return f.mass; }},
        {{"density_error_max", "-", "largest |rho/rho0 - 1| of the water"},
         [](State, Fluid f) { return f.water_density_error; }},
        {{"particles_outside", "-", "fluid particles beyond the tank's faces"},
         [](State, Fluid f) { return static_cast<double>(f.outside); }},
        {{"time_step", "s", "stable time step of the water"},
         [](State s, Fluid) { return s.time_step().size; }},
        {{"momentum_error", "-",
          "forces on all fluid less gravity and less the reactions on walls and bodies, over the sum of "
          "their sizes; at every 16th sample"},
         [](State s, Fluid) { return s.momentum_error(); },
         16}};  // it costs a pass over all pairs
    return table;
}

const std::vector<FieldSeries>& all_field_series() {
    using Outlines = std::span<const Outline>;
    static const std::vector<FieldSeries> table = {
        {{"void_area", "m^2",
          "area of the tank outside bodies farther than one spacing from every particle; at the field files"},
         FieldSeries::Needs::air,
         [](State s, Outlines o) { return void_area(s, o); }},
        {{"water_in_air", "-",
          "water particles that have less than a quarter water among their neighbours within two spacings; "
          "at "
          "the field files"},
         FieldSeries::Needs::air,
         [](State s, Outlines) { return static_cast<double>(mixed_particles(s).water_in_air); }},
        {{"air_in_water", "-",
          "air particles that have less than a quarter air among their neighbours within two spacings; at "
          "the "
          "field files"},
         FieldSeries::Needs::air,
         [](State s, Outlines) { return static_cast<double>(mixed_particles(s).air_in_water); }},
        {{"enclosed_air", "m^2",
          "volume a metre of span of the air that is cut off from the largest body of air; at the field "
          "files"},
         FieldSeries::Needs::air,
         [](State s, Outlines) { return enclosed_air(s); }},
        {{"particles_in_bodies", "-", "fluid particles whose centres lie inside a body; at the field files"},
         FieldSeries::Needs::bodies,
         [](State s, Outlines o) { return static_cast<double>(particles_in_bodies(s, o)); }},
        {{"coarsest_at_bodies", "-",
          "largest spacing of the fluid that touches a body, over the finest; at the field files"},
         FieldSeries::Needs::bodies_and_resolution,
         [](State s, Outlines) { return coarsest_at_bodies(s); }}};
    return table;
}

const std::vector<BodySeries>& recorded_body_series() {
    static const std::vector<BodySeries> table = {
        {{"body_x", "m", "mass centre"}, [](Body b) { return b.body.position.x(); }},
        {{"body_y", "m", "mass centre"}, [](Body b) { return b.body.position.y(); }},
        {{"body_angle", "rad", "counter-clockwise"}, [](Body b) { return b.body.angle; }},
        {{"body_velocity_x", "m/s", "of the mass centre"}, [](Body b) { return b.body.velocity.x(); }},
        {{"body_velocity_y", "m/s", "of the mass centre, up"}, [](Body b) { return b.body.velocity.y(); }},
        {{"body_angular_velocity", "rad/s", "counter-clockwise"},
         [](Body b) { return b.body.angular_velocity; }},
        {{"body_impulse_x", "N s/m", "time integral of the fluid's force since the start"},
         [](Body b) { return b.body.impulse.x(); }},
        {{"body_impulse_y", "N s/m", "time integral of the fluid's force since the start, up"},
         [](Body b) { return b.body.impulse.y(); }},
        {{"body_angular_impulse", "N s", "time integral of the fluid's torque about the mass centre"},
         [](Body b) { return b.body.angular_impulse; }},
        {{"body_work", "J/m", "work of the fluid on the body since the start"},
         [](Body b) { return b.body.work; }},
        {{"body_clearance", "m",
          "least height of the corners of the outline above the level that the water had there at the start"},
         clearance},
        {{"body_water_gap", "m", "distance from the outline to the nearest water, less half a spacing"},
         water_gap}};
    return table;
}

const std::vector<DerivedSeries>& derived_body_series() {
    static const std::vector<DerivedSeries> table = {
        {{"body_force_x", "N/m", "force of the fluid"}, "body_impulse_x"},
        {{"body_force_y", "N/m", "force of the fluid, without weight, up"}, "body_impulse_y"},
        {{"body_torque", "N", "torque of the fluid about the mass centre"}, "body_angular_impulse"},
        {{"body_acceleration_x", "m/s^2", "of the mass centre"}, "body_velocity_x"},
        {{"body_acceleration_y", "m/s^2", "of the mass centre, up"}, "body_velocity_y"},
        {{"body_force_y_filtered", "N/m", "force of the fluid, up"}, "body_impulse_y", true},
        {{"body_acceleration_y_filtered", "m/s^2", "of the mass centre, up"}, "body_velocity_y", true}};
    return table;
}

const std::vector<AnalysedSeries>& analysed_series() {
    static const std::vector<AnalysedSeries> table = {{{energy_loss_name, "-", energy_loss_description}}};
    return table;
}

std::string body_series_name(const std::string& name, std::size_t body) {
    return body == 0 ? name : fmt::format("{}_{}", name, body + 1);
}

}  // namespace wetdeck

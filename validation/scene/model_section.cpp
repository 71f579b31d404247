// SPDX-License-Identifier: BSD-3-Clause
// Materials and model ingredients: names in the file to choices of the solver. Defaults live in
// solver/physics/model.hpp.
#include <fmt/format.h>

#include <cmath>

#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

constexpr double atmospheric_pressure = 101325;  // [Pa]

template <class Enum>
struct Name {
    const char* name;
    Enum value;
};

template <class Enum, std::size_t count>
Enum named(const TomlTable& table, const std::string& key, Enum fallback, const Name<Enum> (&names)[count]) {
    if (!table.has(key)) return fallback;
    std::vector<std::string> all;
    for (const auto& entry : names) all.emplace_back(entry.name);
    const std::string chosen = table.choice(key, all);
    for (const auto& entry : names) {
        if (chosen == entry.name) return entry.value;
    }
    return fallback;
}

constexpr Name<Mean> means[] = {{"arithmetic", Mean::arithmetic},
                                {"density-weighted", Mean::density_weighted},
                                {"impedance-weighted", Mean::impedance_weighted},
                                {"harmonic", Mean::harmonic}};
constexpr Name<Dissipation> dissipations[] = {{"none", Dissipation::none},
                                              {"riemann", Dissipation::riemann},
                                              {"low-dissipation", Dissipation::low_dissipation}};
constexpr Name<Viscosity> viscosities[] = {
    {"none", Viscosity::none}, {"approaching", Viscosity::approaching}, {"symmetric", Viscosity::symmetric}};
constexpr Name<WallPressure> wall_pressures[] = {{"one-sided", WallPressure::one_sided},
                                                 {"shepard", WallPressure::shepard},
                                                 {"shepard-water", WallPressure::shepard_water}};
constexpr Name<WallVelocity> wall_velocities[] = {{"normal", WallVelocity::normal},
                                                  {"mirrored", WallVelocity::mirrored}};
constexpr Name<WallSlip> slips[] = {{"free", WallSlip::free}, {"no", WallSlip::no}};

Material read_material(const TomlTable& table) {
    Material material;
    material.eos.reference_density = table.positive("density");
    material.eos.exponent = table.positive("exponent");
    material.viscosity = table.number_or("viscosity", 0);
    if (material.viscosity < 0) table.fail("viscosity", "expected zero or a positive number");
    return material;
}

double air_sound_speed(const TomlTable& air, const Material& material, const Material& water) {
    const std::string law = air.choice("law", {"equal-coefficient", "physical", "sound-speed"});
    const std::optional<double> given = air.optional_number("sound_speed");
    const double density = material.eos.reference_density, exponent = material.eos.exponent;
    if (law == "equal-coefficient") return equal_coefficient_sound_speed(water.eos, density, exponent);
    if (law == "physical") return std::sqrt(exponent * atmospheric_pressure / density);
    if (!given || *given <= 0) air.fail("sound_speed", "the law 'sound-speed' needs a positive number [m/s]");
    return *given;
}

double share(const TomlTable& table, const std::string& key, double fallback) {
    const double value = table.number_or(key, fallback);
    if (!(value >= 0)) table.fail(key, fmt::format("is {}, expected zero or a positive number", value));
    return value;
}

}  // namespace

void read_model(const TomlTable& root, Scene& scene) {
    Model& m = scene.model;
    const std::vector<double> gravity = root.numbers("gravity", 2);
    m.gravity = {gravity[0], gravity[1]};

    const TomlTable water = root.table("water");
    m.water = read_material(water);
    m.water.eos.sound_speed = water.positive("sound_speed");

    const TomlTable model = root.table("model");
    scene.air = model.boolean_or("air", false);
    const std::optional<TomlTable> air = root.optional_table("air");
    if (scene.air && !air) root.fail("air", "missing: model.air = true needs a table [air]");
    if (air) {
        m.air = read_material(*air);
        m.air.eos.sound_speed = air_sound_speed(*air, m.air, m.water);
    }
    const double background = share(model, "background_pressure", 0);
    m.water.eos.background_pressure = m.air.eos.background_pressure = background;

    m.velocity_mean = named(model, "velocity_mean", m.velocity_mean, means);
    m.pressure_mean = named(model, "pressure_mean", m.pressure_mean, means);
    m.pressure_diffusion = share(model, "pressure_diffusion", m.pressure_diffusion);
    m.hydrostatic_correction = model.boolean_or("hydrostatic_correction", m.hydrostatic_correction);
    m.dissipation = named(model, "dissipation", m.dissipation, dissipations);
    m.dissipation_slope = share(model, "dissipation_slope", m.dissipation_slope);
    m.air_dissipation = share(model, "air_dissipation", m.air_dissipation);
    m.viscosity = named(model, "viscosity", m.viscosity, viscosities);
    m.dissipation_switch = model.boolean_or("dissipation_switch", m.dissipation_switch);
    m.wall_pressure = named(model, "wall_pressure", m.wall_pressure, wall_pressures);
    m.wall_velocity = named(model, "wall_velocity", m.wall_velocity, wall_velocities);
    m.wall_dissipation = share(model, "wall_dissipation", m.wall_dissipation);
    m.wall_slip = named(model, "wall_slip", m.wall_slip, slips);
    m.sponge_thickness = share(model, "sponge_thickness", m.sponge_thickness);
    m.tension = model.boolean_or("tension", scene.air);
    m.full_cover = share(model, "full_cover", m.full_cover);
    if (m.full_cover > 1) model.fail("full_cover", fmt::format("is {}, expected 0 to 1", m.full_cover));
    m.smoothing_ratio = model.number_or("smoothing_ratio", m.smoothing_ratio);
    if (!(m.smoothing_ratio >= 1 && m.smoothing_ratio <= 3)) {
        model.fail("smoothing_ratio", fmt::format("is {}, expected 1 to 3", m.smoothing_ratio));
    }
    m.courant_number = model.number_or("courant_number", m.courant_number);
    if (!(m.courant_number > 0 && m.courant_number <= 2)) {
        model.fail("courant_number", fmt::format("is {}, expected above 0 and at most 2", m.courant_number));
    }
    const double substeps = model.number_or("air_substeps", 0);
    if (substeps != 0 && !(substeps > 0 && substeps < 100 && std::fmod(substeps, 2) == 1))
        model.fail("air_substeps", fmt::format("is {}, expected an odd number up to 99, or 0", substeps));
    m.air_substeps = static_cast<int>(substeps);
    if (substeps > 1 && m.dissipation_switch)
        model.fail("air_substeps", fmt::format("is {}, expected 1 with the dissipation switch", substeps));
    m.skin = model.number_or("skin", scene.air ? m.skin : 2 * m.skin);
    if (!(m.skin >= 0.05 && m.skin <= 1))
        model.fail("skin", fmt::format("is {}, expected 0.05 to 1", m.skin));
    model.finish();
    if (m.pressure_mean == Mean::harmonic && background == 0 && scene.air) {
        model.fail("pressure_mean",
                   "the harmonic mean needs a positive background_pressure: it is singular at p <= 0");
    }
}

}  // namespace wetdeck

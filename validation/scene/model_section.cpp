// SPDX-License-Identifier: BSD-3-Clause
// Materials and model of a scene. The keys of the model are the rows of model_keys.cpp; their defaults are
// those of solver/physics/model.hpp.
#include <fmt/format.h>

#include <cmath>

#include "solver/physics/mixed_precision.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

constexpr double atmospheric_pressure = 101325;  // [Pa]

Material read_material(const TomlTable& table) {
    Material material;
    material.eos.reference_density = table.positive("density");
    material.eos.exponent = table.positive("exponent");
    material.viscosity = table.number_or("viscosity", 0);
    if (material.viscosity < 0) table.fail("viscosity", "expected zero or a positive number");
    return material;
}

/// Defaults that depend on whether there is air.
void set_defaults(Scene& scene) {
    scene.model.negative_pressure = scene.air;
    scene.model.air_substeps = 0;
    scene.model.coarse_substeps = 0;
}

/// Choices that contradict each other.
void check_choices(const TomlTable& model, const Scene& scene) {
    const Model& m = scene.model;
    for (const auto& [key, substeps] :
         {std::pair{"air_substeps", m.air_substeps}, std::pair{"coarse_substeps", m.coarse_substeps}})
        if (substeps > 1 && m.dissipation_switch)
            model.fail(key, fmt::format("is {}, expected 1 with the dissipation switch", substeps));
    if (m.pressure_mean == Mean::harmonic && m.water.eos.background_pressure == 0 && scene.air)
        model.fail("pressure_mean",
                   "the harmonic mean needs a positive background_pressure: it is singular at p <= 0");
}

}  // namespace

void read_air_law(const TomlTable& air, Model& model) {
    TaitEquationOfState& eos = model.air.eos;
    const std::string law = air.choice("law", {"equal-coefficient", "physical", "sound-speed"});
    const std::optional<double> given = air.optional_number("sound_speed");
    if (law == "equal-coefficient") {
        eos.sound_speed = equal_coefficient_sound_speed(model.water.eos, eos.reference_density, eos.exponent);
    } else if (law == "physical") {
        eos.sound_speed = std::sqrt(eos.exponent * atmospheric_pressure / eos.reference_density);
    } else {
        if (!given || *given <= 0)
            air.fail("sound_speed", "the law 'sound-speed' needs a positive number [m/s]");
        eos.sound_speed = *given;
    }
}

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
        read_air_law(*air, m);
        scene.air_law = air->text("law");
    }
    set_defaults(scene);
    read_model_keys(model, "model", scene);
    model.finish();
    scene.execution.precision = default_precision(m);
    if (const std::optional<TomlTable> execution = root.optional_table("execution")) {
        read_model_keys(*execution, "execution", scene);
        if (const std::string choice = without_mixed_pairs(m);
            scene.execution.precision == Precision::mixed && !choice.empty())
            execution->fail("precision", fmt::format("is 'mixed', expected 'double' with {}", choice));
        execution->finish();
    }
    if (const std::optional<TomlTable> contact = root.optional_table("contact")) {
        const TaitEquationOfState& eos = m.water.eos;
        m.contact.stiffness = 10 * eos.reference_density * eos.sound_speed * eos.sound_speed;
        read_model_keys(*contact, "contact", scene);
        contact->finish();
    }
    check_choices(model, scene);
}

}  // namespace wetdeck

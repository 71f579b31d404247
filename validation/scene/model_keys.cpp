// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/model_keys.hpp"

#include <fmt/format.h>

#include "solver/time/time_step.hpp"

namespace wetdeck {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A row whose value is a member of the model.
template <class Value>
ModelKey model_row(const char* key, Value Model::*member, const char* meaning, const char* equation) {
    ModelKey row{"model", key, meaning, "-", equation};
    row.get = [member](const Scene& s) -> KeyValue { return s.model.*member; };
    row.set = [member](Scene& s, const KeyValue& v) { s.model.*member = std::get<Value>(v); };
    return row;
}

ModelKey number(const char* key, double Model::*member, std::pair<double, double> range, const char* meaning,
                const char* equation = "") {
    ModelKey row = model_row(key, member, meaning, equation);
    std::tie(row.low, row.high) = range;
    return row;
}

ModelKey flag(const char* key, bool Model::*member, const char* meaning, const char* equation = "") {
    ModelKey row = model_row(key, member, meaning, equation);
    row.unit.clear();
    return row;
}

/// @param names  of the enumerators, in their order
template <class Enum>
ModelKey choice(const char* key, Enum Model::*member, std::vector<std::string> names, const char* meaning,
                const char* equation = "") {
    ModelKey row{"model", key, meaning, "", equation};
    row.names = names;
    row.get = [member, names](const Scene& s) -> KeyValue {
        return names.at(static_cast<std::size_t>(s.model.*member));
    };
    row.set = [member, names](Scene& s, const KeyValue& v) {
        const auto found = std::find(names.begin(), names.end(), std::get<std::string>(v));
        s.model.*member = static_cast<Enum>(found - names.begin());
    };
    return row;
}

/// A row of a fluid's table.
ModelKey material_row(const char* table, const char* key, double& (*value)(Scene&), const char* meaning,
                      const char* unit) {
    ModelKey row{table, key, meaning, unit, ""};
    row.get = [value](const Scene& s) -> KeyValue { return value(const_cast<Scene&>(s)); };
    row.set = [value](Scene& s, const KeyValue& v) { value(s) = std::get<double>(v); };
    return row;
}

/// The ingredient is present where its key has another value than `off`, and where `also` holds.
ModelKey removable(ModelKey row, const char* ingredient, const KeyValue& off,
                   std::function<bool(const Scene&)> also = {}) {
    const std::string assignment = fmt::format("{}={}", row.dotted(), toml_text(off));
    Removal removal;
    removal.ingredient = ingredient;
    removal.present = [get = row.get, off, also](const Scene& s) {
        return get(s) != off && (!also || also(s));
    };
    removal.overrides = [assignment](const Scene&) { return std::vector{assignment}; };
    row.removal = std::move(removal);
    return row;
}

/// The same, with overrides besides.
ModelKey removable_with(ModelKey row, const char* ingredient, const KeyValue& off, std::string besides) {
    row = removable(std::move(row), ingredient, off);
    row.removal->overrides = [inner = row.removal->overrides, besides](const Scene& s) {
        std::vector<std::string> all = inner(s);
        all.push_back(besides);
        return all;
    };
    return row;
}

bool low_dissipation(const Scene& s) {
    return s.model.dissipation == Dissipation::low_dissipation;
}
bool low_dissipation_with_air(const Scene& s) {
    return low_dissipation(s) && s.air;
}
bool water_alone(const Scene& s) {
    return !s.air;
}
bool linear_pressure_mean(const Scene& s) {  // the harmonic mean of pressures is singular without background
    return s.model.pressure_mean != Mean::harmonic;
}

ModelKey air_row() {
    ModelKey row{"model", "air", "whether the air is computed; false: water alone", "", ""};
    row.get = [](const Scene& s) -> KeyValue { return s.air; };
    row.set = [](Scene& s, const KeyValue& v) { s.air = std::get<bool>(v); };
    row.default_note = "false";
    return removable_with(std::move(row), "air", false, "model.background_pressure=0");
}

ModelKey dissipation_row() {
    return removable(
        choice("dissipation", &Model::dissipation, {"none", "riemann", "low-dissipation"},
               "Riemann dissipation: none, in full, or limited to approaching pairs", "Eq. (10)"),
        "Riemann dissipation", std::string("none"),
        [](const Scene& s) { return s.model.dissipation == Dissipation::riemann; });
}

ModelKey dissipation_slope_row() {
    ModelKey row = removable(number("dissipation_slope", &Model::dissipation_slope, {0, unbounded},
                                    "slope of the limiter min(slope du/c, 1), pairs of water with water"),
                             "water dissipation", 0.0, low_dissipation);
    row.removal->overrides = [](const Scene& s) {  // that of pairs with air must stay
        return std::vector<std::string>{s.air ? "model.dissipation_slope=0" : "model.dissipation=none"};
    };
    return row;
}

ModelKey background_pressure_row() {
    ModelKey row{"model", "background_pressure", "background pressure p0 of both fluids", "Pa", "Eq. (2)"};
    row.get = [](const Scene& s) -> KeyValue { return s.model.water.eos.background_pressure; };
    row.set = [](Scene& s, const KeyValue& v) {
        s.model.water.eos.background_pressure = s.model.air.eos.background_pressure = std::get<double>(v);
    };
    return removable(std::move(row), "background pressure", 0.0, linear_pressure_mean);
}

ModelKey substeps(const char* key, int Model::*member, const char* meaning) {
    ModelKey row{"model", key, meaning, "-", ""};
    row.high = 99;
    row.odd = true;
    row.default_note = std::string("0");
    row.get = [member](const Scene& s) -> KeyValue { return static_cast<double>(s.model.*member); };
    row.set = [member](Scene& s, const KeyValue& v) {
        s.model.*member = static_cast<int>(std::get<double>(v));
    };
    return row;
}

ModelKey skin_row() {
    ModelKey row{"execution", "skin",
                 "skin of the neighbour list over the smoothing length; 0: chosen as the run goes", "-", ""};
    row.high = 1;
    row.default_note = "0";
    row.get = [](const Scene& s) -> KeyValue { return s.execution.skin; };
    row.set = [](Scene& s, const KeyValue& v) { s.execution.skin = std::get<double>(v); };
    return row;
}

ModelKey precision_row() {
    const std::vector<std::string> names = {"double", "mixed"};
    ModelKey row{"execution", "precision",
                 "of the sums over pairs of fluid particles: double, or mixed, with pairs in single "
                 "precision and positions as 32-bit fixed point",
                 "", ""};
    row.names = names;
    row.default_note = "mixed; double with harmonic means or the dissipation switch";
    row.get = [names](const Scene& s) -> KeyValue {
        return names.at(static_cast<std::size_t>(s.execution.precision));
    };
    row.set = [names](Scene& s, const KeyValue& v) {
        s.execution.precision =
            std::get<std::string>(v) == names.front() ? Precision::double_precision : Precision::mixed;
    };
    return row;
}

/// A row of the law of contact.
ModelKey contact_row(const char* key, double ContactLaw::*member, const char* meaning, const char* unit) {
    ModelKey row{"contact", key, meaning, unit, ""};
    row.get = [member](const Scene& s) -> KeyValue { return s.model.contact.*member; };
    row.set = [member](Scene& s, const KeyValue& v) { s.model.contact.*member = std::get<double>(v); };
    return row;
}

ModelKey contact_stiffness_row() {
    ModelKey row = contact_row(
        "stiffness", &ContactLaw::stiffness,
        "stiffness of each corner of a body in contact; 0: a body that touches anything ends the run",
        "N/m^2");
    row.default_note = "0; 10 rho c^2 of the water with a table [contact]";
    return removable(std::move(row), "contact", 0.0);
}

ModelKey contact_restitution_row() {
    ModelKey row = contact_row("restitution", &ContactLaw::restitution,
                               "speed after a contact over the speed before it", "-");
    row.low = lowest_restitution;
    row.high = 1;
    return row;
}

ModelKey with_default(ModelKey row, const char* note) {
    row.default_note = note;
    return row;
}

ModelKey with_unit(ModelKey row, const char* unit) {
    row.unit = unit;
    return row;
}

std::vector<ModelKey> rows() {
    const std::vector<std::string> means = {"arithmetic", "density-weighted", "impedance-weighted",
                                            "harmonic"};
    return {
        air_row(),
        removable(
            choice("viscosity", &Model::viscosity, {"none", "approaching", "symmetric"},
                   "physical viscosity: none, of approaching pairs as printed, or of both signs", "Eq. (13)"),
            "viscosity", std::string("none")),
        removable(flag("hydrostatic_correction", &Model::hydrostatic_correction,
                       "the pressure jump counts only beyond the hydrostatic jump"),
                  "hydrostatic correction", false),
        dissipation_row(),
        dissipation_slope_row(),
        removable(number("air_dissipation", &Model::air_dissipation, {0, unbounded},
                         "share of the full Riemann dissipation in pairs with air"),
                  "air dissipation", 0.0, low_dissipation_with_air),
        removable(number("wall_dissipation", &Model::wall_dissipation, {0, unbounded},
                         "slope of the limiter of the dissipation normal to walls"),
                  "wall dissipation", 0.0),
        removable(choice("wall_velocity", &Model::wall_velocity, {"own", "normal", "mirrored"},
                         "u_R at walls: the wall's own normal velocity as printed, the fluid's reversed "
                         "about it, or that and along the face the velocity of the water",
                         "Eqs. (16)-(18)"),
                  "mirrored wall velocity", std::string("normal")),
        removable(
            choice(
                "wall_pressure", &Model::wall_pressure, {"one-sided", "shepard", "shepard-water"},
                "pressure of walls: pair by pair, Shepard mean, or Shepard mean of the water for the water",
                "Eqs. (17), (19)"),
            "Shepard wall pressure", std::string("one-sided")),
        choice("wall_pair_mean", &Model::wall_pair_mean, {"arithmetic", "harmonic"},
               "mean of the pressures of a fluid and a boundary particle in P*", "Eqs. (10)-(11), (19)"),
        flag("wall_pressure_jump", &Model::wall_pressure_jump,
             "whether the pressure jump at a wall enters u* there", "Eqs. (10), (17)"),
        background_pressure_row(),
        removable(number("pressure_diffusion", &Model::pressure_diffusion, {0, unbounded},
                         "factor on the pressure jump in u*, 1 is the Riemann value", "Eq. (10)"),
                  "pressure diffusion", 0.0),
        removable(number("full_kernel_sum", &Model::full_kernel_sum, {0, 1},
                         "kernel sum from which the density of water may rise; 0: any"),
                  "density bound", 0.0),
        removable(flag("wall_wetting", &Model::wall_wetting,
                       "water without air feels walls that it touches; false: all within the support"),
                  "wetting of walls", false, water_alone),
        // the switch needs the rates of each step of the air
        removable_with(
            flag("dissipation_switch", &Model::dissipation_switch, "switched dissipation", "Eqs. (14)-(15)"),
            "switched dissipation", false, "model.air_substeps=1"),
        choice(
            "switch_velocity", &Model::switch_velocity, {"arithmetic", "harmonic", "modulus"},
            "velocity factor of the switched dissipation: modulus of the arithmetic or harmonic mean of the "
            "projections, or of the mean velocity",
            "Eq. (14)"),
        removable(substeps("air_substeps", &Model::air_substeps,
                           "steps of the air in one of the water; 0: from the sound speeds"),
                  "steps of the air", 1.0, [](const Scene& s) { return s.air && air_substeps(s.model) > 1; }),
        removable(substeps("coarse_substeps", &Model::coarse_substeps,
                           "steps of fine water in one of water that is so many times coarser, where "
                           "[resolution] lets spacings differ; 0: as many as pay"),
                  "longer steps of coarse water", 1.0,
                  [](const Scene& s) { return takes_coarse_substeps(s) && s.model.coarse_substeps != 1; }),
        choice("velocity_mean", &Model::velocity_mean, means, "inter-particle mean of velocities",
               "Eq. (11)"),
        choice("pressure_mean", &Model::pressure_mean, means, "inter-particle mean of pressures", "Eq. (11)"),
        choice("mean_guard", &Model::mean_guard, {"division", "same-sign-arithmetic", "same-sign-zero"},
               "what stands for a harmonic mean where the two signs differ", "Eq. (11)"),
        choice("impedance_mean", &Model::impedance_mean, {"arithmetic", "harmonic"},
               "mean of rho c in u*: of the reference states, or harmonic of the present ones",
               "Eqs. (10)-(11)"),
        choice("wall_slip", &Model::wall_slip, {"free", "no"}, "whether walls drag the fluid along",
               "Eq. (18)"),
        number("sponge_thickness", &Model::sponge_thickness, {0, unbounded},
               "thickness of the sponge layer along the tank's walls [m]; 0: none", "Eqs. (24)-(25)"),
        choice("sponge_ramp", &Model::sponge_ramp, {"exponential", "larsen-dancy"},
               "ramp of the sponge layer: 1 - 0.9^(50 l/s), or 100^(-0.9^(50 l/s))", "Eq. (25)"),
        with_default(
            flag("negative_pressure", &Model::negative_pressure,
                 "whether water may be rarefied; false: its density is kept at or above the reference"),
            "true with air, false without"),
        number("smoothing_ratio", &Model::smoothing_ratio, {1, 3}, "smoothing length over particle spacing",
               "Eq. (7)"),
        number("courant_number", &Model::courant_number, {1e-12, 2}, "of the acoustic time step", "Eq. (26)"),
        with_unit(number("fixed_step", &Model::fixed_step, {0, unbounded},
                         "size of every time step; 0: the stable step of each moment", "Eq. (26)"),
                  "s"),
        skin_row(),
        precision_row(),
        contact_stiffness_row(),
        contact_restitution_row(),
        material_row(
            "water", "density", [](Scene& s) -> double& { return s.model.water.eos.reference_density; },
            "reference density of the water", "kg/m^3"),
        material_row(
            "water", "sound_speed", [](Scene& s) -> double& { return s.model.water.eos.sound_speed; },
            "sound speed of the water", "m/s"),
        material_row(
            "water", "exponent", [](Scene& s) -> double& { return s.model.water.eos.exponent; },
            "exponent gamma of the water's equation of state", "-"),
        material_row(
            "water", "viscosity", [](Scene& s) -> double& { return s.model.water.viscosity; },
            "dynamic viscosity of the water", "Pa s"),
        material_row(
            "air", "density", [](Scene& s) -> double& { return s.model.air.eos.reference_density; },
            "reference density of the air", "kg/m^3"),
        material_row(
            "air", "sound_speed", [](Scene& s) -> double& { return s.model.air.eos.sound_speed; },
            "sound speed of the air, as its law gives it", "m/s"),
        material_row(
            "air", "exponent", [](Scene& s) -> double& { return s.model.air.eos.exponent; },
            "exponent gamma of the air's equation of state", "-"),
        material_row(
            "air", "viscosity", [](Scene& s) -> double& { return s.model.air.viscosity; },
            "dynamic viscosity of the air", "Pa s"),
    };
}

}  // namespace

const std::vector<ModelKey>& model_keys() {
    static const std::vector<ModelKey> all = rows();
    return all;
}

}  // namespace wetdeck

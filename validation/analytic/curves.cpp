// SPDX-License-Identifier: BSD-3-Clause
// Analytic curves by name.
#include "validation/analytic/curves.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <string_view>

#include "solver/core/errors.hpp"
#include "validation/analytic/curve_header.hpp"
#include "validation/analytic/heeled_wedge_curves.hpp"
#include "validation/analytic/wedge_free_fall.hpp"
#include "validation/analytic/wedge_similarity.hpp"

namespace wetdeck {
namespace {

constexpr std::string_view prefix = "analytic:";
constexpr int rows = 400;  // of a curve over time

using Values = CurveValues;

struct Parameter {
    const char* name;
    double low, high;
    std::optional<double> standard;
};

struct Definition {
    AnalyticCurveInfo info;
    std::vector<Parameter> parameters;
    std::string (*text)(const Values&);
    void (*check)(const Values&) = nullptr;  ///< of values that depend on each other; throws InputError
};

constexpr const char* dobrovolskaya =
    "Dobrovolskaya, Z.N. (1969), On some problems of similarity flow of fluid with a free surface, Journal "
    "of Fluid "
    "Mechanics 36, 805-829";
constexpr const char* dobrovolskaya_doi = "10.1017/S0022112069001996";
constexpr const char* numerical_error =
    "numerical error of force and pressure, seen between step widths and against an independent solution "
    "from 10 to 70 "
    "degrees; says nothing of gravity, air or three dimensions";

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

std::string solution_of(const Values& values) {
    return fmt::format(
        "similarity solution of a wedge of {:.6g} degrees: conformal map to a half plane, one nonlinear "
        "integral "
        "equation for the slope of the free surface, 701 nodes in log coordinates",
        values.at("deadrise"));
}

std::string similarity_pressure(const Values& values) {
    const WedgeSimilarity wedge = wedge_similarity(radians(values.at("deadrise")));
    std::string text = curve_header_text(
        {dobrovolskaya, dobrovolskaya_doi, solution_of(values), "0.001", numerical_error,
         "z up from the undisturbed level, apex at -1; Cp = p/(rho V^2/2), gauge", "contact of the apex",
         fmt::format("Constant speed, no gravity, until the spray root (z = {:.4g}) leaves the face",
                     wedge.maximum_pressure_height)},
        "z_over_Vt [-],Cp [-]");
    for (std::size_t i = 0; i < wedge.pressure.x.size(); ++i) {
        text += fmt::format("{:.9g},{:.9g}\n", wedge.pressure.x[i], wedge.pressure.y[i]);
    }
    return text;
}

std::string similarity_surface(const Values& values) {
    const WedgeSimilarity wedge = wedge_similarity(radians(values.at("deadrise")));
    std::string text = curve_header_text(
        {dobrovolskaya, dobrovolskaya_doi, solution_of(values), "0.001", numerical_error,
         "x from the axis, z up from the undisturbed level, apex of the wedge at -1", "contact of the apex",
         "Lengths over V t; s is the arc length from the tip of the jet, the surface overhangs there"},
        "s_over_Vt [-],x_over_Vt [-],z_over_Vt [-]");
    double s = 0;
    for (std::size_t i = 0; i < wedge.surface_x.size(); ++i) {
        if (i > 0) {
            const double ds = std::hypot(wedge.surface_x[i] - wedge.surface_x[i - 1],
                                         wedge.surface_z[i] - wedge.surface_z[i - 1]);
            if (ds < 1e-6) continue;  // the nodes crowd in front of the tip
            s += ds;
        }
        text += fmt::format("{:.12g},{:.9g},{:.9g}\n", s, wedge.surface_x[i], wedge.surface_z[i]);
    }
    return text;
}

std::string constant_speed_force(const Values& values) {
    const WedgeSimilarity wedge = wedge_similarity(radians(values.at("deadrise")));
    const double speed = values.at("speed"), density = values.at("density");
    const double end = chine_wetting_penetration(wedge, values.at("beam") / 2) / speed;
    const double rate = wedge.force_coefficient * density * std::pow(speed, 3);
    const double lift = density * values.at("gravity") * speed * speed / std::tan(wedge.deadrise);
    std::string text = curve_header_text(
        {dobrovolskaya, dobrovolskaya_doi,
         fmt::format("F = {:.6g} rho V^3 t, {}", wedge.force_coefficient, solution_of(values)), "0.001",
         numerical_error, "upward positive, both faces, per metre", "contact of the apex",
         "Ends when the spray root reaches the chine. F_with_buoyancy adds rho g (V t)^2 cot(deadrise), the "
         "body "
         "below the undisturbed level"},
        "t [s],F [N/m],F_with_buoyancy [N/m]");
    for (int i = 0; i <= rows; ++i) {
        const double t = end * i / rows;
        text += fmt::format("{:.9g},{:.9g},{:.9g}\n", t, rate * t, rate * t + lift * t * t);
    }
    return text;
}

std::string free_fall(const Values& values) {
    const WedgeSimilarity wedge = wedge_similarity(radians(values.at("deadrise")));
    const FallingWedge fall{values.at("mass"), values.at("speed"), values.at("gravity"),
                            values.at("density")};
    const double depth = chine_wetting_penetration(wedge, values.at("beam") / 2);
    const WedgeFall history = wedge_free_fall(wedge, fall, depth, depth / fall.speed / rows);
    std::string text = curve_header_text(
        {"Momentum balance of a falling wedge with the coefficients of Dobrovolskaya, Z.N. (1969), Journal "
         "of Fluid "
         "Mechanics 36, 805-829",
         "none",
         fmt::format(
             "(M + alpha rho z^2) dV/dt = M g - C_F rho z V^2 - rho g z^2 cot(deadrise), C_F = {:.6g}, "
             "alpha = {:.6g}; {}",
             wedge.force_coefficient, wedge.added_mass_coefficient, solution_of(values)),
         "0.03",
         "judgement for the first half: the flow is taken as similar while the speed falls; with alpha = 0 "
         "the force "
         "near the end is a fifth higher",
         "V downward positive; vy = -V and F (of the water, without weight) upward positive",
         "contact of the apex", "Two-dimensional, no air. Ends when the spray root reaches the chine"},
        "t [s],V [m/s],vy [m/s],penetration [m],F [N/m],F_over_M [m/s^2]");
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", history.time[i],
                            history.velocity[i], -history.velocity[i], history.penetration[i],
                            history.force[i], history.force[i] / fall.mass);
    }
    return text;
}

const std::vector<Definition>& definitions() {
    constexpr double any = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::min();
    static const Parameter deadrise{"deadrise", 2, 70, {}};
    static const Parameter beam{"beam", tiny, any, {}}, speed{"speed", tiny, any, {}},
        mass{"mass", tiny, any, {}};
    static const Parameter heel{"heel", -62, 62, {}}, horizontal{"horizontal", -10, 10, 0};
    static const Parameter gravity{"gravity", 0, any, 9.81}, density{"density", tiny, any, 1000};
    static const std::vector<Definition> all{
        {{"wedge_pressure", "deadrise", "pressure coefficient along the face of a wedge at constant speed"},
         {deadrise},
         similarity_pressure},
        {{"wedge_surface", "deadrise", "free surface of a wedge at constant speed"},
         {deadrise},
         similarity_surface},
        {{"wedge_force", "deadrise speed beam [gravity=9.81] [density=1000]",
          "force on a wedge at constant speed until its chines are wet"},
         {deadrise, speed, beam, gravity, density},
         constant_speed_force},
        {{"wedge_free_fall", "deadrise speed beam mass [gravity=9.81] [density=1000]",
          "velocity and force of a wedge in free fall until its chines are wet"},
         {deadrise, speed, beam, mass, gravity, density},
         free_fall},
        {{"heeled_wedge_pressure", "deadrise heel [horizontal=0]",
          "pressure coefficient along both faces of a heeled wedge at constant velocity"},
         {deadrise, heel, horizontal},
         heeled_wedge_pressure_text,
         check_heeled_wedge},
        {{"heeled_wedge_force", "deadrise heel speed beam [horizontal=0] [gravity=9.81] [density=1000]",
          "force and moment on a heeled wedge at constant velocity until a chine is wet"},
         {deadrise, heel, speed, beam, horizontal, gravity, density},
         heeled_wedge_force_text,
         check_heeled_wedge}};
    return all;
}

struct Request {
    const Definition* definition = nullptr;
    Values values;
};

[[noreturn]] void refuse(const std::string& reference, const std::string& why) {
    throw InputError(fmt::format("'{}': {}", reference, why));
}

const Parameter& parameter_of(const Definition& definition, const std::string& key,
                              const std::string& reference) {
    const auto found = std::find_if(definition.parameters.begin(), definition.parameters.end(),
                                    [&](const Parameter& parameter) { return parameter.name == key; });
    if (found == definition.parameters.end()) {
        refuse(reference,
               fmt::format("unknown parameter '{}', expected {}", key, definition.info.parameters));
    }
    return *found;
}

void read_parameter(Request& request, const std::string& word, const std::string& reference) {
    const auto equals = word.find('=');
    if (equals == std::string::npos) refuse(reference, fmt::format("'{}', expected name=value", word));
    const Parameter& parameter = parameter_of(*request.definition, word.substr(0, equals), reference);
    const char* const end = word.data() + word.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data() + equals + 1, end, value);
    if (error != std::errc{} || stop != end || !(value >= parameter.low && value <= parameter.high)) {
        refuse(reference, fmt::format("{} is '{}', expected a number of {:.3g} to {:.3g}", parameter.name,
                                      word.substr(equals + 1), parameter.low, parameter.high));
    }
    if (!request.values.emplace(parameter.name, value).second) {
        refuse(reference, fmt::format("{} is given twice", parameter.name));
    }
}

Request read_request(const std::string& reference) {
    std::istringstream words(reference.substr(prefix.size()));
    std::string word;
    words >> word;
    Request request;
    std::vector<std::string> names;
    for (const Definition& definition : definitions()) {
        if (definition.info.name == word) request.definition = &definition;
        names.push_back(definition.info.name);
    }
    if (request.definition == nullptr) {
        refuse(reference, fmt::format("no analytic curve '{}', there are {}", word, fmt::join(names, ", ")));
    }
    while (words >> word) read_parameter(request, word, reference);
    for (const Parameter& parameter : request.definition->parameters) {
        if (parameter.standard) request.values.emplace(parameter.name, *parameter.standard);
        if (!request.values.contains(parameter.name)) {
            refuse(reference, fmt::format("missing parameter '{}', expected {}", parameter.name,
                                          request.definition->info.parameters));
        }
    }
    if (request.definition->check != nullptr) {
        try {
            request.definition->check(request.values);
        } catch (const InputError& error) {
            refuse(reference, error.what());
        }
    }
    return request;
}

}  // namespace

const std::vector<AnalyticCurveInfo>& analytic_curves() {
    static const std::vector<AnalyticCurveInfo> infos = [] {
        std::vector<AnalyticCurveInfo> list;
        for (const Definition& definition : definitions()) list.push_back(definition.info);
        return list;
    }();
    return infos;
}

bool is_analytic(const std::string& reference) {
    return reference.starts_with(prefix);
}

void check_analytic(const std::string& reference) {
    static_cast<void>(read_request(reference));
}

std::string analytic_reference(const std::string& reference) {
    const Request request = read_request(reference);
    return request.definition->text(request.values);
}

}  // namespace wetdeck

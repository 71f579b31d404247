// SPDX-License-Identifier: BSD-3-Clause
// Rows of results in JSON: one key for each member, of its name. JSON has no NaN: what is unknown or not
// finite is written as null.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "validation/metrics/summary.hpp"

NLOHMANN_JSON_NAMESPACE_BEGIN
template <class Value>
struct adl_serializer<std::optional<Value>> {
    static void to_json(json& j, const std::optional<Value>& value) {
        j = value ? json(*value) : json(nullptr);
    }
    static void from_json(const json& j, std::optional<Value>& value) {
        value = j.is_null() ? std::nullopt : std::optional(j.get<Value>());
    }
};
/// By its name; an empty text where nobody has said what kind a reference is.
template <>
struct adl_serializer<std::optional<wetdeck::ReferenceKind>> {
    static void to_json(json& j, std::optional<wetdeck::ReferenceKind> kind) { j = wetdeck::name_of(kind); }
    static void from_json(const json& j, std::optional<wetdeck::ReferenceKind>& kind) {
        kind = wetdeck::reference_kind_named(j.get<std::string>());
    }
};
NLOHMANN_JSON_NAMESPACE_END

namespace wetdeck {

inline nlohmann::json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

inline nlohmann::json numbers(const std::vector<double>& values) {
    nlohmann::json list = nlohmann::json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}

inline void to_json(nlohmann::json& j, const Window& window) {
    j = {window.begin, window.end};
}
inline void from_json(const nlohmann::json& j, Window& window) {
    window = {j.at(0), j.at(1)};
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(QuantityResult, value, unit, note, expected, tolerance, expected_source,
                                   within)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurveFeature, simulated, reference)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ConvergenceRow, scene, variant, qoi, dx, value, order, extrapolated,
                                   gci_fine, least_squares, asymptotic_ratio, monotone, verdict)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurveConvergenceRow, scene, variant, series, window, dx, difference, range,
                                   order, gci_fine, monotone_share, verdict)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ValidationRow, scene, variant, quantity, unit, against, kind, dx,
                                   simulated, reference, error, u_num, u_grid, u_scatter, u_num_source,
                                   u_input, u_input_variant, largest_input, u_data, u_val, assumed,
                                   assumed_reason, interval, required, verdict, largest_part, sentence)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SensitivityRow, scene, variant, dx, quantity, key, low, high, uncertainty,
                                   value_low, value_high, u_input)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SoundSpeedRow, scene, variant, quantity, unit, dx, sound_speed, value,
                                   sound_part, u_sound, finest_dx, finest_value, spacing_part, u_num, limit,
                                   u_limit, expected)
NLOHMANN_JSON_SERIALIZE_ENUM(RunDoubt::About,
                             {{RunDoubt::About::time_origin, "time origin"}, {RunDoubt::About::flow, "flow"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LeftOutRun, directory, scene, variant, dx, differences)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunDoubt, about, scene, variant, dx, overrides, sentence)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PeerPoint, scene, name, reference, error, core_s, conditions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SpeedErrorPoint, scene, variant, dx, core_s, error, against, pareto)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AblationRow, scene, dx, ingredient, core_s_ratio, error_change, needed)

/// `class` and `case`, which no member can be called.
inline void to_json(nlohmann::json& j, const ScatterPoint& p) {
    j = {{"scene", p.scene},       {"variant", p.variant},     {"dx", p.dx},
         {"quantity", p.quantity}, {"unit", p.unit},           {"class", p.quantity_class},
         {"expected", p.expected}, {"predicted", p.predicted}, {"against", p.against},
         {"kind", p.kind},         {"u_data", p.u_data},       {"counted", p.counted},
         {"dropped", p.dropped}};
}
inline void to_json(nlohmann::json& j, const ClassStatistics& row) {
    j = {{"class", row.quantity_class},   {"against", name_of(row.against)},
         {"points", row.count},           {"bias", row.bias},
         {"bias_low", row.bias_low},      {"bias_high", row.bias_high},
         {"scatter", row.scatter},        {"sigma_data", row.sigma_data},
         {"sigma_model", row.sigma_model}};
}
/// `value` holds each run's; the interval is that of the mean.
inline void to_json(nlohmann::json& j, const ReplicateRow& row) {
    j = {{"scene", row.scene},
         {"variant", row.variant},
         {"dx", row.dx},
         {"quantity", row.quantity},
         {"unit", row.unit},
         {"n", row.value.size()},
         {"value", row.value},
         {"mean", row.mean},
         {"sd", row.deviation},
         {"low95", row.low},
         {"high95", row.high},
         {"reference", row.reference},
         {"u_reference", row.u_reference},
         {"area", row.area}};
}
/// An end that is infinite is null.
inline void to_json(nlohmann::json& j, const StatementResult& row) {
    j = {
        {"scene", row.scene},     {"statement", row.says},  {"variant", row.variant},
        {"against", row.against}, {"measure", row.measure}, {"dx", number(row.dx)},
        {"value", row.value},     {"unit", row.unit},       {"interval", {number(row.low), number(row.high)}},
        {"holds", row.holds()},   {"note", row.note}};
}

inline void to_json(nlohmann::json& j, const StressRow& row) {
    j = {{"case", row.stress_case}, {"setting", row.setting}, {"survived", row.survived}, {"note", row.note}};
    if (!row.picture.empty()) j["picture"] = row.picture;
}
inline void from_json(const nlohmann::json& j, StressRow& row) {
    row = {j.at("case"), j.at("setting"), j.at("survived"), j.at("note"), j.value("picture", std::string())};
}

}  // namespace wetdeck

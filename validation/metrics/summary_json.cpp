// SPDX-License-Identifier: BSD-3-Clause
// summary.json: every figure of the report, for programs.
#include "validation/metrics/summary_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "validation/metrics/json_numbers.hpp"
#include "validation/metrics/stored_tables.hpp"
#include "validation/metrics/verification_json.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

json flag(std::optional<bool> value) {
    return value ? json(*value) : json(nullptr);
}

json quantity_json(const QuantityResult& result) {
    return {{"value", number(result.value)},
            {"unit", result.unit},
            {"note", result.note},
            {"expected", number(result.expected)},
            {"tolerance", number(result.tolerance)},
            {"expected_source", result.expected_source},
            {"within", flag(result.within)}};
}

json features_json(const std::vector<CurveFeature>& features) {
    json all = json::object();
    for (const CurveFeature& feature : features) {
        all[feature.name] = {{"simulated", number(feature.simulated)},
                             {"reference", number(feature.reference)}};
    }
    return all;
}

json comparison_json(const ComparisonResult& result) {
    return {{"title", result.title},
            {"quantity", result.quantity},
            {"reference", result.reference},
            {"kind", result.available ? json(name_of(result.kind)) : json(nullptr)},
            {"citation", result.citation},
            {"metric",
             {{"nrmse", number(result.nrmse)},
              {"peak_error", number(result.peak_error)},
              {"time_error", number(result.time_error)},
              {"sprague_geers_magnitude", number(result.agreement.magnitude)},
              {"sprague_geers_phase", number(result.agreement.phase)},
              {"sprague_geers_combined", number(result.agreement.combined)},
              {"amplitude_factor", number(result.agreement.amplitude_factor)},
              {"time_shift", number(result.agreement.time_shift)},
              {"shape_error", number(result.agreement.shape_error)}}},
            {"features", features_json(result.features)},
            {"reference_hash", result.reference_hash},
            {"reference_uncertainty", number(result.reference_uncertainty)},
            {"tolerance", number(result.tolerance)},
            {"within", result.available ? json(result.within) : json(nullptr)},
            {"note", result.note}};
}

json run_json(const RunSummary& run) {
    const RunRecord& record = run.record;
    const RunCost& cost = record.cost;
    const auto entry = [&](const char* key) -> json {
        const auto found = record.choices.find(key);
        return found == record.choices.end() ? json(nullptr) : json(found->second);
    };
    json provenance = json::object();
    for (const char* key : {"commit", "compiler", "compiler_flags", "build_type", "libraries", "simd", "cpu",
                            "threads", "start_time", "overrides", "reference_hashes"})
        provenance[key] = entry(key);
    json quantities = json::object();
    for (const QuantityResult& result : run.quantities) quantities[result.name] = quantity_json(result);
    json comparisons = json::array();
    for (const ComparisonResult& result : run.comparisons) comparisons.push_back(comparison_json(result));
    return {{"scene", record.scene},
            {"variant", record.variant},
            {"dx", number(record.particle_spacing)},
            {"particles", record.particles},
            {"fluid_particles", record.fluid_particles},
            {"steps", cost.steps},
            {"wall_s", number(cost.wall_s)},
            {"core_s", number(cost.core_s)},
            {"particle_steps_per_s", number(cost.particle_steps / cost.wall_s)},
            {"peak_rss_mb", number(cost.peak_rss_mb)},
            {"status", to_string(record.status)},
            {"stop_reason", record.stop_reason},
            {"directory", run.directory},
            {"provenance", std::move(provenance)},
            {"energy_error", number(run.energy_error)},
            {"momentum_error", number(run.momentum_error)},
            {"qoi", std::move(quantities)},
            {"comparisons", std::move(comparisons)}};
}

json convergence_json(const ConvergenceRow& row) {
    return {{"scene", row.scene},
            {"variant", row.variant},
            {"qoi", row.qoi},
            {"dx", numbers(row.dx)},
            {"value", numbers(row.value)},
            {"order", number(row.order)},
            {"extrapolated", number(row.extrapolated)},
            {"gci_fine", number(row.gci_fine)},
            {"asymptotic_ratio", number(row.asymptotic_ratio)},
            {"monotone", row.monotone},
            {"verdict", row.verdict}};
}

json curve_convergence_json(const CurveConvergenceRow& row) {
    return {{"scene", row.scene},
            {"variant", row.variant},
            {"series", row.series},
            {"window", {row.window.begin, row.window.end}},
            {"dx", numbers(row.dx)},
            {"difference", numbers(row.difference)},
            {"range", number(row.range)},
            {"order", number(row.order)},
            {"gci_fine", number(row.gci_fine)},
            {"monotone_share", number(row.monotone_share)},
            {"verdict", row.verdict}};
}

json validation_json(const ValidationRow& row) {
    return {{"scene", row.scene},
            {"variant", row.variant},
            {"quantity", row.quantity},
            {"unit", row.unit},
            {"against", row.against},
            {"kind", name_of(row.kind)},
            {"dx", number(row.dx)},
            {"simulated", number(row.simulated)},
            {"reference", number(row.reference)},
            {"error", number(row.error)},
            {"u_num", number(row.u_num)},
            {"u_num_source", row.u_num_source},
            {"u_input", number(row.u_input)},
            {"u_data", number(row.u_data)},
            {"u_val", number(row.u_val)},
            {"verdict", row.verdict}};
}

json scatter_json(const ScatterPoint& point) {
    return {{"scene", point.scene},
            {"variant", point.variant},
            {"dx", number(point.dx)},
            {"class", point.quantity_class},
            {"quantity", point.quantity},
            {"unit", point.unit},
            {"expected", number(point.expected)},
            {"predicted", number(point.predicted)},
            {"against", point.against},
            {"kind", name_of(point.kind)},
            {"u_data", number(point.u_data)},
            {"counted", point.counted},
            {"dropped", point.dropped}};
}

json statistics_json(const ClassStatistics& row) {
    return {{"class", row.quantity_class},
            {"count", row.count},
            {"bias", number(row.bias)},
            {"bias_low", number(row.bias_low)},
            {"bias_high", number(row.bias_high)},
            {"scatter", number(row.scatter)},
            {"sigma_data", number(row.sigma_data)},
            {"sigma_model", number(row.sigma_model)}};
}

json sensitivity_json(const SensitivityRow& row) {
    return {{"scene", row.scene},
            {"variant", row.variant},
            {"dx", number(row.dx)},
            {"quantity", row.quantity},
            {"key", row.key},
            {"low", number(row.low)},
            {"high", number(row.high)},
            {"uncertainty", number(row.uncertainty)},
            {"value_low", number(row.value_low)},
            {"value_high", number(row.value_high)},
            {"u_input", number(row.u_input)}};
}

json peer_json(const PeerPoint& point) {
    return {{"scene", point.scene},           {"name", point.name},
            {"reference", point.reference},   {"error", number(point.error)},
            {"core_s", number(point.core_s)}, {"conditions", point.conditions}};
}

json cheapest_run_json(const std::optional<SpeedErrorPoint>& point) {
    if (!point) return nullptr;
    return {{"variant", point->variant},
            {"dx", number(point->dx)},
            {"core_s", number(point->core_s)},
            {"error", number(point->error)}};
}

json cheapest_json(const CheapestRow& row) {
    return {{"scene", row.scene},
            {"quantity", row.quantity},
            {"against", row.against},
            {"within_5_percent", cheapest_run_json(row.within_5)},
            {"within_10_percent", cheapest_run_json(row.within_10)},
            {"best", cheapest_run_json(row.best)}};
}

json speed_error_json(const SpeedErrorPoint& point) {
    return {{"scene", point.scene},           {"variant", point.variant},     {"dx", number(point.dx)},
            {"core_s", number(point.core_s)}, {"error", number(point.error)}, {"against", point.against},
            {"pareto", point.pareto}};
}

template <typename Item>
json list_json(const std::vector<Item>& items, json (*convert)(const Item&)) {
    json list = json::array();
    for (const Item& item : items) list.push_back(convert(item));
    return list;
}

}  // namespace

json summary_json(const Summary& summary, const ProgramInfo& program) {
    return {{"schema", 1},
            {"tier", summary.tier},
            {"program",
             {{"version", program.version},
              {"commit", program.commit},
              {"compiler", program.compiler},
              {"simd", program.simd},
              {"threads", program.threads}}},
            {"machine", {{"cpu", program.cpu}, {"cores", program.cores}}},
            {"runs", list_json(summary.runs, run_json)},
            {"convergence", list_json(summary.convergence, convergence_json)},
            {"curve_convergence", list_json(summary.curve_convergence, curve_convergence_json)},
            {"validation", list_json(summary.validation, validation_json)},
            {"scatter", list_json(summary.scatter, scatter_json)},
            {"statistics", list_json(summary.statistics, statistics_json)},
            {"speed_error", list_json(summary.speed_error, speed_error_json)},
            {"peers", list_json(summary.peers, peer_json)},
            {"cheapest", list_json(summary.cheapest, cheapest_json)},
            {"sensitivity", list_json(summary.sensitivity, sensitivity_json)},
            {"verification", verification_list(summary.verification)},
            {"ablation", list_json(summary.ablation, ablation_json)},
            {"stress", list_json(summary.stress, stress_json)},
            {"missing", summary.missing}};
}

}  // namespace wetdeck

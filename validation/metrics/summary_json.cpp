// SPDX-License-Identifier: BSD-3-Clause
// summary.json: every figure of the report, for programs.
#include "validation/metrics/summary_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "validation/metrics/verification_json.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

json number(std::optional<double> value) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return *value;
}

json numbers(const std::vector<double>& values) {
    json list = json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}

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

json comparison_json(const ComparisonResult& result) {
    return {{"title", result.title},
            {"quantity", result.quantity},
            {"reference", result.reference},
            {"kind", result.available ? json(result.kind) : json(nullptr)},
            {"citation", result.citation},
            {"metric",
             {{"nrmse", number(result.nrmse)},
              {"peak_error", number(result.peak_error)},
              {"time_error", number(result.time_error)}}},
            {"reference_uncertainty", number(result.reference_uncertainty)},
            {"tolerance", number(result.tolerance)},
            {"within", result.available ? json(result.within) : json(nullptr)},
            {"note", result.note}};
}

json run_json(const RunSummary& run) {
    const RunRecord& record = run.record;
    const RunCost& cost = record.cost;
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

json speed_error_json(const SpeedErrorPoint& point) {
    return {{"scene", point.scene},           {"variant", point.variant},     {"dx", number(point.dx)},
            {"core_s", number(point.core_s)}, {"error", number(point.error)}, {"pareto", point.pareto}};
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
            {"speed_error", list_json(summary.speed_error, speed_error_json)},
            {"verification", verification_list(summary.verification)},
            {"ablation", json::array()},
            {"stress", json::array()},
            {"missing", summary.missing}};
}

}  // namespace wetdeck

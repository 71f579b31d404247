// SPDX-License-Identifier: BSD-3-Clause
// summary.json: every figure of the report, for programs.
#include "validation/metrics/summary_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "validation/metrics/json_fields.hpp"
#include "validation/metrics/verification_json.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

/// The value of a relative uncertainty, or of one that is not.
std::optional<double> part_of(const std::optional<StandardUncertainty>& uncertainty, bool relative) {
    if (!uncertainty || uncertainty->relative() != relative) return std::nullopt;
    return uncertainty->value;
}

json comparison_json(const ComparisonResult& result) {
    json features = json::object();
    for (const CurveFeature& feature : result.features) features[feature.name] = feature;
    const CurveAgreement& agreement = result.agreement;
    json all = {{"title", result.title},
                {"quantity", result.quantity},
                {"reference", result.reference},
                {"kind", result.kind},
                {"citation", result.citation},
                {"metric",
                 {{"nrmse", result.nrmse},
                  {"peak_error", result.peak_error},
                  {"time_error", result.time_error},
                  {"sprague_geers_magnitude", agreement.magnitude},
                  {"sprague_geers_phase", agreement.phase},
                  {"sprague_geers_combined", agreement.combined},
                  {"amplitude_factor", agreement.amplitude_factor},
                  {"time_shift", agreement.time_shift},
                  {"shape_error", agreement.shape_error}}},
                {"features", std::move(features)},
                {"reference_hash", result.reference_hash},
                {"reference_uncertainty", part_of(result.reference_uncertainty, true)},
                {"reference_uncertainty_absolute", part_of(result.reference_uncertainty, false)},
                {"tolerance", result.tolerance},
                {"within", result.within},
                {"note", result.note}};
    if (!result.available) all["kind"] = nullptr;
    if (!result.available || !result.judged) all["within"] = nullptr;
    return all;
}

json run_json(const RunSummary& run) {
    const RunRecord& record = run.record;
    const RunCost& cost = record.cost;
    const auto entry = [&](const char* key) -> json {
        const auto found = record.provenance.find(key);
        return found == record.provenance.end() ? json(nullptr) : json(found->second);
    };
    json provenance = json::object();
    for (const char* key : {"commit", "compiler", "compiler_flags", "build_type", "libraries", "simd", "cpu",
                            "threads", "start_time", "overrides", "reference_hashes"})
        provenance[key] = entry(key);
    provenance["precision"] = entry("execution.precision");
    json quantities = json::object();
    for (const QuantityResult& result : run.quantities) quantities[result.name] = result;
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

/// A row beside an exact solution, another code or a stated value: ours and theirs.
json agreement_json(const ValidationRow& row) {
    json all = row;
    all["ours"] = row.simulated;
    all["theirs"] = row.reference;
    all["code"] = row.against;
    all["u_ours"] = row.u_num;
    all["u_theirs"] = row.u_data;
    return all;
}

}  // namespace

json summary_json(const Summary& summary, const ProgramInfo& program) {
    json runs = json::array(), cheapest = json::array(), agreement = json::array();
    for (const RunSummary& run : summary.runs) runs.push_back(run_json(run));
    for (const CheapestRow& row : summary.cheapest) cheapest.push_back(cheapest_json(row));
    for (const ValidationRow& row : summary.agreement) agreement.push_back(agreement_json(row));
    return {{"schema", 2},
            {"tier", summary.tier},
            {"program",
             {{"version", program.version},
              {"commit", program.commit},
              {"compiler", program.compiler},
              {"simd", program.simd},
              {"threads", program.threads}}},
            {"machine", {{"cpu", program.cpu}, {"cores", program.cores}}},
            {"runs", std::move(runs)},
            {"convergence", summary.convergence},
            {"curve_convergence", summary.curve_convergence},
            {"validation", summary.validation},
            {"agreement", std::move(agreement)},
            {"replicates", summary.replicates},
            {"statements", summary.statements},
            {"scatter", summary.scatter},
            {"statistics", summary.statistics},
            {"speed_error", summary.speed_error},
            {"peers", summary.peers},
            {"cheapest", std::move(cheapest)},
            {"sensitivity", summary.sensitivity},
            {"sound_speed", summary.sound_speed},
            {"verification", verification_list(summary.verification)},
            {"ablation", summary.ablation},
            {"stress", summary.stress},
            {"doubts", summary.doubts},
            {"left_out", summary.left_out},
            {"missing", summary.missing}};
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Quantities of interest: one number from one series of a run.
#include "validation/metrics/quantities.hpp"

#include <fmt/core.h>

#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/analytic/curves.hpp"
#include "validation/metrics/reference_curve.hpp"
#include "validation/metrics/reference_use.hpp"
#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

MetricResult evaluate(const QuantitySpec& spec, const RunRecord& record, ReferenceShelf& references) {
    const SeriesCurve series = series_curve(record, spec.series, spec);
    if (!series.problem.empty()) return {{}, series.problem};
    const Curve& curve = series.curve;
    const Window window = spec.window.value_or(extent(curve));
    const MetricNeeds& needs = spec.metric->needs;
    if (needs.whole_window && !covers(curve, window))
        return {{},
                fmt::format("the series spans {:.6g} to {:.6g}, the window {:.6g} to {:.6g}", curve.x.front(),
                            curve.x.back(), window.begin, window.end)};
    Curve measured;
    if (needs.reference) {
        ReferenceCurve found = reference_curve(request_of(spec), references);
        if (!found.problem.empty()) return {{}, found.problem};
        measured = std::move(found.curve);
        if (!covers(measured, window))
            return {{}, fmt::format("reference '{}' does not cover the window", spec.reference)};
    }
    return spec.metric->evaluate({curve, clip(curve, window), window, spec.threshold.value_or(0), measured});
}

}  // namespace

std::filesystem::path reference_file(const std::string& stem, const std::filesystem::path& own,
                                     const std::filesystem::path& directory) {
    const std::filesystem::path name = stem + ".csv";
    return !own.empty() && std::filesystem::exists(own / name) ? own / name : directory / name;
}

std::optional<Reference> ReferenceShelf::read(const std::string& stem) const {
    if (is_analytic(stem)) return parse_reference(stem, analytic_reference(stem));
    const std::filesystem::path path = reference_file(stem, own_, directory_);
    if (!std::filesystem::exists(path)) return std::nullopt;
    return load_reference(path);
}

const Reference* ReferenceShelf::find(const std::string& stem) {
    auto found = files_.find(stem);
    if (found == files_.end()) {
        Entry entry;
        try {
            entry.reference = read(stem);
        } catch (const DataError& error) {
            entry.problem = error.what();
        }
        found = files_.emplace(stem, std::move(entry)).first;
    }
    const Entry& entry = found->second;
    if (!entry.problem.empty()) throw DataError(entry.problem);
    return entry.reference ? &*entry.reference : nullptr;
}

std::string reference_hashes(const AnalysisSpec& scene, const std::filesystem::path& directory) {
    std::string out;
    for (const std::string& stem : references_in_use(scene)) {
        const std::string hash = file_hash(reference_file(stem, scene.folder, directory));
        if (!hash.empty()) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", stem, hash);
    }
    return out;
}

std::string curve_not_available(const std::string& stem) {
    return fmt::format("curve not available: no file {}.csv", stem);
}

Curve scaled_reference(const Reference& reference, const std::string& x_column, const std::string& y_column,
                       double x_scale, double y_scale) {
    Curve curve = column_curve(reference, x_column, y_column);
    const double x_unit = find_column(reference, x_column).unit == "-" ? 1 : x_scale;
    const double y_unit = find_column(reference, y_column).unit == "-" ? 1 : y_scale;
    for (double& x : curve.x) x /= x_unit;
    for (double& y : curve.y) y /= y_unit;
    return curve;
}

const char* missing_key(const QuantitySpec& spec) {
    const MetricNeeds& needs = spec.metric->needs;
    if (needs.threshold && !spec.threshold) return "threshold";
    if (needs.reference && spec.reference.empty()) return "reference";
    if (needs.reference && spec.y_column.empty()) return "y_column";
    if (needs.reference && !spec.window) return "window";
    return nullptr;
}

QuantityResult evaluate_quantity(const QuantitySpec& spec, const RunRecord& record,
                                 ReferenceShelf& references) {
    if (spec.metric == nullptr) throw InputError(fmt::format("quantity '{}' has no metric", spec.name));
    if (const char* key = missing_key(spec); key != nullptr)
        throw InputError(
            fmt::format("quantity '{}': metric {} needs '{}'", spec.name, spec.metric->name, key));
    MetricResult outcome = evaluate(spec, record, references);
    QuantityResult result;
    result.name = spec.name;
    result.unit = spec.unit;
    result.value = outcome.value;
    result.note = std::move(outcome.note);
    result.expected = spec.expected;
    result.tolerance = spec.tolerance;
    result.expected_source = spec.expected_source;
    if (result.value && result.expected && result.tolerance) {
        result.within = std::abs(*result.value - *result.expected) <= *result.tolerance;
    }
    return result;
}

}  // namespace wetdeck

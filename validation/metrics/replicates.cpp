// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/replicates.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "validation/metrics/judged_values.hpp"

namespace wetdeck {
namespace {

constexpr double two_sided_tail = 0.025;

/// A normal distribution.
struct Normal {
    double mean, deviation;

    double function(double x) const { return gsl_cdf_gaussian_P(x - mean, deviation); }
    double place(double level) const { return mean + gsl_cdf_gaussian_Pinv(level, deviation); }
    /// Antiderivative of the distribution function.
    double integral(double x) const {
        return (x - mean) * function(x) + deviation * deviation * gsl_ran_gaussian_pdf(x - mean, deviation);
    }
};

/// Integral of |distribution function - level| between two places, in parts on which one is the larger.
double area_between(double from, double to, double level, const Normal& normal) {
    std::vector<double> ends = {from, to};
    const double crossing = level > 0 && level < 1 ? normal.place(level) : from;
    if (crossing > from && crossing < to) ends.insert(ends.begin() + 1, crossing);
    double area = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        area += std::abs(normal.integral(ends[k + 1]) - normal.integral(ends[k]) -
                         level * (ends[k + 1] - ends[k]));
    return area;
}

struct Draws {
    std::string unit;
    std::vector<double> values;
    std::optional<double> reference, u_reference;
};

}  // namespace

ReplicateRow spread_of(std::vector<double> values) {
    if (values.size() < 2) throw std::invalid_argument("the spread of fewer than two values");
    std::sort(values.begin(), values.end());
    ReplicateRow row;
    row.mean = gsl_stats_mean(values.data(), 1, values.size());
    row.deviation = gsl_stats_sd(values.data(), 1, values.size());
    const double n = static_cast<double>(values.size());
    const double half = gsl_cdf_tdist_Qinv(two_sided_tail, n - 1) * row.deviation / std::sqrt(n);
    row.low = row.mean - half;
    row.high = row.mean + half;
    row.value = std::move(values);
    return row;
}

std::vector<ReplicateRow> replicate_rows(const AnalysisSpec& scene, const std::vector<SensitivityRun>& runs) {
    std::map<std::pair<std::string, double>, std::map<std::string, Draws>> groups;  // by variant and spacing
    for (const SensitivityRun& each : runs) {
        const RunRecord& record = each.run.record;
        if (each.key != arrangement_key || !applies(scene, record) || record.status != RunStatus::ok)
            continue;
        for (const JudgedValue& value : judged_values(scene, each.run)) {
            if (!value.simulated) continue;
            Draws& draws = groups[{record.variant, record.particle_spacing}][value.name];
            draws.unit = value.unit;
            draws.values.push_back(*value.simulated);
            draws.reference = value.reference;
            draws.u_reference = value.u_data;
        }
    }
    std::vector<ReplicateRow> rows;
    for (auto& [group, quantities] : groups) {
        for (auto& [name, draws] : quantities) {
            if (draws.values.size() < 2) continue;
            ReplicateRow row = spread_of(std::move(draws.values));
            row.scene = scene.scene;
            row.variant = group.first;
            row.quantity = name;
            row.unit = draws.unit;
            row.dx = group.second;
            row.reference = draws.reference;
            row.u_reference = draws.u_reference;
            if (row.reference && row.u_reference)
                row.area = area_metric(row.value, *row.reference, *row.u_reference);
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

bool differ_as_replicates(const std::vector<double>& values, const ReplicateRow& replicates) {
    if (values.size() < 2) return true;
    const double variance = gsl_stats_variance(values.data(), 1, values.size());
    const double within = replicates.deviation * replicates.deviation;
    if (within == 0) return variance == 0;
    return gsl_cdf_fdist_Q(variance / within, static_cast<double>(values.size() - 1),
                           static_cast<double>(replicates.value.size() - 1)) > 0.05;
}

double area_metric(const std::vector<double>& values, double reference, double u_reference) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double n = static_cast<double>(sorted.size());
    if (u_reference == 0) {
        double sum = 0;
        for (const double value : sorted) sum += std::abs(value - reference);
        return sum / n;
    }
    const double far = 8 * u_reference;  // beyond, the normal function is 0 or 1 to 1e-15
    std::vector<double> ends = sorted;
    ends.insert(ends.begin(), std::min(sorted.front(), reference - far));
    ends.push_back(std::max(sorted.back(), reference + far));
    double area = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        area += area_between(ends[k], ends[k + 1], static_cast<double>(k) / n, {reference, u_reference});
    return area;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/ablation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetdeck {

const char* const ablation_rule =
    "needed: unstable without it, or a quantity is not reached, or the error of one with an expected value "
    "grows by more than a quarter of its tolerance, or one without moves by more than its range over the "
    "spacings";

std::optional<double> AblationValue::change() const {
    if (!with || !without) return std::nullopt;
    if (!expected) return *without - *with;
    return std::abs(*without - *expected) - std::abs(*with - *expected);
}

std::vector<AblationValue> ablation_values(const RunSummary& with, const RunSummary& without,
                                           const std::map<std::string, double>& spreads) {
    std::vector<AblationValue> values;
    for (const QuantityResult& q : with.quantities) {
        AblationValue value{q.name, q.value, {}, q.expected, q.tolerance, {}};
        for (const QuantityResult& other : without.quantities) {
            if (other.name == q.name) value.without = other.value;
        }
        if (const auto spread = spreads.find(q.name); spread != spreads.end()) value.spread = spread->second;
        if (value.with || value.without) values.push_back(value);
    }
    for (const ComparisonResult& c : with.comparisons) {
        if (!c.available) continue;
        AblationValue value{"rms difference, " + c.title, c.nrmse, {}, 0.0, c.tolerance, {}};
        for (const ComparisonResult& other : without.comparisons) {
            if (other.title == c.title) value.without = other.nrmse;
        }
        if (value.with || value.without) values.push_back(value);
    }
    return values;
}

std::map<std::string, double> discretisation_spreads(const std::vector<ConvergenceRow>& rows,
                                                     const std::string& scene, const std::string& variant) {
    std::map<std::string, double> spreads;
    for (const ConvergenceRow& row : rows) {
        if (row.scene != scene || row.variant != variant || row.value.size() < 2) continue;
        const auto [low, high] = std::minmax_element(row.value.begin(), row.value.end());
        spreads[row.qoi] = *high - *low;
    }
    return spreads;
}

AblationVerdict ablation_verdict(bool stable_with, bool stable_without,
                                 const std::vector<AblationValue>& values) {
    if (!stable_with)
        return {false, stable_without ? "unstable with it, stable without" : "unstable with and without it"};
    if (!stable_without) return {true, "unstable without it"};
    bool compared = false;
    for (const AblationValue& value : values) {
        if (value.with && !value.without) return {true, value.name + " is not reached without it"};
        const std::optional<double> change = value.change();
        if (!change) continue;
        compared = compared || (value.expected ? value.tolerance : value.spread);
        if (value.expected && value.tolerance) {
            if (*change > significant_share_of_tolerance * *value.tolerance)
                return {true, fmt::format("error of {} grows by {:.3g}, tolerance {:.3g}", value.name,
                                          *change, *value.tolerance)};
        } else if (!value.expected && value.spread && std::abs(*change) > *value.spread) {
            return {true, fmt::format("{} moves by {:.3g}, over the spacings by {:.3g}", value.name, *change,
                                      *value.spread)};
        }
    }
    return {false, compared ? "no number changes by more than the rule allows"
                            : "nothing to compare: no quantity with a tolerance or with other spacings"};
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Whether an ingredient of the model is needed, judged from two runs, with it and without it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// One number of both runs: a quantity, or the rms difference of a comparison (expected to be zero).
struct AblationValue {
    std::string name;
    std::optional<double> with, without;
    std::optional<double> expected, tolerance;
    std::optional<double> spread;  ///< range over the spacings of the full model, if there are several

    /// |without - expected| - |with - expected|; where nothing is expected, without - with. Empty unless both
    /// runs have the number.
    std::optional<double> change() const;
};

/// All numbers of two runs of the same specification, in its order; those that neither has are left out.
/// `spreads` by name of the quantity.
std::vector<AblationValue> ablation_values(const RunSummary& with, const RunSummary& without,
                                           const std::map<std::string, double>& spreads);

/// Range of each quantity of a variant over its spacings.
std::map<std::string, double> discretisation_spreads(const std::vector<ConvergenceRow>& rows,
                                                     const std::string& scene, const std::string& variant);

struct AblationVerdict {
    bool needed = false;
    std::string reason;  ///< of both verdicts
};

/// Growth of an error, over the tolerance, below which a comparison rarely changes from success to failure.
inline constexpr double significant_share_of_tolerance = 0.25;

/// The rule of ablation_verdict in words.
extern const char* const ablation_rule;

/// Needed at this accuracy: the run without it is unstable, or does not reach a quantity that the run with it
/// has, or the error of a quantity with an expected value grows by more than a quarter of its tolerance, or
/// one without moves by more than its spread over the spacings. Not needed if the run with it is unstable:
/// then nothing was shown.
AblationVerdict ablation_verdict(bool stable_with, bool stable_without,
                                 const std::vector<AblationValue>& values);

}  // namespace wetdeck

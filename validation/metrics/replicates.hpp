// SPDX-License-Identifier: BSD-3-Clause
// Replicates: runs that differ by the arrangement of the particles alone (solver/settled_arrangement.hpp). A
// peak of an impact is one draw from a distribution; its standard deviation s is the part of u_num that no
// finer spacing shows.
#pragma once

#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Mean, standard deviation and the 95 % confidence interval of the mean, mean +- t s/sqrt(n) with Student's
/// t (GSL). Throws std::invalid_argument for fewer than two values. The caller fills in the rest.
ReplicateRow spread_of(std::vector<double> values);

/// One row for each variant and judged value of at least two replicates that reached their end.
std::vector<ReplicateRow> replicate_rows(const AnalysisSpec& scene, const std::vector<SensitivityRun>& runs);

/// Whether values at several spacings differ by no more than replicates do at one of them: the ratio of both
/// variances is within the 95 % of an F distribution.
bool differ_as_replicates(const std::vector<double>& values, const ReplicateRow& replicates);

/// The area between the distribution function of the replicates and that of the reference, a normal one of
/// standard deviation u_reference (a step where that is 0), in the unit of the quantity: the area metric of
/// Ferson, Oberkampf and Ginzburg (2008). Zero only if both distributions are the same.
double area_metric(const std::vector<double>& values, double reference, double u_reference);

}  // namespace wetdeck

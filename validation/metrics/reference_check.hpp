// SPDX-License-Identifier: BSD-3-Clause
// Whether the references that a scene names can be compared with its series, before anything is computed.
#pragma once

#include <set>
#include <string>

#include "validation/metrics/quantities.hpp"

namespace wetdeck {

/// Reads or computes every reference of the comparisons and quantities, and returns the names of those that
/// do not exist. Throws DataError for a file that is not sound or lacks a column, InputError "FILE:LINE: key
/// ..." for a series and a column of different dimensions, and for a plain scale that would have to be of
/// two.
std::set<std::string> check_references(const AnalysisSpec& scene, ReferenceShelf& references);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// A report holds one set-up of each variant. Stored runs of another one are found here, with what differs.
#pragma once

#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Takes the runs out whose set-up (see identity.hpp) is not that of the scene as its latest run saw it: runs
/// of an edited scene, with other keys set by hand, or of another revision of the scheme; and the runs of
/// studies that varied one of those. Returns them with what differs. Throws InputError where the scene of a
/// run cannot be read any more.
std::vector<LeftOutRun> leave_out_other_setups(std::vector<RunSummary>& runs,
                                               std::vector<SensitivityRun>& varied);

}  // namespace wetdeck

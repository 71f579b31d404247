// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck ablate`: what each ingredient of a scene's model buys and costs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "validation/jobs/suite.hpp"

namespace wetdeck {

struct AblateOptions {
    std::string scene;                   ///< name or path
    std::optional<std::string> variant;  ///< the scene's default if absent
    double particle_spacing = 0;         ///< [m]; 0: the coarsest of the quick tier
    std::optional<double> until;         ///< stop time [s]
};

/// Runs the plan of the scene (ablation_plan) as processes, finished ones reused: the full model where a
/// suite would put it, the others in DIR/ablation/SCENE/VARIANT/dxDX/. Prints a table, puts the rows into
/// DIR/ablation.json (others that it holds stay) and every number into table.json beside the runs. `suite`
/// says where and with how many processes, of one thread each: waiting threads would blur the cost. Returns
/// whether the full model stayed stable. Throws InputError where DIR holds another run of the full model that
/// `until` would replace.
bool run_ablation(const AblateOptions& options, SuiteOptions suite);

}  // namespace wetdeck

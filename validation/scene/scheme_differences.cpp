// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/scheme_differences.hpp"

#include <fmt/format.h>

#include "solver/time/time_step.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/schemes.hpp"

namespace wetdeck {
namespace {

std::string value_text(const KeyValue& value) {
    if (const double* number = std::get_if<double>(&value)) return fmt::format("{:.4g}", *number);
    return toml_text(value);
}

}  // namespace

std::vector<SchemeDifference> scheme_differences(const Scene& scene) {
    std::vector<SchemeDifference> differences;
    if (scene.source_scheme.empty()) return differences;
    Scene used = scene, source = scene;
    source.air = true;  // the source computes both phases unless the variant is one of its own
    apply_scheme(scene.source_scheme, source.model);
    used.model.air_substeps = scene.air ? air_substeps(scene.model) : 1;
    if (!takes_coarse_substeps(scene)) used.model.coarse_substeps = 1;
    source.model.air_substeps = source.model.coarse_substeps = 1;
    for (const ModelKey& row : model_keys()) {
        if (row.table == "execution" || (row.table == "air" && !scene.air)) continue;
        const KeyValue theirs = row.get(source), ours = row.get(used);
        if (theirs == ours) continue;
        differences.push_back(
            {row.dotted(), row.meaning, row.equation, value_text(theirs), value_text(ours)});
    }
    return differences;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/references.hpp"

#include "validation/metrics/reference_check.hpp"

namespace wetdeck {

std::set<std::string> check_references(const Scene& scene) {
    ReferenceShelf shelf(reference_directory() / scene.name(), scene.analysis.folder);
    return check_references(scene.analysis, shelf);
}

void check_references(const std::vector<SuiteRow>& rows) {
    std::set<std::pair<std::string, std::string>> seen;
    for (const SuiteRow& row : rows)
        if (seen.emplace(row.scene, row.variant).second)
            check_references(read_scene(find_scene(row.scene), row.variant));
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/references.hpp"

#include <map>

#include "validation/metrics/reference_check.hpp"

namespace wetdeck {

std::set<std::string> check_references(const Scene& scene) {
    ReferenceShelf shelf(reference_directory() / scene.name(), scene.analysis.folder);
    return check_references(scene.analysis, shelf);
}

void check_references(const std::vector<SuiteRow>& rows) {
    std::set<std::pair<std::string, std::string>> seen;
    std::map<std::string, ReferenceShelf> shelves;
    for (const SuiteRow& row : rows) {
        if (!seen.emplace(row.scene, row.variant).second) continue;
        const Scene scene = read_scene(find_scene(row.scene), row.variant);
        const auto shelf =
            shelves.try_emplace(row.scene, reference_directory() / scene.name(), scene.analysis.folder);
        check_references(scene.analysis, shelf.first->second);
    }
}

}  // namespace wetdeck

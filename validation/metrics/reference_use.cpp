// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/reference_use.hpp"

#include "validation/metrics/quantities.hpp"

namespace wetdeck {

std::set<std::string> references_in_use(const AnalysisSpec& scene) {
    std::set<std::string> names;
    for (const QuantitySpec& quantity : scene.quantities) names.insert(quantity.reference);
    for (const ComparisonSpec& comparison : scene.comparisons) names.insert(comparison.reference);
    names.erase("");
    return names;
}

std::set<std::string> unmentioned_references(const std::vector<AnalysisSpec>& variants,
                                             const std::filesystem::path& directory) {
    std::set<std::string> stems;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
        if (entry.path().extension() == ".csv") stems.insert(entry.path().stem().string());
    }
    for (const AnalysisSpec& variant : variants) {
        for (const std::string& used : references_in_use(variant)) stems.erase(used);
        for (const UnusedReference& unused : variant.unused_references) stems.erase(unused.file);
    }
    return stems;
}

void find_source_curves(AnalysisSpec& scene, const std::filesystem::path& directory) {
    for (SourceFigure& figure : scene.source_figures) {
        for (SourceCurve& curve : figure.curves) {
            curve.available =
                std::filesystem::exists(reference_file(curve.reference, scene.folder, directory));
        }
    }
}

}  // namespace wetdeck

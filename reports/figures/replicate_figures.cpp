// SPDX-License-Identifier: BSD-3-Clause
// Distribution functions of values that scatter among replicates.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/figures/figures.hpp"
#include "reports/figures/words.hpp"
#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

constexpr std::size_t most_figures = 4;

/// Over the reference: a mean may be next to nothing.
double relative_deviation(const ReplicateRow& row) {
    return *row.reference == 0 ? 0 : row.deviation / std::abs(*row.reference);
}

/// The share of the values up to each, as steps.
Curve distribution_of(const std::vector<double>& values) {
    Curve curve;
    for (std::size_t k = 0; k < values.size(); ++k) {
        for (const std::size_t below : {k, k + 1}) {
            curve.x.push_back(values[k]);
            curve.y.push_back(static_cast<double>(below) / static_cast<double>(values.size()));
        }
    }
    return curve;
}

Curve normal_distribution(double mean, double deviation) {
    constexpr int points = 120;
    Curve curve;
    for (int k = 0; k <= points; ++k) {
        const double z = 3 * (2.0 * k / points - 1);
        curve.x.push_back(mean + z * deviation);
        curve.y.push_back(0.5 * std::erfc(-z / std::sqrt(2.0)));
    }
    return curve;
}

Figure distribution_figure(const AnalysisSpec& scene, const std::vector<const ReplicateRow*>& rows) {
    const ReplicateRow& first = *rows.front();
    Figure figure;
    figure.name = fmt::format("{}-replicates-{}", first.scene, first.quantity);
    const std::string words = quantity_words(scene, first.quantity);
    figure.identifier = first.quantity;
    figure.title = fmt::format("{}, replicates: {}", first.scene, words);
    figure.x = {words, first.unit, false, {}};
    figure.y = {"share of the replicates up to the value", "-", false, Window{0, 1}};
    std::size_t place = 0;
    for (const ReplicateRow* row : rows) {
        figure.series.push_back(line(
            fmt::format("{} replicates, {} at {} m", row->value.size(), row->variant, number(row->dx, 4)),
            distribution_of(row->value), variant_colour(place++)));
    }
    const double spread = first.u_reference.value_or(0);
    PlotSeries reference = spread > 0
                               ? line("reference, normal with its uncertainty",
                                      normal_distribution(*first.reference, spread), "#111111")
                               : line("reference", {{*first.reference, *first.reference}, {0, 1}}, "#111111");
    reference.style = Style::dashed;
    figure.series.push_back(std::move(reference));
    return figure;
}

}  // namespace

std::vector<Figure> replicate_figures(const Summary& summary, const AnalysisSpec& scene) {
    std::map<std::string, std::vector<const ReplicateRow*>> quantities;
    for (const ReplicateRow& row : summary.replicates)
        if (row.scene == scene.scene && row.reference) quantities[row.quantity].push_back(&row);
    std::vector<std::vector<const ReplicateRow*>> sorted;
    for (auto& entry : quantities) sorted.push_back(std::move(entry.second));
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return relative_deviation(*a.front()) > relative_deviation(*b.front());
    });
    std::vector<Figure> figures;
    std::set<std::vector<double>> drawn;  // one value may be compared with several references
    for (const auto& rows : sorted) {
        if (figures.size() == most_figures) break;
        if (drawn.insert(rows.front()->value).second) figures.push_back(distribution_figure(scene, rows));
    }
    return figures;
}

}  // namespace wetdeck::report

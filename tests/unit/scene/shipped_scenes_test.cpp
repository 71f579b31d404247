// SPDX-License-Identifier: BSD-3-Clause
// The scenes that come with the program, against the data that come with it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "validation/analytic/curves.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/metrics/reference_use.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/recorders.hpp"
#include "validation/scene/scene.hpp"

using namespace wetdeck;

namespace {

/// Curves that could not be obtained; the README of the data says so.
const std::set<std::string> missing_curves = {
    "buchner2002_front",       "cao2018_energy",         "barcarolo2013_trajectory", "ma2016_force",
    "whelan2004_acceleration", "whelan2004_pressure_p4", "zhao1996_face_pressure"};

/// Calls `check(scene)` for every scene in every variant.
template <class Check>
void for_every_variant(const Check& check) {
    REQUIRE_FALSE(scene_names().empty());
    for (const std::string& name : scene_names()) {
        for (const VariantInfo& variant : read_scene(find_scene(name)).variants) {
            INFO(name << " " << variant.name);
            check(read_scene(find_scene(name), variant.name));
        }
    }
}

void check_curve(const Scene& scene, const std::string& reference, const std::string& x,
                 const std::string& y) {
    const std::filesystem::path file = reference_directory() / scene.name() / (reference + ".csv");
    INFO(file.string() << " " << x << " " << y);
    if (is_analytic(reference)) return;  // refused on reading if it does not exist
    if (missing_curves.count(reference)) {
        REQUIRE_FALSE(std::filesystem::exists(file));  // else take it off the list
        return;
    }
    const Reference data = load_reference(file);
    REQUIRE_NOTHROW(column_curve(data, x.empty() ? data.columns.front().name : x, y));
}

}  // namespace

TEST_CASE("every shipped scene is named like its file and described in every variant") {
    for_every_variant([](const Scene& scene) {
        REQUIRE(find_scene(scene.name()).stem() == scene.name());
        REQUIRE_FALSE(scene.analysis.purpose.empty());
        for (const VariantInfo& variant : scene.variants) REQUIRE_FALSE(variant.description.empty());
    });
}

TEST_CASE("every spacing of every tier fits its scene") {
    for_every_variant([](const Scene& scene) {
        for (const char* tier : {"quick", "standard", "paper"}) {
            INFO(tier);
            const auto spacings = scene.tiers.at(tier).find(scene.variant);
            if (spacings == scene.tiers.at(tier).end()) continue;
            for (const double dx : spacings->second) {
                if (scene.tank.high.prod() / (dx * dx) > 1e5) continue;  // fits where a multiple fits
                REQUIRE_NOTHROW(check_spacing(scene, dx));
            }
        }
    });
}

TEST_CASE("the spacings of a judged variant are a quarter apart, and those of the standard tier are enough") {
    for_every_variant([](const Scene& scene) {
        for (const char* tier : {"quick", "standard"}) {
            INFO(tier);
            const auto found = scene.tiers.at(tier).find(scene.variant);
            if (found == scene.tiers.at(tier).end()) continue;
            std::vector<double> spacings = found->second;
            std::sort(spacings.begin(), spacings.end());
            const bool judged = spacings.size() >= 3;
            if (tier == std::string("standard") && scene.variant == scene.analysis.default_variant)
                CHECK(judged);
            for (std::size_t k = 0; judged && k + 1 < spacings.size(); ++k)
                CHECK(spacings[k + 1] / spacings[k] >= 1.25 * (1 - 1e-6));
        }
    });
}

TEST_CASE("every reference of a shipped scene can be loaded or is known to be missing") {
    for_every_variant([](const Scene& scene) {
        if (scene.variant == scene.analysis.default_variant)
            REQUIRE_FALSE(scene.analysis.comparisons.empty());
        for (const ComparisonSpec& c : scene.analysis.comparisons)
            check_curve(scene, c.reference, c.x_column, c.y_column);
        for (const QuantitySpec& q : scene.analysis.quantities) {
            if (!q.reference.empty()) check_curve(scene, q.reference, "", q.y_column);
        }
    });
}

TEST_CASE("every quantity and comparison of a shipped scene speaks of a series that its runs record") {
    for_every_variant([](const Scene& scene) {
        double spacing = 0;  // any that fits
        for (const auto& [name, tier] : scene.tiers) {
            if (tier.count(scene.variant)) spacing = tier.at(scene.variant).front();
        }
        REQUIRE(spacing > 0);
        const Recorders recorders(scene, spacing);
        std::set<std::string> recorded;
        for (const SeriesInfo& recorder : recorders.list()) recorded.insert(recorder.name);
        for (const AnalysedSeries& each : analysed_series()) recorded.insert(each.info.name);
        for (const FieldSeries& each : field_series(scene)) recorded.insert(each.info.name);
        for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
            for (const DerivedSeries& each : derived_body_series())
                recorded.insert(body_series_name(each.info.name, body));
        }
        for (const QuantitySpec& q : scene.analysis.quantities) REQUIRE(recorded.count(q.series) == 1);
        for (const ComparisonSpec& c : scene.analysis.comparisons) REQUIRE(recorded.count(c.quantity) == 1);
    });
}

TEST_CASE("every reference file of a shipped scene is compared with, or listed with the reason why not") {
    for (const std::string& name : scene_names()) {
        const std::filesystem::path folder = reference_directory() / name;
        std::vector<AnalysisSpec> variants;
        for (const VariantInfo& variant : read_scene(find_scene(name)).variants)
            variants.push_back(read_scene(find_scene(name), variant.name).analysis);
        INFO(name);
        CHECK(unmentioned_references(variants, folder).empty());
        for (const UnusedReference& unused : variants.front().unused_references) {
            INFO(unused.file);
            CHECK(std::filesystem::exists(folder / (unused.file + ".csv")));
        }
    }
}

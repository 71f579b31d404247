// SPDX-License-Identifier: BSD-3-Clause
// Order, names and colours of runs.
#include "reports/figures/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

struct Rgb {
    int red, green, blue;
};

struct Hue {
    Rgb light, dark;
};

/// Blue, orange, green, purple, teal: the dark ends can be told apart in print and by colour-blind readers.
constexpr std::array<Hue, 5> hues{{{{158, 202, 225}, {8, 48, 107}},
                                   {{253, 190, 133}, {166, 54, 3}},
                                   {{161, 217, 155}, {0, 90, 50}},
                                   {{203, 201, 226}, {84, 39, 143}},
                                   {{153, 216, 201}, {0, 88, 86}}}};

std::string mixed(const Hue& hue, double darkness) {
    const auto mix = [&](int light, int dark) {
        return static_cast<int>(light + darkness * (dark - light) + 0.5);
    };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(hue.light.red, hue.dark.red),
                       mix(hue.light.green, hue.dark.green), mix(hue.light.blue, hue.dark.blue));
}

}  // namespace

bool about_runs(const Summary& summary) {
    return !summary.runs.empty() || !summary.missing.empty() ||
           (summary.verification.empty() && summary.stress.empty());
}

std::vector<AnalysisSpec> scenes_of(const Summary& summary) {
    std::vector<AnalysisSpec> scenes = summary.scenes;
    for (const RunSummary& run : summary.runs) {
        const std::string& name = run.record.scene;
        const auto same = [&](const AnalysisSpec& scene) { return scene.scene == name; };
        if (std::none_of(scenes.begin(), scenes.end(), same)) {
            AnalysisSpec scene;
            scene.scene = scene.title = name;
            scenes.push_back(scene);
        }
    }
    return scenes;
}

Runs runs_of(const Summary& summary, const AnalysisSpec& scene) {
    Runs runs;
    for (const RunSummary& run : summary.runs) {
        if (run.record.scene == scene.scene) runs.push_back(&run);
    }
    const auto key = [&](const RunSummary* run) {
        const RunRecord& record = run->record;
        return std::tuple(record.variant != scene.default_variant, record.variant, -record.particle_spacing,
                          run->directory);
    };
    std::sort(runs.begin(), runs.end(), [&](const auto* a, const auto* b) { return key(a) < key(b); });
    return runs;
}

bool unstable_as_expected(const RunSummary& run) {
    return run.expected_unstable && run.record.status == RunStatus::unstable;
}

std::vector<std::string> variants_of(const Runs& runs) {
    std::vector<std::string> variants;
    for (const RunSummary* run : runs) {
        if (variants.empty() || variants.back() != run->record.variant)
            variants.push_back(run->record.variant);
    }
    return variants;
}

Runs with_variant(const Runs& runs, const std::string& variant) {
    Runs out;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(out),
                 [&](const RunSummary* run) { return run->record.variant == variant; });
    return out;
}

Runs finest_of_each(const Runs& runs) {
    Runs out;
    for (const std::string& variant : variants_of(runs)) out.push_back(with_variant(runs, variant).back());
    return out;
}

Runs side_by_side_runs(const Runs& runs, const SideBySide& entry) {
    std::map<double, Runs> by_spacing;
    Runs finest;
    for (const std::string& variant : entry.variants) {
        const Runs own = with_variant(runs, variant);
        for (const RunSummary* run : own) by_spacing[run->record.particle_spacing].push_back(run);
        if (!own.empty()) finest.push_back(own.back());
    }
    for (const auto& [spacing, common] : by_spacing)
        if (common.size() == entry.variants.size()) return common;
    return finest;
}

const RunSummary* finest_completed(const Runs& runs) {
    const RunSummary* finest = nullptr;
    for (const RunSummary* run : runs) {
        const RunRecord& record = run->record;
        if (record.variant == runs.front()->record.variant && record.status == RunStatus::ok) finest = run;
    }
    return finest;
}

std::string spacing_text(double particle_spacing) {
    return number(particle_spacing, 4) + " m";
}

std::string run_name(const RunSummary& run) {
    return fmt::format("{}, {}, dx = {}", run.record.scene, run.record.variant,
                       spacing_text(run.record.particle_spacing));
}

std::string provenance_of(const RunRecord& record, const std::string& key) {
    const auto entry = record.provenance.find(key);
    return entry == record.provenance.end() ? "unknown" : entry->second;
}

std::string revision_of(const RunSummary& run) {
    return provenance_of(run.record, "commit");
}

std::string unit_of_quantity(const AnalysisSpec& scene, const std::string& quantity) {
    for (const QuantitySpec& spec : scene.quantities) {
        if (spec.name == quantity) return spec.unit;
    }
    return "-";
}

std::string stamp_of(const Summary& summary) {
    if (summary.runs.empty()) return "";
    std::set<std::string> revisions;
    for (const RunSummary& run : summary.runs) revisions.insert(revision_of(run));
    std::string out = "revision";
    std::size_t named = 0;
    for (const std::string& revision : revisions) {
        if (named++ == 3) return out + " and others";
        out += (named == 1 ? " " : ", ") + revision;
    }
    const auto& entries = summary.runs.front().record.provenance;
    for (const char* key : {"compiler", "cpu"}) {
        const auto found = entries.find(key);
        if (found != entries.end()) out += "; " + found->second;
    }
    return out;
}

std::string run_colour(std::size_t variant, std::size_t spacing, std::size_t spacings) {
    const double darkness =
        spacings < 2 ? 0.9 : 0.1 + 0.9 * static_cast<double>(spacing) / static_cast<double>(spacings - 1);
    return mixed(hues[variant % hues.size()], darkness);
}

std::string variant_colour(std::size_t variant) {
    return mixed(hues[variant % hues.size()], 0.75);
}

}  // namespace wetdeck::report

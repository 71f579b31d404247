// SPDX-License-Identifier: BSD-3-Clause
// Scratch folders and sample data for the tests of the store.
#pragma once

#include <stdlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "validation/store/fields.hpp"
#include "validation/store/run_record.hpp"
#include "validation/store/temporary_folder.hpp"

namespace wetdeck::samples {

/// A new folder, removed with its scope.
class ScratchFolder : public TemporaryFolder {
  public:
    operator const std::filesystem::path&() const { return path(); }
    std::filesystem::path operator/(const std::string& name) const { return path() / name; }
};

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

inline void put_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

/// Names in a folder, for "nothing else was left behind".
inline std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    return names;
}

/// Bit by bit, so that NaN and -0 count.
template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0);
}

inline bool same(const Series& a, const Series& b) {
    return a.unit == b.unit && a.description == b.description && same_bits(a.time, b.time) &&
           same_bits(a.value, b.value) && same_bits(a.abscissa, b.abscissa);
}

/// A record with `rows` samples in its long series and every awkward case in the others.
inline RunRecord record(std::size_t rows = 2000) {
    RunRecord run;
    run.scene = "dam_break";
    run.variant = "zwei-phasig ψ";
    run.particle_spacing = 0.1;
    run.fluid_particles = 5'000'000'000;
    run.particles = 5'000'000'321;
    run.status = RunStatus::unstable;
    run.stop_reason = "at t = 0.3 s near (1.2 m, 0.1 m): ρ left its range — see the fields";
    run.scene_text = "# Δx = 0.01 m\n[water]\nsound_speed = 40.0\n";
    run.scene_path = "scenes/dam_break.toml";
    run.parameters = {{"water.sound_speed", 40.0}, {"gravity", -9.81}, {"tiny", 5e-324}};
    run.provenance = {{"model.wall", "no-slip"}, {"commit", "0123456789ab"}, {"empty", ""}};
    Series front{"m", "furthest water particle", {}, {}, {}};
    for (std::size_t i = 0; i < rows; ++i) {
        front.time.push_back(0.1 * static_cast<double>(i));
        front.value.push_back(std::sin(static_cast<double>(i * i)));
    }
    run.series["front"] = front;
    run.series["never_sampled"] = {"Pa", "", {}, {}, {}};
    run.series["face_pressure"] = {
        "Pa", "along the face", {0.0, 0.5}, {1, 2, 3, -0.0, std::nan(""), 6}, {0, 1, 2.5}};
    run.series["one_column"] = {"Pa", "one place", {0.0, 0.5}, {7, 8}, {0.25}};
    run.series["no_rows"] = {"Pa", "no time", {}, {}, {0.25, 0.5}};
    run.cost = {12.5,
                24.25,
                18'000'000'000'000'000'001U,
                9.5e12,
                321.5,
                {{"pair_loop", 10.0}, {"io", 0.5}},
                {{"acoustic", 17}, {"body/force", 3}}};
    return run;
}

inline bool same(const RunRecord& a, const RunRecord& b) {
    bool equal = a.scene == b.scene && a.variant == b.variant && a.particle_spacing == b.particle_spacing &&
                 a.fluid_particles == b.fluid_particles && a.particles == b.particles &&
                 a.status == b.status && a.stop_reason == b.stop_reason && a.scene_text == b.scene_text &&
                 a.scene_path == b.scene_path && a.parameters == b.parameters &&
                 a.provenance == b.provenance && a.cost.wall_s == b.cost.wall_s &&
                 a.cost.core_s == b.cost.core_s && a.cost.steps == b.cost.steps &&
                 a.cost.particle_steps == b.cost.particle_steps && a.cost.peak_rss_mb == b.cost.peak_rss_mb &&
                 a.cost.stage_seconds == b.cost.stage_seconds &&
                 a.cost.limiting_criterion == b.cost.limiting_criterion && a.series.size() == b.series.size();
    for (const auto& [name, series] : a.series) {
        const auto other = b.series.find(name);
        equal = equal && other != b.series.end() && same(series, other->second);
    }
    return equal;
}

/// Water, air, a wall and a body; ids that a double cannot hold.
inline FieldFrame frame(double time, std::size_t particles = 400) {
    FieldFrame result;
    result.time = time;
    for (std::size_t i = 0; i < particles; ++i) {
        const auto k = static_cast<float>(i);
        result.x.push_back(0.1F * std::fmod(k, 20.0F));
        result.y.push_back(0.1F * std::floor(k / 20.0F));
        result.vx.push_back(std::cos(k) + static_cast<float>(time));
        result.vy.push_back(-1.0F / (k + 3));
        result.pressure.push_back(1e3F * std::sin(k));
        result.density.push_back(1000 + 1e-4F * k);
        result.phase.push_back(static_cast<int>(i % 4));
        result.id.push_back(std::numeric_limits<std::int64_t>::max() - static_cast<std::int64_t>(i));
    }
    return result;
}

inline bool same(const FieldFrame& a, const FieldFrame& b) {
    return a.time == b.time && same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.vx, b.vx) &&
           same_bits(a.vy, b.vy) && same_bits(a.pressure, b.pressure) && same_bits(a.density, b.density) &&
           a.phase == b.phase && a.id == b.id;
}

/// The pages of a report by file name.
inline std::map<std::string, std::string> pages_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> pages;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".html")
            pages[entry.path().filename().string()] = bytes_of(entry.path());
    return pages;
}

/// All pages behind each other, the first page first.
inline std::string joined(const std::map<std::string, std::string>& pages) {
    std::string all = pages.at("index.html");
    for (const auto& [name, page] : pages)
        if (name != "index.html") all += page;
    return all;
}

inline std::string report_in(const std::filesystem::path& folder) {
    return joined(pages_in(folder));
}

}  // namespace wetdeck::samples

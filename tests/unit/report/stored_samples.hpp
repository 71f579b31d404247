// SPDX-License-Identifier: BSD-3-Clause
// Made-up run stores with known answers: the front of the small scene is a line plus a multiple of dx^2.
#pragma once

#include <stdlib.h>

#include <filesystem>

#include "tests/unit/scene/scene_samples.hpp"
#include "tests/unit/store/store_samples.hpp"
#include "validation/commands/stored_report.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck::samples {

/// Reference data of its own for the program, as long as it lives: x = 1 + T for the front of the small
/// scene.
class OwnReferences {
  public:
    OwnReferences() {
        const std::filesystem::path folder = root_ / "reference_data/small";
        std::filesystem::create_directories(folder);
        put_bytes(
            folder / "nobody_front.csv",
            "# kind: experiment\n# citation: made up\n# doi: none\n# figure: none\n# obtained: computed\n"
            "# obtained_from: x = 1 + T\n# date: 2020-01-01\n# digitisation_error: none\n# u_data: 0.01\n"
            "# u_data_source: made up\n# sensor: none\n# filter: none\n# sign: none\n# time_origin: none\n"
            "# note: none\nT [-],x [-]\n0,1\n1,2\n");
        ::setenv("WETDECK_DATA", root_.operator const std::filesystem::path&().c_str(), 1);
    }
    ~OwnReferences() { ::unsetenv("WETDECK_DATA"); }
    OwnReferences(const OwnReferences&) = delete;
    OwnReferences& operator=(const OwnReferences&) = delete;

  private:
    ScratchFolder root_;
};

/// Scaled front 1 + T + `factor` dx^2 over 0 < T < 1.4, sampled every 0.02.
inline RunRecord stored_run(double dx, double factor = 3, const std::string& scene = small_scene) {
    RunRecord record;
    record.scene = "small";
    record.variant = "two-phase";
    record.particle_spacing = dx;
    record.particles = record.fluid_particles = 100;
    record.scene_text = scene;
    record.scene_path = "small.toml";
    record.provenance = {
        {"commit", "abc1234"}, {"start_time", "2020-01-01T00:00:00Z"}, {"compiler", "a compiler"}};
    record.cost.wall_s = record.cost.core_s = 1 / dx;
    record.cost.steps = 10;
    record.cost.particle_steps = 1000;
    Series front{"m", "made up", {}, {}, {}};
    for (int i = 0; i <= 70; ++i) {
        front.time.push_back(0.1428 * 0.02 * i);
        front.value.push_back(0.2 * (1 + 0.02 * i + factor * dx * dx));
    }
    record.series["front"] = std::move(front);
    return record;
}

inline void store(const std::filesystem::path& directory, const RunRecord& record) {
    std::filesystem::create_directories(directory);
    write_run(directory, record);
}

/// Three spacings of one variant.
inline void store_sweep(const std::filesystem::path& directory, double factor = 3,
                        const std::string& scene = small_scene) {
    for (const double dx : {0.04, 0.02, 0.01})
        store(directory / "runs" / std::to_string(dx), stored_run(dx, factor, scene));
}

}  // namespace wetdeck::samples

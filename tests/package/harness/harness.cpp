// SPDX-License-Identifier: BSD-3-Clause
// Runs a scene for an instant, stores it and reads it back: how it ended, and whether the front was recorded.
#include <cstdio>
#include <wetdeck/validation/run/run.hpp>
#include <wetdeck/validation/store/run_store.hpp>

using namespace wetdeck;

int main(int, char** argv) {
    const Scene scene = read_scene(find_scene(argv[1]), "single-phase");
    RunOptions options;
    options.directory = argv[2];
    options.particle_spacing = 0.04;
    options.until = 2 * scene.sample_interval;
    Progress progress("", true);
    run_scene(scene, options, progress);
    const RunRecord record = read_run(run_file(argv[2]));
    std::printf("%s front %zu\n", to_string(record.status).c_str(), record.series.at("front").time.size());
}

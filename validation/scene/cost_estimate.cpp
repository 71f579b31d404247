// SPDX-License-Identifier: BSD-3-Clause
// What a run of a scene will cost.
#include <algorithm>
#include <cmath>

#include "solver/time/time_step.hpp"
#include "validation/scene/resolution_section.hpp"
#include "validation/scene/symmetry_section.hpp"

namespace wetdeck {

CostEstimate estimate_cost(const Scene& scene, double particle_spacing) {
    // What the default scheme reaches per core on AVX-512 over whole runs, how much longer a particle-step
    // takes where spacings differ, and what a particle costs in a field file; measured over the quick tier.
    constexpr double steps_per_second_alone = 7.4e6, steps_per_second_with_air = 8.6e6, differing = 1.6,
                     seconds_in_frame = 1e-6;
    // Of a particle-step: what slow fluid costs in a step of the fast that leaves it alone.
    constexpr double resting = 0.2;
    const auto area = [](const std::vector<Box>& boxes) {
        double sum = 0;
        for (const Box& box : boxes) sum += (box.high - box.low).prod();
        return sum;
    };
    CostEstimate cost;
    const double volume = particle_spacing * particle_spacing;
    const double computed = scene.symmetry ? 0.5 : 1;
    double water = computed * area(scene.water_boxes) / volume,
           air = scene.air ? computed * area(scene.air_boxes) / volume : 0;
    double fast = air;
    int coarse = 1;
    if (scene.resolution) {
        const SceneCells cells = cells_of(scene.symmetry ? right_half(scene) : scene, particle_spacing);
        water = static_cast<double>(cells.water.size());
        air = fast = scene.air ? static_cast<double>(cells.above.size()) : 0;
        if (takes_coarse_substeps(scene)) {
            std::vector<double> finenesses;
            for (const Box& cell : cells.water)
                finenesses.push_back(particle_spacing / std::sqrt((cell.high - cell.low).prod()));
            coarse = coarse_substeps(scene.model, finenesses);
            if (coarse > 1)
                fast = static_cast<double>(std::count_if(finenesses.begin(), finenesses.end(),
                                                         [coarse](double f) { return f > 1.0 / coarse; }));
        }
    }
    cost.fluid_particles = water + air;
    // speeds scale with the water's sound speed, which is set to ten times the fastest water
    const double fastest = 0.15 * scene.model.water.eos.sound_speed;
    const double h = scene.model.smoothing_ratio * particle_spacing;
    const TimeStep step = step_of(
        scene.model, stable_time_step(scene.model, h, {{fastest, 4 * fastest}}, true, scene.air, coarse));
    cost.steps = scene.end_time / step.size;
    const int substeps = scene.air ? air_substeps(scene.model) : coarse;
    const double slow = water + air - fast;
    cost.particle_steps = cost.steps * (slow + fast * substeps);
    const double work = cost.particle_steps + resting * cost.steps * slow * (substeps - 1);
    cost.core_seconds =
        (scene.resolution ? differing : 1) * work /
            (scene.air ? steps_per_second_with_air : steps_per_second_alone) +
        cost.fluid_particles * static_cast<double>(scene.frame_times.size()) * seconds_in_frame;
    return cost;
}

}  // namespace wetdeck

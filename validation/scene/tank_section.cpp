// SPDX-License-Identifier: BSD-3-Clause
// The tank: its size or its outline, and its motion.
#include <fmt/format.h>

#include "solver/core/errors.hpp"
#include "validation/scene/faces.hpp"
#include "validation/scene/motion_section.hpp"
#include "validation/scene/sections.hpp"

namespace wetdeck {

Outline read_tank(const TomlTable& tank, Scene& scene) {
    if (!tank.has("outline")) {
        const std::vector<double> size = tank.numbers("size", 2);
        if (!(size[0] > 0 && size[1] > 0)) tank.fail("size", "expected two positive lengths");
        scene.tank.high = {size[0], size[1]};
        return {};
    }
    if (tank.has("size")) tank.fail("size", "is given beside 'outline', expected one of the two");
    Outline outline;
    for (const std::vector<double>& corner : tank.number_rows("outline", 2))
        outline.emplace_back(corner[0], corner[1]);
    try {
        check_outline(outline);
    } catch (const InputError& error) {
        tank.fail("outline", error.what());
    }
    const Box extent = extent_of(outline);
    if (extent.low.norm() > 1e-9)
        tank.fail("outline", fmt::format("has its lowest x and y at ({:.6g}, {:.6g}), expected (0, 0)",
                                         extent.low.x(), extent.low.y()));
    scene.tank.high = extent.high;
    return outline;
}

void read_tank_motion(const TomlTable& tank, Scene& scene) {
    const GivenMotions given = read_motions(tank, scene.end_time, scene.model.water.eos.sound_speed);
    scene.tank_motion.motion = given.motion;
    if (tank.has("roll_centre")) {
        if (!given.motion[2]) tank.fail("roll_centre", "is that of a roll, and 'motion' gives none");
        scene.tank_motion.centre = point(tank, "roll_centre");
    } else if (given.motion[2]) {
        tank.fail_missing("roll_centre", "expected the point [x, y] about which the tank rolls");
    }
    scene.tank_guide = tank.text_of("motion") + tank.text_of("roll_centre");
    if (scene.tank_motion.moves() && scene.model.sponge_thickness > 0)
        tank.fail("motion",
                  "moves a tank that has a sponge layer (model.sponge_thickness): its damping "
                  "is that of a tank at rest");
    tank.finish();
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/scene_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/openfoam/scene_gauges.hpp"
#include "validation/openfoam/scene_shape.hpp"
#include "validation/openfoam/section_mesh.hpp"
#include "validation/openfoam/shapes.hpp"

namespace wetdeck {
namespace {

constexpr double field_frames = 20;   // field files of a run
constexpr double far_open = 0.18;     // height of the open boundary over the radius of a wedge's mesh
constexpr double fine_around = 0.25;  // width of small cells around a section, over its breadth
constexpr double fewest_cells = 8;    // along a tank's side, a body's half breadth or a wedge's side
constexpr double most_cells = 2e6;

FoamPhase phase_of(const Material& material) {
    const TaitEquationOfState& eos = material.eos;
    return {eos.reference_density, material.viscosity, eos.sound_speed, eos.exponent};
}

/// A phase of the case where the scene has no air: as light as can be without harm.
FoamPhase light_air() {
    return {1, 1e-5, 0, 1.4};
}

/// Both fluids by wetdeck's law of Tait.
void write_compressible(SceneCase& written) {
    FoamCase& foam = written.foam;
    foam.compressible = true;
    foam.air_pressure = foam.air.density * foam.air.sound_speed * foam.air.sound_speed / foam.air.exponent;
    foam.largest_step = 0.5 * written.cell / foam.water.sound_speed;
    written.differences.emplace_back(fmt::format(
        "Compressible water and air (compressibleInterFoam), both with wetdeck's law of Tait: water at "
        "{:.6g} m/s, air at {:.6g} m/s with an exponent of {:.6g} from {:.6g} Pa absolute. No heat: the "
        "temperature stays.",
        foam.water.sound_speed, foam.air.sound_speed, foam.air.exponent, foam.air_pressure));
    written.differences.emplace_back("Pressures are absolute; gauges are read back as gauge pressures.");
}

void write_incompressible(SceneCase& written) {
    written.differences.emplace_back(
        "Incompressible water and air (interFoam); wetdeck computes both as weakly compressible.");
}

void write_tank(const Scene& scene, SceneCase& written) {
    FoamCase& foam = written.foam;
    foam.mesh = tank_mesh(scene.tank, written.cell);
    foam.reference = scene.tank.high - Vec2(0.5 * written.cell, 0.5 * written.cell);
    const double height = scene.tank.high.y() - scene.tank.low.y();
    foam.largest_step = 0.1 * written.cell / std::sqrt(-scene.model.gravity.y() * height);
    write_incompressible(written);
    written.differences.emplace_back(
        fmt::format("Pressures are relative to the cell at ({:.6g}, {:.6g}) m, in the upper right corner.",
                    foam.reference->x(), foam.reference->y()));
    if (scene.initial.law == InitialPressure::Law::greco)
        written.differences.emplace_back(
            "The pressure at the start follows from the equations in the first step; wetdeck is given it.");
}

void write_plate(const Scene& scene, const FoamBody& body, SceneCase& written) {
    if (!scene.air) refuse_for_foam(scene, "it has a flat bottom and no air: what cushions it is air");
    write_compressible(written);
    written.foam.mesh = plate_mesh({scene.tank, body.extent, written.cell});
    written.differences.emplace_back(fmt::format(
        "Cells under the plate are {:.4g} mm high and {:.4g} mm wide: the air film is resolved down to them.",
        1e3 * film_cell(written.cell), 1e3 * written.cell));
    written.differences.emplace_back(
        "The floor is an inflow of water at the speed of the body: seen from the body it comes up, and sound "
        "is reflected there as at a wall. The roof is open; wetdeck's tank is closed.");
}

void write_section(const Scene& scene, const FoamBody& body, SceneCase& written) {
    FoamCase& foam = written.foam;
    const bool cushioned = body.flat || body.hollow;
    if (cushioned && !scene.air)
        refuse_for_foam(
            scene, fmt::format("{} and no air: what cushions it is air",
                               body.flat ? "it has a flat bottom" : "it has an underside that shuts in air"));
    if (cushioned) {
        write_compressible(written);
    } else {
        write_incompressible(written);
        foam.largest_step = 0.05 * written.cell / body.speed;
        if (scene.air)
            written.differences.emplace_back(
                "Air does not give way: the bottom is flatter than 4 degrees over less than a tenth of the "
                "beam and shuts in no "
                "air, so that it can flow off.");
    }
    const std::vector<Vec2>& outline = scene.bodies.front().outline;
    // Water wets about twice the depth of entry.
    const double level = scene.water_boxes.front().high.y(),
                 breadth = body.extent.high.x() - body.extent.low.x(), around = fine_around * breadth;
    const double top = std::min(body.extent.high.y(), level + 2 * body.speed * foam.end_time);
    SectionShape shape{scene.tank, outline, {}, written.cell};
    shape.fine.low = body.extent.low - Vec2(around, around);
    shape.fine.high = {body.extent.high.x() + around, top + 0.5 * around};
    foam.geometry = section_geometry(shape);
    foam.mesh = section_mesh(shape);
    foam.slanted_correctors = 1;
    foam.moment_centre = scene.bodies.front().body.position;
    written.force_factor = 1;
    written.differences.emplace_back(fmt::format(
        "The mesh is made by gmsh from section.geo, follows the section ({} of its {} corners: a curve is "
        "followed by sides of two cells) and has no triangles; cells are up to six times as large away from "
        "it. Its cells are slanted: builds of OpenFOAM that compute those wrongly give wrong loads.",
        meshed_corners(outline, written.cell).size(), outline.size()));
    written.differences.emplace_back(
        "The floor is an inflow of water at the speed of the body and keeps its distance from it; the roof "
        "is "
        "open. wetdeck's tank is closed, and its floor comes nearer.");
    written.differences.emplace_back(
        "Suction has no limit: water that has wet a curved side follows it around, and pulls; wetdeck's "
        "water "
        "without air leaves it. Compare rounded sections until the flow would separate.");
    if (scene.symmetry)
        written.differences.emplace_back("The whole is computed; wetdeck computes half of it.");
}

void write_wedge(const Scene& scene, const FoamBody& body, SceneCase& written) {
    FoamCase& foam = written.foam;
    const double radius =
        std::min(0.5 * (scene.tank.high.x() - scene.tank.low.x()), body.keel.y() - scene.tank.low.y());
    foam.mesh = wedge_mesh({body.keel, body.deadrise, body.side, radius,
                            std::min(far_open, 0.5 * std::sin(body.deadrise)) * radius, written.cell});
    // Wagner: the water wets half a breadth of pi V t/(2 tan b)
    const double gap = body.keel.y() - scene.water_boxes.front().high.y();
    const double half = body.side * std::cos(body.deadrise);
    const double wet = (gap + 2 * half * std::tan(body.deadrise) / std::numbers::pi) / body.speed;
    foam.end_time = std::min(foam.end_time, wet);
    foam.largest_step = 0.05 * written.cell / body.speed;
    write_incompressible(written);
    written.differences.emplace_back(
        fmt::format("The side of the wedge goes on straight to the far boundary; the run ends at {:.6g} s, "
                    "when the water has "
                    "reached the chine after Wagner.",
                    foam.end_time));
    written.differences.emplace_back(
        fmt::format("The mesh is the conformal map of a square and reaches {:.4g} m along the axis and along "
                    "the side; there "
                    "water comes in and leaves at the speed of the stream. wetdeck's tank has a floor and "
                    "walls. The upper "
                    "part of the far boundary is open.",
                    radius));
}

void check_size(const Scene& scene, double cell, const std::optional<FoamBody>& body) {
    if (!(cell > 0) || !std::isfinite(cell)) throw InputError("the size of the cells must be positive");
    const Vec2 size = scene.tank.high - scene.tank.low;
    const double length = !body ? std::min(size.x(), size.y())
                          : body->shape == FoamBody::Shape::wedge
                              ? body->side
                              : 0.5 * (body->extent.high.x() - body->extent.low.x());
    if (length / cell < fewest_cells)
        throw InputError(fmt::format("cells of {:.4g} m: expected at most {:.4g} m, {} of them over {:.4g} m",
                                     cell, length / fewest_cells, fewest_cells, length));
    if (size.x() * size.y() / (cell * cell) > most_cells)
        throw InputError(fmt::format("cells of {:.4g} m: more than {:.2g} of them", cell, most_cells));
}

}  // namespace

const char* const foam_supported =
    "tanks without bodies, and one body of constant speed straight down over one level of water: flat plates "
    "with air, upright wedges and, on a mesh of gmsh, any other section";

SceneCase scene_case(const Scene& scene, double cell, std::optional<double> until) {
    const std::optional<FoamBody> body = foam_body(scene);
    check_size(scene, cell, body);
    SceneCase written;
    written.cell = cell;
    written.shape = !body                                   ? "tank"
                    : body->shape == FoamBody::Shape::plate ? "plate"
                    : body->shape == FoamBody::Shape::wedge ? "wedge"
                                                            : "section";
    FoamCase& foam = written.foam;
    foam.gravity = scene.model.gravity;
    foam.water = phase_of(scene.model.water);
    foam.air = scene.air ? phase_of(scene.model.air) : light_air();
    foam.water_boxes = scene.water_boxes;
    foam.end_time = until.value_or(scene.end_time);
    if (!scene.air)
        written.differences.emplace_back(
            "Air of 1 kg/m^3 is computed, for the method needs a second phase; wetdeck computes water "
            "alone.");
    if (!body) {
        write_tank(scene, written);
    } else {
        foam.has_body = true;
        foam.stream = {0, body->speed};
        foam.level = scene.water_boxes.front().high.y();
        foam.water_boxes.front().low -= Vec2(1e3, 1e3);
        foam.water_boxes.front().high += Vec2(1e3, 0);
        written.force_factor = 2;
        if (written.shape == "plate") write_plate(scene, *body, written);
        if (written.shape == "wedge") write_wedge(scene, *body, written);
        if (written.shape == "section") write_section(scene, *body, written);
        written.differences.emplace_back(
            fmt::format("The body is at rest and water and air come up at {:.6g} m/s: places are those of "
                        "the scene at its start, times those of its clock.",
                        body->speed));
        written.differences.emplace_back(
            "The stream is set at once: the first steps hold the jolt of an impulsive start, a load that is "
            "no part of the scene; judge from contact on.");
        if (written.force_factor == 2)
            written.differences.emplace_back(
                "The right half is computed, with a plane of symmetry: loads are half.");
    }
    written.differences.emplace_back(
        "Walls and bodies slip, as in wetdeck's default; laminar; no surface tension.");
    written.differences.emplace_back("The boundary between water and air is spread over two or three cells.");
    foam.field_interval = foam.end_time / field_frames;
    add_gauges(scene, written.force_factor == 2 ? std::optional(body->keel.x()) : std::nullopt, written);
    return written;
}

std::string foam_differences(const Scene& scene, const SceneCase& written) {
    std::string text = fmt::format(
        "# Scene `{}`, variant `{}`, for OpenFOAM\n\nWritten for `{}` with {} cells of {:.6g} m ({}), one "
        "layer {} m "
        "thick. `./run.sh` runs it.\n\n## What differs from the scene\n\n",
        scene.name(), scene.variant, written.foam.solver(), written.foam.mesh.cells.size(), written.cell,
        written.shape, foam_layer);
    for (const std::string& difference : written.differences) text += "- " + difference + "\n";
    text += "\n## Bringing the curves back\n\n";
    if (written.foam.has_body)
        text += fmt::format(
            "    wetdeck import openfoam postProcessing/body --column force_y --factor {:.6g} --scene {} "
            "--out force.csv\n",
            written.force_factor, scene.name());
    for (const FoamGauge& gauge : written.gauges)
        text += fmt::format(
            "    wetdeck import openfoam postProcessing/{} --column {}_0 ... --scene {} --out {}.csv\n",
            gauge.object, gauge.kind == FoamGauge::Kind::pressure ? "p" : "alpha.water", scene.name(),
            gauge.series);
    return text;
}

}  // namespace wetdeck

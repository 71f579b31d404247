// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/scene_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include "solver/core/errors.hpp"
#include "validation/metrics/metric.hpp"
#include "validation/metrics/reference_kind.hpp"
#include "validation/metrics/statements.hpp"
#include "validation/scene/expressions.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/motion_keys.hpp"
#include "validation/scene/probe.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {
namespace {

/// Keys by section: `# title`, then one key a line: key | unit | default | expected | meaning | how to
/// choose. A line that begins with blanks goes on with the last one.
constexpr const char* set_up_keys = R"(# The scene
schema | | required | 1 | version of the form of the file |
name | | required | lower-case letters, digits, _ and - | names the folders of results and of reference curves |
title | | required | text | heading of the report |
purpose | | required | text | what the scene tests, for the report |
source | | required | text | where the scene comes from, for the report |
limits | | [] | list of texts | what the scene cannot show, for the report |
default_variant | | required | one of the variants | the variant that is run where none is asked for |
scheme | | none | a scheme, see `[schemes.NAME]` | ingredients of the model by name; keys of [model] come on top |
source_scheme | | none | a shipped scheme | the scheme of the source: the report lists what differs from it |
gravity | m/s^2 | required | [x, y] | acceleration of gravity | [0.0, -9.81]; a larger one than the Earth's is doubted
variants.NAME | | required | table | a variant: any keys of the file in dotted form that differ, besides those below |
variants.NAME.description | | | text | what the variant is, for the report |
variants.NAME.scheme | | none | a scheme | ingredients of the variant's model by name |
variants.NAME.expect | | stable | stable or unstable | unstable: a suite has done its work when the run becomes unstable |
schemes.NAME | | | table | a scheme of the scene's own: keys of [model] and [air] |
parameters.NAME | SI, rad | | number, "30 deg", or an expression | a number that expressions use: any number of the scene may be a text that
  begins with "=", as in "= 12*speed", and a text may hold "{= speed}" | what `wetdeck sweep --over` varies
tiers.TIER.VARIANT | m | | list of spacings | the spacings that `wetdeck suite --tier TIER` runs |
  three or more, four for a least-squares estimate, each at least 1.25 times the next finer one; they must divide the sides of
  all boxes. The finest feature (gauge, film, edge) wants five spacings, a body a hundred over its beam
accepted_doubts.sound_speed | | | text | why a doubt about the sound speed is accepted |
accepted_doubts.echo | | | text | why sound that is back from the walls before the end is accepted |
# Tank, water and air
tank.size | m | required | [width, height] | inner size of the closed tank |
  sound must not be back from walls and floor before the record of a slam ends: half of (sound speed x record) from the body,
  and at least two beams; doubted where it is
water.boxes | m | required | list of [x_low, y_low, x_high, y_high] | where water is at the start | whole multiples of every spacing
air.boxes | m | required in [air] | list of [x_low, y_low, x_high, y_high] | where air is at the start |
  half a beam above the body; all that water leaves free where air can be trapped
air.law | | required in [air] | equal-coefficient, physical or sound-speed | how the sound speed of the air follows |
  physical (377 m/s) wherever air is trapped or squeezed; equal-coefficient is that of Yang et al. (2020), too soft for it
# The start
initial.pressure | | required | hydrostatic or greco | pressure at the start: that of the water above each particle,
  or that of one column just after its gate is gone, which stands free at `initial.released_face` |
initial.surface | m | highest top of the water | number | height of the highest surface. A wet bed, and columns of different heights,
  start at rest. A surface that is the top of no water is a doubt |
initial.released_face | m | required by greco | the free end of one column | where the gate was |
initial.arrangement | | 0 | whole number up to 1e9 | 0: the lattice; any other: the particles lie elsewhere, each by at most a tenth of a
  spacing, as this seed draws it, and the fluid has settled with the bodies held at rest | for replicates: runs that differ by this key
  alone differ by chance alone
# Bodies
body.outline | m | required | list of [x, y], "FILE.csv" or "FILE#station=S&part=N" | corners of the body in a frame of its own; `[body_2]`, `[body_3]`, ... are
  further bodies with the same keys. Of a GHS file (.gf), a drawing (.dxf, `#layer=NAME`) or a table of offsets one section is asked for, in docs/sections.md | a corner every few spacings; parts thinner than two spacings are refused
body.mirrored | | false | true or false | the outline is the half from the keel to the deck |
body.position | m | required | [x, y] | where the origin of the outline lies in the tank | two spacings of the coarsest run above the water
body.free | | [] | list of x, y, rotation | motions that the fluid can change; the others keep their velocity |
body.mass | kg/m | required where free in x or y | positive number | mass per metre of span | mass of the section over its length along the hull
body.mass_centre | m | centroid | [x, y] within the bounding box of the outline | in the frame of the outline |
body.inertia | kg m | that of even density | positive number | about the mass centre, per metre of span |
  one beyond ten times or below a tenth of that of even density is a doubt
body.velocity_x | m/s | 0 | number | velocity at the start |
body.velocity_y | m/s | 0 | number | velocity at the start, up positive |
  from a fall of height d to the water: the speed at the water is sqrt(v^2 + 2 g d)
body.angular_velocity | rad/s | 0 | number | at the start, counter-clockwise |
body.applied_force | N/m | [0, 0] | [x, y] | a constant force besides gravity and the fluid's |
body.applied_torque | N | 0 | number | a constant torque about the mass centre |
contact | | none | table | bodies push the tank and each other. Without this table a body that touches the tank or another body
  ends the run with exit code 3, and a body that starts in touch is refused | a gap of less than half a spacing keeps all fluid out,
  one of less than a tenth changes no force by more than some percent
# The record
run.end_time | s | required | positive number | simulated time | contact time and record
run.sample_interval | s | required | positive number | between two values of every series |
  a two-hundredth of the record or less; fewer than fifty samples are a doubt
run.force_filter | s | 0 | zero or a positive width | moving mean of the series that end in _filtered |
  a few sample intervals, well below the rise time of the peak
run.frames | s | [] | list of times | field files and pictures of the report |
run.frame_interval | s | none | positive number | further field files at even intervals |
probes[].name | | required | text | name of the series |
probes[].type | | required | one of the types below | what is recorded |
probes[].note | | | text | for the report |
probes[].centre | m | required | [x, y] | centre of a pressure gauge, on a face; of a body in the frame of its outline |
probes[].diameter | m | required | positive number | of the gauge's disc, over which the pressure is averaged |
  that of the sensor; at least two spacings of the coarsest run, else the value rests on a handful of particles
probes[].body | | body | name of a body, or tank | what the gauge or face belongs to |
probes[].from | m | required | [x, y] | first end of a face |
probes[].to | m | required | [x, y] | last end of a face |
probes[].points | - | required | 2 to 10000 | number of values along a face or surface | one a spacing or fewer
probes[].x | m | required | number in the tank | where the depth is taken |
probes[].width | m | required | positive number | over which the depth is averaged |
probes[].low | m | required | number in the tank | begin of the free surface |
probes[].high | m | required | number in the tank | end of the free surface |
probes[].length | m | required | one share of the points to the whole line | size of the patch along the face of patch_pressure |
probes[].direction | | right | right, left, up or down | of the front |
probes[].x_range | m | the tank | [low, high] | where the front is looked for |
probes[].y_range | m | the tank | [low, high] | where the front is looked for |
)";

constexpr const char* analysis_keys = R"(# Scales and instants
scales.NAME | | | number in SI units, or "0.6 m" | what an axis is divided by |
time_origins.NAME | s | | number, "10.2 ms", geometric_contact, first_contact, or { series, crosses, direction } | an instant from which time counts |
  geometric_contact or first_contact: the run finds them; a number by hand is doubted where the run finds another
time_origins.NAME.series | | required | a series of one value | whose crossing is the instant |
time_origins.NAME.crosses | | required | number | level that is crossed |
time_origins.NAME.direction | | both | rising or falling | of the crossing |
# Quantities
quantities[].name | | required | text | name in tables and in summary.json |
quantities[].metric | | required | METRICS | what is taken from the series |
quantities[].series | | required | a series of the scene | see `wetdeck describe SCENE` |
quantities[].variants | | all | list of variants | where the quantity is taken |
quantities[].x_scale | | 1 | a name of [scales] | divides the time or place |
quantities[].y_scale | | 1 | a name of [scales] | divides the value |
quantities[].x_origin | | start of the run | a name of [time_origins], or a contact | where time counts from |
quantities[].instant | | required of profiles | number, or [begin, end] | when a profile is taken, or over what interval it is averaged |
quantities[].window | | the whole run | [begin, end] on the scaled axis | what is looked at |
quantities[].threshold | | | number on the scaled axis | of metrics that need one |
quantities[].reference | | | name of a curve | of metrics that compare with one |
quantities[].y_column | | | column of the curve | of the reference |
quantities[].unit | | follows from the scales | text | unit of the quantity; checked |
quantities[].expected | | | number | value of an experiment, an exact solution or another code |
quantities[].tolerance | | required beside expected | positive number | how far from it a run may be |
quantities[].expected_source | | | text | who states it |
quantities[].expected_kind | | | KINDS | kind of the expected value |
quantities[].expected_uncertainty | of the quantity | unknown | zero or a positive number | standard uncertainty (k = 1) that the source states |
quantities[].assumed_uncertainty | - | | number | the same by judgement; the report marks it |
quantities[].assumed_reason | | required beside it | text | why |
quantities[].required | - | | positive number | relative accuracy that you need: the report says whether it is reached |
quantities[].lines.NAME | of the quantity | | number | the value of another method, drawn beside that of a sweep |
quantities[].curve.title | | | text | a curve of a sweep that several quantities make up, as pressure over the size of a patch |
quantities[].curve.label | | required | text with the unit | of its abscissa |
quantities[].curve.x | | required | number | where this quantity lies on it |
error_quantity | | none | name of a quantity | the error that the report draws against cost |
# Comparisons with curves
compare[].title | | required | text | heading of the figure |
compare[].quantity | | required | a series of the scene | what is compared |
compare[].variants | | all | list of variants | where it is compared |
compare[].reference | | required | name of a file without .csv, or an exact solution | beside the scene file or in reference_data/SCENE |
compare[].references | | | list of names | several curves with the same columns, instead of `reference` |
compare[].shown | | [] | list of names | further curves that are drawn and not judged |
compare[].x_column | | required | column of the curve | time or place |
compare[].y_column | | required | column of the curve | value |
compare[].x_scale | | 1 | a name of [scales] | divides the time or place of the series |
compare[].y_scale | | 1 | a name of [scales] | divides the values of the series |
compare[].x_origin | | start of the run | a name of [time_origins], or a contact | where time counts from |
compare[].y_offset | | 0 | number, scaled | added to the series |
compare[].align | | none | peak | puts the origin at the largest value of both |
compare[].instant | | required of profiles | number, or [begin, end] | when a profile is taken |
compare[].window | | the common part | [begin, end] on the scaled axis | what is judged |
compare[].tolerance | - | required | positive number | on the rms difference over the range of the reference |
compare[].required | - | | positive number | relative accuracy that you need |
compare[].x_label | | the column | text | of the figure |
compare[].y_label | | the column | text | of the figure |
# Studies of inputs, sound speed and chance
sensitivity[].key | | required | dotted key of a number | the input that is varied |
sensitivity[].low | | required | number | lower value, in the unit of the key |
sensitivity[].high | | required | number | higher value | some standard uncertainties apart, so that the difference exceeds the scatter
sensitivity[].uncertainty | | required | positive number | standard uncertainty of the input |
sensitivity[].source | | this or reason | text | who states it |
sensitivity[].reason | | this or source | text | why it is assumed; the report marks it |
sensitivity[].low_with | | [] | list of KEY=VALUE | set besides at the lower value |
sensitivity[].high_with | | [] | list of KEY=VALUE | set besides at the higher value |
sound_speed_study.variants | | required | list of variants | run at half and twice their sound speed |
sound_speed_study.twice_with | | [] | list of KEY=VALUE | set besides at twice, such as a larger tank |
replicates.variants | | required | list of variants | run with other arrangements of the particles |
replicates.count | - | 20 | 2 to 1000 | number of arrangements | 20 give the standard deviation to a sixth
# The source
source_run.particles | - | required | positive number | of the source's own computation, for its cost beside ours |
source_run.time_step | s | required | positive number | of that computation |
source_run.duration | s | required | positive number | simulated time of that computation |
source_run.conditions | | required | text | what else to know of it |
deviations[].item | | required | text | in what the scene differs from its source |
deviations[].source | | required | text | what the source has |
deviations[].used | | required | text | what the scene has |
deviations[].reason | | required | text | why |
source_statements[].says | | required | text | a statement of the source that the runs test |
source_statements[].variants | | required | list of variants | whose values it is about |
source_statements[].against | | required, or against_quantity | list of variants | with which they are compared |
source_statements[].measure | | required | MEASURES | how they are compared |
source_statements[].quantity | | required | a quantity | of difference and ratio |
source_statements[].against_quantity | | the same | a quantity | with which it is compared |
source_statements[].series | | required | a series | of curve_difference |
source_statements[].window | | the whole run | [begin, end] | of the curves |
source_statements[].at_least | | no limit | number | the statement holds from here |
source_statements[].at_most | | no limit | number | to here |
side_by_side[].title | | required | text | heading of pictures of variants beside each other |
side_by_side[].variants | | required | list of at least two variants | which |
side_by_side[].time | s | this or series | number | of the pictures |
side_by_side[].series | | this or time | a series | drawn for all of them |
source_figures[].number | | required | text | figure of the source |
source_figures[].shows | | required | text | what it shows |
source_figures[].places | | required, or remark | list of anchors of the report | where its counterpart is |
source_figures[].remark | | | text | why there is none |
source_figures[].source | | that of the scene | text | another source |
source_figures[].curves | | [] | list of references | drawn in its counterpart |
unused_references[].file | | required | name of a curve | one that lies at hand and is not used |
unused_references[].reason | | required | text | why |
)";

/// The names that a placeholder in the tables stands for.
std::string with_names(std::string range) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> lists = {
        {"METRICS", metric_names()},
        {"KINDS", reference_kind_names()},
        {"MEASURES", statement_measure_names()}};
    for (const auto& [placeholder, names] : lists)
        if (range == placeholder) return fmt::format("one of {}", fmt::join(names, ", "));
    return range;
}

SceneKey key_of(const std::string& row) {
    std::array<std::string, 6> cells;
    std::size_t begin = 0;
    for (std::string& cell : cells) {
        const std::size_t end = std::min(row.find('|', begin), row.size());
        cell = trimmed(std::string_view(row).substr(begin, end - begin));
        begin = std::min(end + 1, row.size());
    }
    return {cells[0], cells[1], cells[2], with_names(cells[3]), cells[4], cells[5], ""};
}

std::vector<SceneKeySection> sections_of(const std::string& table) {
    std::vector<SceneKeySection> sections;
    std::string row;
    const auto finish_row = [&] {
        if (!row.empty()) sections.back().keys.push_back(key_of(row));
        row.clear();
    };
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  ")) {
            row.append(1, ' ').append(trimmed(line));
            continue;
        }
        finish_row();
        if (line.starts_with("# "))
            sections.push_back({line.substr(2), {}});
        else
            row = line;
    }
    finish_row();
    return sections;
}

/// How to choose the keys of the model that take a rule.
std::string choice_of(const std::string& key) {
    static const std::map<std::string, std::string> rules = {
        {"water.sound_speed",
         "the largest of: 10 times the fastest water; 12 times the speed of the contact line, pi V/(2 tan "
         "beta), "
         "for a bottom of deadrise beta; 100 V for a flat one; at most that of real water. The report doubts "
         "a "
         "density change above 1 %"},
        {"model.background_pressure",
         "0 without air. With air 5 % of rho V^2/2, from 100 to 1500 Pa: enough to keep water from tearing, "
         "and "
         "a few per cent of a slam (docs/decisions.md)"},
        {"model.smoothing_ratio", "1.5; smaller is faster and noisier"},
        {"model.sponge_thickness", "a beam or more, where the tank cannot be large enough for the sound"},
        {"execution.skin", "leave it: a run chooses the cheapest; results differ by rounding"},
        {"execution.precision", "double for comparisons to the last digit; results differ by rounding"}};
    const auto found = rules.find(key);
    return found == rules.end() ? "" : found->second;
}

/// The value of a key where a scene does not give it; nothing for a key that every scene gives.
std::string default_of(const ModelKey& row) {
    if (row.key == "viscosity" && row.table != "model") return "0";
    if (row.dotted() == "air.sound_speed") return "as the law gives it";
    if (row.table == "water" || row.table == "air") return "required";
    return row.default_note.empty() ? toml_text(row.get(Scene{})) : row.default_note;
}

SceneKeySection model_section() {
    SceneKeySection section{"Fluids, model and execution", {}};
    for (const ModelKey& row : model_keys())
        section.keys.push_back({row.dotted(), row.unit, default_of(row), row.expected(), row.meaning,
                                choice_of(row.dotted()), row.equation});
    return section;
}

}  // namespace

std::vector<SceneKeySection> scene_keys() {
    std::vector<SceneKeySection> all = sections_of(set_up_keys);
    const auto bodies = std::find_if(
        all.begin(), all.end(), [](const SceneKeySection& section) { return section.title == "Bodies"; });
    const std::vector<SceneKeySection> motions = sections_of(motion_keys);
    all.insert(bodies + 1, motions.begin(), motions.end());
    all.insert(all.begin() + 2, model_section());
    for (SceneKeySection& section : sections_of(analysis_keys)) all.push_back(std::move(section));
    return all;
}

std::string scene_keys_markdown() {
    std::string out;
    for (const SceneKeySection& section : scene_keys()) {
        out += fmt::format(
            "\n## {}\n| key | unit | default | expected | meaning | how to choose |\n"
            "|---|---|---|---|---|---|\n",
            section.title);
        for (const SceneKey& key : section.keys)
            out += fmt::format("| `{}` | {} | {} | {} | {}{} | {} |\n", key.key, key.unit, key.fallback,
                               key.range, key.meaning,
                               key.equation.empty() ? "" : fmt::format(" ({})", key.equation), key.choice);
    }
    out +=
        "\n## Functions of expressions\nAngles are in rad; `pi` is known, and `a ? b : c` chooses.\n\n"
        "| function | arguments | value |\n|---|---|---|\n";
    for (const ExpressionFunction& function : expression_functions())
        out += fmt::format("| `{}` | {} | {} |\n", function.name, function.arguments, function.meaning);
    out += "\n## Types of probes\n| type | unit | records | keys |\n|---|---|---|---|\n";
    for (const ProbeType& type : probe_types()) {
        std::vector<const char*> keys = type.keys;
        keys.insert(keys.end(), type.optional_keys.begin(), type.optional_keys.end());
        out += fmt::format("| `{}` | {} | {} | {} |\n", type.name, type.unit, type.records,
                           fmt::join(keys, ", "));
    }
    return out;
}

}  // namespace wetdeck

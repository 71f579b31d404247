// SPDX-License-Identifier: BSD-3-Clause
// Every way a scene file can be wrong, and what the user is told.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/unit/scene/scene_samples.hpp"

using namespace wetdeck;
using Catch::Contains;
using Catch::EndsWith;
using samples::refusal;
using samples::small_scene;
using samples::with;
using samples::with_line;
using samples::without;

namespace {

int line_of(const std::string& text, const std::string& piece) {
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<long>(text.find(piece)), '\n'));
}

/// "small.toml:LINE: key 'KEY': " for the line that holds `piece`.
std::string place(const std::string& text, const std::string& piece, const std::string& key) {
    return "small.toml:" + std::to_string(line_of(text, piece)) + ": key '" + key + "': ";
}

/// Replaces a piece of the small scene, and says where the fault is and what was expected.
void expect(const std::string& piece, const std::string& replacement, const std::string& key,
            const std::string& message) {
    const std::string text = with(piece, replacement);
    INFO(piece << " -> " << replacement);
    REQUIRE(refusal(text) == place(text, replacement, key) + message);
}

}  // namespace

TEST_CASE("the small scene itself is taken in every variant") {
    REQUIRE(refusal(small_scene) == "");
    REQUIRE(refusal(small_scene, "single-phase") == "");
}

TEST_CASE("an unknown key is named with file, line and the keys that would do") {
    const std::string text = with_line("[run]", "end_tim = 1.0");
    REQUIRE(refusal(text) ==
            place(text, "end_tim ", "run.end_tim") +
                "unknown, expected one of end_time, force_filter, frame_interval, frames, sample_interval");
}

TEST_CASE("an unknown key is found in every section") {
    for (const std::string section : {"[tank]", "[water]", "[air]", "[initial]", "[model]", "[run]"}) {
        const std::string text = with_line(section, "colour = 1");
        const std::string key = section.substr(1, section.size() - 2) + ".colour";
        REQUIRE_THAT(refusal(text),
                     Catch::StartsWith(place(text, "colour", key) + "unknown, expected one of "));
    }
    for (const std::string section : {"probes", "quantities", "compare", "deviations"}) {
        const std::string text = with_line("[[" + section + "]]", "colour = 1");
        REQUIRE_THAT(refusal(text),
                     Catch::StartsWith(place(text, "colour", section + "[0].colour") + "unknown"));
    }
    const std::string text = "colour = 1\n" + small_scene;
    REQUIRE_THAT(
        refusal(text),
        Catch::StartsWith("small.toml:1: key 'colour': unknown, expected one of accepted_doubts, air, "));
}

TEST_CASE("an unknown section is refused") {
    REQUIRE_THAT(refusal(small_scene + "[boat]\nmass = 1\n"), Contains("key 'boat': unknown"));
}

TEST_CASE("an unknown ingredient of the model is refused with the list of known ones") {
    const std::string text = with_line("[model]", "velocity_mean = \"geometric\"");
    REQUIRE(refusal(text) ==
            place(text, "velocity_mean", "model.velocity_mean") +
                "is 'geometric', expected one of arithmetic, density-weighted, impedance-weighted, harmonic");
    for (const char* key : {"pressure_mean", "dissipation", "viscosity", "wall_pressure", "wall_slip"}) {
        REQUIRE_THAT(refusal(with_line("[model]", std::string(key) + " = \"odd\"")),
                     Contains("is 'odd', expected one of "));
    }
    expect("law = \"sound-speed\"", "law = \"hooke\"", "air.law",
           "is 'hooke', expected one of equal-coefficient, physical, sound-speed");
    expect("pressure = \"hydrostatic\"", "pressure = \"zero\"", "initial.pressure",
           "is 'zero', expected one of hydrostatic, greco");
    expect("type = \"front\"", "type = \"back\"", "probes[0].type",
           "is 'back', expected one of front, wall_pressure, water_depth, body_pressure, face_pressure, "
           "patch_pressure, "
           "air_film, free_surface");
    REQUIRE_THAT(refusal(with("metric = \"mean\"", "metric = \"mode\"")),
                 Contains("is 'mode', expected one of mean, "));
    expect("x_scale = \"time\"", "x_origin = \"contact\"", "quantities[0].x_origin",
           "is 'contact', and the file defines no such name");
    expect("x_scale = \"time\"", "x_scale = \"tempo\"", "quantities[0].x_scale",
           "is 'tempo', expected one of length, time");
}

TEST_CASE("a missing key is named, with what was expected") {
    REQUIRE_THAT(refusal(without("schema = 1\n")), EndsWith("key 'schema': missing, expected a number"));
    REQUIRE_THAT(refusal(without("title = \"A small column\"\n")),
                 EndsWith("key 'title': missing, expected a text"));
    REQUIRE_THAT(refusal(without("gravity = [0.0, -9.81]\n")),
                 EndsWith("key 'gravity': missing, expected a list of 2 numbers"));
    REQUIRE_THAT(refusal(without("sound_speed = 14.0\n")),
                 EndsWith("key 'water.sound_speed': missing, expected a number"));
    REQUIRE_THAT(refusal(without("end_time = 0.2\n")),
                 EndsWith("key 'run.end_time': missing, expected a number"));
    REQUIRE_THAT(refusal(without("[tank]\nsize = [1.0, 0.48]\n")),
                 EndsWith("key 'tank': missing, expected a table"));
    REQUIRE_THAT(refusal(without("diameter = 0.08\n")),
                 EndsWith("key 'probes[1].diameter': missing, expected a number"));
    REQUIRE_THAT(refusal(without("boxes = [[0.0, 0.0, 0.4, 0.2]]\n")),
                 EndsWith("key 'water.boxes': missing, expected a list of lists of 4 numbers"));
    REQUIRE_THAT(refusal(without("tolerance = 0.1\n")),
                 EndsWith("key 'compare[0].tolerance': missing, expected a number"));
}

TEST_CASE("a slip of the pen is named in place of the key that it leaves missing") {
    const auto slip = [](const std::string& key, const std::string& written) {
        std::string text = small_scene;
        return refusal(text.replace(text.find(key), key.size(), written));
    };
    for (const char* written : {"end_tim", "end_timee", "end_tiem"}) {
        REQUIRE_THAT(slip("end_time", written),
                     EndsWith(std::string("key 'run.") + written +
                              "': unknown; 'end_time' is missing, expected a number"));
    }
    REQUIRE_THAT(slip("end_time", "stop_time"), EndsWith("key 'run.end_time': missing, expected a number"));
}

TEST_CASE("a missing key of a section is placed at the section") {
    const std::string text = without("end_time = 0.2\n");
    REQUIRE_THAT(refusal(text), Catch::StartsWith(place(text, "[run]", "run.end_time")));
}

TEST_CASE("air that is wanted but not described is refused") {
    std::string text = small_scene;
    const std::size_t begin = text.find("[air]"), end = text.find("[initial]");
    text.erase(begin, end - begin);
    REQUIRE_THAT(refusal(text), Contains("key 'air': missing: model.air = true needs a table [air]"));
}

TEST_CASE("a value of the wrong type is refused") {
    expect("end_time = 0.2", "end_time = \"soon\"", "run.end_time", "expected a finite number");
    expect("air = true", "air = 1", "model.air", "expected true or false");
    expect("title = \"A small column\"", "title = 5", "title", "expected a text in quotes");
    expect("gravity = [0.0, -9.81]", "gravity = -9.81", "gravity", "expected a list of 2 numbers");
    expect("gravity = [0.0, -9.81]", "gravity = [0.0, \"down\"]", "gravity", "expected a list of 2 numbers");
    expect("gravity = [0.0, -9.81]", "gravity = [0.0]", "gravity", "expected a list of 2 numbers");
    expect("limits = [\"two-dimensional\"]", "limits = [2]", "limits", "expected a list of texts");
    expect("boxes = [[0.0, 0.0, 0.4, 0.2]]", "boxes = [0.0, 0.0, 0.4, 0.2]", "water.boxes",
           "expected a list of lists of 4 numbers");
    REQUIRE_THAT(refusal(with("[tank]\nsize = [1.0, 0.48]", "[[tank]]\nsize = [1.0, 0.48]")),
                 EndsWith("key 'tank': expected a table"));
    REQUIRE_THAT(refusal(small_scene, std::nullopt, {"probes=3"}),
                 EndsWith("key 'probes': expected an array of tables"));
    REQUIRE_THAT(refusal(small_scene, std::nullopt, {"model=3"}), EndsWith("key 'model': expected a table"));
}

TEST_CASE("numbers that are not finite are refused wherever they stand") {
    for (const std::string bad : {"nan", "inf", "-inf"}) {
        expect("end_time = 0.2", "end_time = " + bad, "run.end_time", "expected a finite number");
        expect("density = 1000.0", "density = " + bad, "water.density", "expected a finite number");
        expect("gravity = [0.0, -9.81]", "gravity = [" + bad + ", 0.0]", "gravity",
               "expected a list of 2 numbers");
        expect("frames = [0.05, 0.1]", "frames = [" + bad + "]", "run.frames", "expected a list of numbers");
        expect("[[0.0, 0.0, 0.4, 0.2]]", "[[0.0, 0.0, 0.4, " + bad + "]]", "water.boxes",
               "expected a list of lists of 4 numbers");
    }
}

TEST_CASE("numbers outside their range are refused with the value") {
    expect("density = 1000.0", "density = -3.0", "water.density", "is -3, expected a positive number");
    expect("sound_speed = 14.0", "sound_speed = 0.0", "water.sound_speed",
           "is 0, expected a positive number");
    expect("end_time = 0.2", "end_time = 0.0", "run.end_time", "is 0, expected a positive number");
    expect("background_pressure = 500.0", "background_pressure = -5.0", "model.background_pressure",
           "is -5, expected zero or a positive number");
    expect("diameter = 0.08", "diameter = -0.08", "probes[1].diameter",
           "is -0.08, expected a positive number");
    expect("size = [1.0, 0.48]", "size = [1.0, -0.48]", "tank.size", "expected two positive lengths");
    expect("schema = 1", "schema = 2", "schema", "expected 1");
    expect("sound_speed = 70.0", "sound_speed = -70.0", "air.sound_speed",
           "the law 'sound-speed' needs a positive number [m/s]");
    expect("two-phase = [0.02]", "two-phase = [-0.02]", "tiers.standard.two-phase",
           "expected positive spacings");
    const auto model = [](const std::string& line) { return refusal(with_line("[model]", line)); };
    REQUIRE_THAT(model("smoothing_ratio = 5.0"),
                 EndsWith("key 'model.smoothing_ratio': is 5, expected 1 to 3"));
    REQUIRE_THAT(model("courant_number = 0.0"),
                 EndsWith("key 'model.courant_number': is 0, expected above 0 and at most 2"));
    REQUIRE_THAT(model("air_substeps = 2"),
                 EndsWith("key 'model.air_substeps': is 2, expected an odd number up to 99, or 0"));
    REQUIRE_THAT(model("air_substeps = 3\ndissipation_switch = true"),
                 EndsWith("key 'model.air_substeps': is 3, expected 1 with the dissipation switch"));
    REQUIRE_THAT(model("coarse_substeps = 4"),
                 EndsWith("key 'model.coarse_substeps': is 4, expected an odd number up to 99, or 0"));
    REQUIRE_THAT(model("coarse_substeps = 5\ndissipation_switch = true"),
                 EndsWith("key 'model.coarse_substeps': is 5, expected 1 with the dissipation switch"));
    REQUIRE_THAT(model("skin = 2.0"), EndsWith("key 'execution.skin': is 2, expected 0 to 1"));
    REQUIRE_THAT(refusal(with_line("[water]", "viscosity = -1.0")),
                 EndsWith("key 'water.viscosity': expected zero or a positive number"));
    REQUIRE_THAT(refusal(with_line("[run]", "frame_interval = 0.0")),
                 EndsWith("key 'run.frame_interval': expected a positive number"));
    REQUIRE_THAT(refusal(with_line("[run]", "frame_interval = 1e-9")),
                 EndsWith("key 'run.frame_interval': would write more than 100,000 frames"));
}

TEST_CASE("a precision that does not exist, or that a scheme does not have, is refused") {
    const auto precision = [](const std::string& value, const std::string& choice = "") {
        return refusal(with_line("[model]", choice) + "\n[execution]\nprecision = " + value + "\n");
    };
    REQUIRE_THAT(precision("\"single\""),
                 EndsWith("key 'execution.precision': is 'single', expected one of double, mixed"));
    for (const char* value : {"32", "true", "[\"mixed\"]", "\"Mixed\"", "\"\"", "\"float\"", "0.5"}) {
        INFO(value);
        REQUIRE_THAT(precision(value), Contains("key 'execution.precision'") && Contains("expected"));
    }
    for (const char* choice : {"velocity_mean = \"harmonic\"", "pressure_mean = \"harmonic\"",
                               "impedance_mean = \"harmonic\"", "dissipation_switch = true"}) {
        INFO(choice);
        REQUIRE_THAT(
            precision("\"mixed\"", choice),
            EndsWith(std::string("key 'execution.precision': is 'mixed', expected 'double' with ") + choice));
    }
}

TEST_CASE("a harmonic mean of pressures without background pressure is refused for two phases") {
    REQUIRE_THAT(
        refusal(with("background_pressure = 500.0", "pressure_mean = \"harmonic\"")),
        EndsWith("the harmonic mean needs a positive background_pressure: it is singular at p <= 0"));
}

TEST_CASE("boxes outside the tank, inside out or over each other are refused") {
    const std::string box = "[[0.0, 0.0, 0.4, 0.2]]";
    expect(box, "[[0.0, 0.0, 1.4, 0.2]]", "water.boxes", "a box reaches outside the tank");
    expect(box, "[[-0.1, 0.0, 0.4, 0.2]]", "water.boxes", "a box reaches outside the tank");
    expect(box, "[[0.4, 0.0, 0.0, 0.2]]", "water.boxes",
           "expected x_low, y_low, x_high, y_high with low below high");
    expect(box, "[[0.0, 0.2, 0.4, 0.2]]", "water.boxes",
           "expected x_low, y_low, x_high, y_high with low below high");
    expect(box, "[[0.0, 0.0, 0.4, 0.2], [0.36, 0.0, 0.48, 0.2]]", "water.boxes", "two boxes overlap");
}

TEST_CASE("boxes that share an edge do not overlap") {
    REQUIRE(refusal(with("[[0.0, 0.0, 0.4, 0.2]]", "[[0.0, 0.0, 0.2, 0.2], [0.2, 0.0, 0.4, 0.2]]")) == "");
}

TEST_CASE("water and air in the same place are refused") {
    REQUIRE_THAT(refusal(with("[[0.0, 0.0, 0.4, 0.2]]", "[[0.0, 0.0, 0.44, 0.2]]")), Contains("overlap"));
}

TEST_CASE("a window that ends before it begins is refused") {
    expect("window = [0.2, 0.8]", "window = [0.8, 0.2]", "quantities[0].window",
           "expected a begin below its end");
    expect("window = [0.0, 1.0]", "window = [0.5, 0.5]", "compare[0].window",
           "expected a begin below its end");
}

TEST_CASE("metrics without what they need are refused") {
    const auto metric = [](const std::string& name, const std::string& more = "") {
        return refusal(with("metric = \"mean\"", "metric = \"" + name + "\"\n" + more));
    };
    REQUIRE_THAT(metric("first_crossing"),
                 EndsWith("key 'quantities[0].threshold': missing, the metric first_crossing needs it"));
    REQUIRE_THAT(metric("value_at"),
                 EndsWith("key 'quantities[0].threshold': missing, the metric value_at needs it"));
    REQUIRE_THAT(metric("rms_difference"),
                 EndsWith("key 'quantities[0].reference': missing, the metric rms_difference needs it"));
    REQUIRE_THAT(metric("rms_difference", "reference = \"nobody_front\""),
                 EndsWith("key 'quantities[0].y_column': missing, the metric rms_difference needs it"));
    REQUIRE_THAT(metric("mean", "expected = 1.0"),
                 EndsWith("key 'quantities[0].tolerance': missing beside 'expected'"));
}

TEST_CASE("names that stand for two things are refused") {
    const std::string again = "[[probes]]\nname = \"front\"\ntype = \"front\"\n";
    REQUIRE_THAT(refusal(small_scene + again), EndsWith("key 'probes[3].name': is used twice"));
    const std::string quantity =
        "[[quantities]]\nname = \"front_mean\"\nmetric = \"mean\"\nseries = \"front\"\n";
    REQUIRE_THAT(refusal(small_scene + quantity),
                 EndsWith("key 'quantities[1].name': is used twice for one variant"));
}

TEST_CASE("an error quantity that is none of the quantities is refused") {
    expect("error_quantity = \"front_mean\"", "error_quantity = \"rear_mean\"", "error_quantity",
           "'rear_mean' is not among [[quantities]]");
}

TEST_CASE("a quantity or comparison of a series that no run records is refused") {
    REQUIRE_THAT(refusal(with("series = \"front\"", "series = \"frnt\"")), Contains("frnt"));
    REQUIRE_THAT(refusal(with("quantity = \"front\"", "quantity = \"frnt\"")), Contains("frnt"));
}

TEST_CASE("an unknown variant is refused with the list of known ones") {
    REQUIRE(refusal(small_scene, "three-phase") ==
            "small.toml: no variant 'three-phase', expected one of two-phase, single-phase");
    expect("default_variant = \"two-phase\"", "default_variant = \"none\"", "default_variant",
           "is 'none', expected one of two-phase, single-phase");
}

TEST_CASE("a tier of a variant that the scene does not have is refused") {
    expect("two-phase = [0.02]", "both = [0.02]", "tiers.standard.both", "is not a variant of this scene");
}

TEST_CASE("an analytic curve that does not exist is refused when the scene is read") {
    REQUIRE_THAT(refusal(with("nobody_front", "analytic:nothing")),
                 Contains("'analytic:nothing': no analytic curve 'nothing', there are wedge_pressure"));
    REQUIRE(refusal(with("nobody_front", "analytic:wedge_pressure deadrise=30")) == "");
}

TEST_CASE("an expected value of an unknown kind or a negative uncertainty is refused") {
    const auto expected = [](const std::string& line) {
        return refusal(
            with("metric = \"mean\"", "metric = \"mean\"\nexpected = 1.0\ntolerance = 0.1\n" + line));
    };
    REQUIRE_THAT(expected("expected_kind = \"rumour\""),
                 EndsWith("is 'rumour', expected one of experiment, peer-simulation, analytic, stated"));
    REQUIRE_THAT(expected("expected_uncertainty = -0.1"),
                 EndsWith("key 'quantities[0].expected_uncertainty': expected zero or a positive number"));
    REQUIRE(expected("expected_kind = \"experiment\"\nexpected_uncertainty = 0.0").empty());
}

TEST_CASE("a sensitivity that varies nothing, by nothing, or on nobody's word is refused") {
    const auto sensitivity = [](const std::string& range) {
        return refusal(small_scene + "[[sensitivity]]\nkey = \"initial.surface\"\n" + range);
    };
    REQUIRE(sensitivity("low = 0.1\nhigh = 0.3\nuncertainty = 0.02\nsource = \"tape\"\n").empty());
    REQUIRE_THAT(sensitivity("low = 0.3\nhigh = 0.3\nuncertainty = 0.02\nsource = \"tape\"\n"),
                 EndsWith("key 'sensitivity[0].low': expected a number below 'high'"));
    REQUIRE_THAT(sensitivity("low = 0.1\nhigh = 0.3\nuncertainty = 0.0\nsource = \"tape\"\n"),
                 Contains("sensitivity[0].uncertainty"));
    for (const char* words : {"", "source = \"tape\"\nreason = \"by judgement\"\n"})
        REQUIRE_THAT(
            sensitivity(std::string("low = 0.1\nhigh = 0.3\nuncertainty = 0.02\n") + words),
            EndsWith("key 'sensitivity[0].source': expected either who states the uncertainty, or a 'reason' "
                     "to assume it"));
    REQUIRE(sensitivity("low = 0.1\nhigh = 0.3\nuncertainty = 0.02\nreason = \"by judgement\"\n").empty());
}

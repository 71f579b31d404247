// SPDX-License-Identifier: BSD-3-Clause
// Slots of reference_data/README.md: a file in the promised format is compared with by the shipped scene.
// Each test writes such a file, made of the same function of time as the series of a made-up run.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "tests/unit/report/stored_samples.hpp"
#include "validation/metrics/analysis.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/metrics/resample.hpp"

using namespace wetdeck;
namespace fs = std::filesystem;

namespace {

const std::string header =
    "# kind: experiment\n# citation: made up\n# doi: none\n# figure: none\n# obtained: computed\n"
    "# obtained_from: a formula\n# date: 2020-01-01\n# digitisation_error: none\n# u_data: 0.01\n"
    "# u_data_source: made up\n# sensor: none\n# filter: none\n# sign: none\n# time_origin: none\n# note: "
    "none\n";

/// A file of the data folder, one row for each abscissa.
struct SlotFile {
    std::string scene, stem, columns;
    std::vector<double> abscissae;
    std::function<std::vector<double>(double)> row;  ///< the other columns

    void write(const fs::path& references) const {
        fs::create_directories(references / scene);
        std::ofstream file(references / scene / (stem + ".csv"));
        file.precision(15);
        file << header << columns << "\n";
        for (const double x : abscissae) {
            file << x;
            for (const double y : row(x)) file << ',' << y;
            file << '\n';
        }
    }
};

Scene shipped(const std::string& scene, const std::string& variant) {
    return read_scene(find_scene(scene), variant);
}

RunRecord empty_run(const Scene& scene) {
    RunRecord record;
    record.scene = scene.name();
    record.variant = scene.variant;
    record.particle_spacing = 0.01;
    return record;
}

Series sampled(const Scene& scene, const std::function<double(double)>& f, const std::string& unit) {
    Series series{unit, "made up", {}, {}, {}};
    const int last = static_cast<int>(std::lround(scene.end_time / scene.sample_interval));
    for (int i = 0; i <= last; ++i) {
        series.time.push_back(i * scene.sample_interval);
        series.value.push_back(f(series.time.back()));
    }
    return series;
}

/// The comparisons of the run with the file, in the order of the scene.
std::vector<ComparisonResult> comparisons_with(const std::string& stem, const Scene& scene,
                                               const RunRecord& record, const fs::path& references) {
    RunSummary run;
    run.record = record;
    std::vector<ComparisonResult> found;
    Summary summary = analyse({scene.analysis}, {run}, references);
    for (ComparisonResult& c : summary.runs.front().comparisons) {
        if (c.reference == stem) found.push_back(std::move(c));
    }
    return found;
}

/// When the body's lowest corner meets the water on the clock of the run: free fall of a rig that carries
/// part of the weight.
double contact_time(const Scene& scene) {
    const BodySpec& body = scene.bodies.front();
    double gap = 1e9;
    for (const Vec2& corner : body.outline) gap = std::min(gap, corner.y() - scene.initial.surface);
    const double speed = -body.body.velocity.y();
    const double fall = -scene.model.gravity.y() - body.body.applied_force.y() / body.body.mass;
    return (std::sqrt(speed * speed + 2 * fall * gap) - speed) / fall;
}

double at_once(const Scene&) {
    return 0;
}

/// A slot whose series is a straight line in time: the differences are exact.
struct LineSlot {
    const char* scene;
    const char* variant;
    const char* stem;
    const char* columns;
    const char* series;
    std::size_t column;  ///< among those behind the first
    double begin, end;   ///< abscissae of the file
    double time_unit, value_unit;
    double (*origin)(const Scene&) = at_once;  ///< of the file's clock on that of the run [s]

    std::size_t width() const {
        return static_cast<std::size_t>(std::count(columns, columns + std::string(columns).size(), ','));
    }
};

constexpr double second = 1;
const double dam_time = std::sqrt(0.6 / 9.81);
const char* path_columns = "t [s],x [m],y [m],angle [rad]";
const char* acceleration_columns = "t [s],acceleration [m/s^2]";
const char* pressure_columns = "t [s],p_P4 [Pa]";
const char* filtered = "body_acceleration_y_filtered";

const std::vector<LineSlot> line_slots = {
    {"dam_break", "two-phase", "buchner2002_front", "T [-],x_over_h [-]", "front", 0, 0.5, 2, dam_time, 0.6},
    {"dam_break", "paper", "buchner2002_front", "T [-],x_over_h [-]", "front", 0, 0.5, 2, dam_time, 0.6},
    {"sinking_rectangle", "two-phase", "barcarolo2013_trajectory", path_columns, "body_x", 0, 0.5, 3, second,
     1},
    {"sinking_rectangle", "single-phase", "barcarolo2013_trajectory", path_columns, "body_y", 1, 0.5, 3,
     second, 1},
    {"sinking_rectangle", "paper", "barcarolo2013_trajectory", path_columns, "body_angle", 2, 0.5, 3, second,
     1},
    {"catamaran", "air-model-1", "whelan2004_acceleration", acceleration_columns, filtered, 0, 0.002, 0.03,
     second, 1, contact_time},
    {"catamaran", "air-model-2", "whelan2004_acceleration", acceleration_columns, filtered, 0, 0.002, 0.03,
     second, 1, contact_time},
    {"catamaran", "no-air", "whelan2004_acceleration", acceleration_columns, filtered, 0, 0.002, 0.1, second,
     1, contact_time},
    {"catamaran", "paper", "whelan2004_acceleration", acceleration_columns, filtered, 0, 0.002, 0.03, second,
     1, contact_time},
    {"catamaran", "air-model-1", "whelan2004_pressure_p4", pressure_columns, "pressure_p4", 0, 0.002, 0.03,
     second, 1, contact_time},
    {"catamaran", "air-model-2", "whelan2004_pressure_p4", pressure_columns, "pressure_p4", 0, 0.002, 0.03,
     second, 1, contact_time},
    {"catamaran", "no-air", "whelan2004_pressure_p4", pressure_columns, "pressure_p4", 0, 0.002, 0.1, second,
     1, contact_time},
    {"catamaran", "paper-air-model-2", "whelan2004_acceleration", acceleration_columns, filtered, 0, 0.002,
     0.03, second, 1, contact_time},
    {"catamaran", "paper-no-air", "whelan2004_acceleration", acceleration_columns, filtered, 0, 0.002, 0.1,
     second, 1, contact_time},
    {"catamaran", "paper-air-model-2", "whelan2004_pressure_p4", pressure_columns, "pressure_p4", 0, 0.002,
     0.03, second, 1, contact_time},
    {"catamaran", "paper-no-air", "whelan2004_pressure_p4", pressure_columns, "pressure_p4", 0, 0.002, 0.1,
     second, 1, contact_time},
};

/// The series 3 + 40 t, and in the file the same, raised by `raised` times its range.
ComparisonResult compared(const LineSlot& slot, double raised) {
    const samples::ScratchFolder references;
    const Scene scene = shipped(slot.scene, slot.variant);
    const auto line = [](double t) { return 3 + 40 * t; };
    RunRecord record = empty_run(scene);
    record.series[slot.series] = sampled(scene, line, "made up");
    const double range = 40 * (slot.end - slot.begin) * slot.time_unit;
    SlotFile file{slot.scene, slot.stem, slot.columns, {}, {}};
    for (int i = 0; i <= 50; ++i) file.abscissae.push_back(std::lerp(slot.begin, slot.end, i / 50.0));
    file.row = [&](double x) {
        std::vector<double> row(slot.width(), -1e5);
        row.at(slot.column) =
            (line(slot.origin(scene) + x * slot.time_unit) + raised * range) / slot.value_unit;
        return row;
    };
    file.write(references);
    for (ComparisonResult& c : comparisons_with(slot.stem, scene, record, references)) {
        if (c.quantity == slot.series) return c;
    }
    FAIL("no comparison of " << slot.series << " with " << slot.stem);
    return {};
}

bool readme_promises(const std::string& stem, const std::string& columns) {
    std::string text;
    for (const char c : samples::bytes_of(reference_directory() / "README.md")) text += c == '\n' ? ' ' : c;
    return text.find("`" + stem + ".csv`") != std::string::npos && text.find(columns) != std::string::npos;
}

}  // namespace

TEST_CASE("A file in a promised slot is compared with by its scene, on the promised clock", "[slots]") {
    const LineSlot& slot = GENERATE(from_range(line_slots));
    INFO(slot.scene << " " << slot.variant << " " << slot.stem << " " << slot.series);
    CHECK(readme_promises(slot.stem, slot.columns));
    const ComparisonResult same = compared(slot, 0);
    CHECK(same.available);
    INFO(same.note);
    REQUIRE(same.nrmse.has_value());
    CHECK(*same.nrmse == Approx(0).margin(1e-4));
    CHECK(same.within);
    CHECK(compared(slot, 0.4).nrmse.value() == Approx(0.4).margin(1e-4));
}

TEST_CASE("The slot of the energy is the loss of all fluid over its first potential energy", "[slots]") {
    CHECK(readme_promises("cao2018_energy", "T [-],energy_loss [-]"));
    const samples::ScratchFolder references;
    const Scene scene = shipped("dam_break", "two-phase");
    RunRecord record = empty_run(scene);
    record.series["energy_kinetic"] = sampled(
        scene, [](double t) { return 700 * t; }, "J/m");
    record.series["energy_potential"] = sampled(
        scene, [](double t) { return 2000 - 900 * t; }, "J/m");
    record.series["energy_compression"] = sampled(
        scene, [](double t) { return 5 + 20 * t; }, "J/m");
    const double raised = GENERATE(0.0, 0.3);  // times the range
    const double rate = (900 - 700 - 20) * dam_time / 2000;
    SlotFile file{"dam_break", "cao2018_energy", "T [-],energy_loss [-]", {0, 2, 5, 7.5}, {}};
    file.row = [&](double T) { return std::vector{rate * (T + raised * 7.5)}; };
    file.write(references);
    const auto found = comparisons_with("cao2018_energy", scene, record, references);
    REQUIRE(found.size() == 1);
    CHECK(found[0].nrmse.value() == Approx(raised).margin(1e-6));
}

TEST_CASE("The force on the plate is compared from the peaks on, whatever the clock of the file", "[slots]") {
    const char* columns = "t [s],F_plate [N],F [N/m]";
    CHECK(readme_promises("ma2016_force", columns));
    const samples::ScratchFolder references;
    const Scene scene =
        shipped("flat_plate", GENERATE("two-phase", "single-phase", "paper", "paper-single-phase"));
    const auto pulse = [](double t, double half) { return std::max(0.0, 8e4 * (1 - std::abs(t) / half)); };
    RunRecord record = empty_run(scene);
    record.series["body_force_y_filtered"] = sampled(
        scene, [&](double t) { return pulse(t - 0.005, 0.004); }, "N/m");
    const double clock = GENERATE(0.0, 0.0007, -0.002);
    const double factor = GENERATE(1.0, 2.0);
    SlotFile file{"flat_plate", "ma2016_force", columns, {}, {}};
    for (const double t : {-0.004, 0.0, 0.004, 0.005}) file.abscissae.push_back(t + clock);
    file.row = [&](double t) {
        const double force = factor * pulse(t - clock, 0.004);
        return std::vector{0.25 * force, force};
    };
    file.write(references);
    const auto found = comparisons_with("ma2016_force", scene, record, references);
    REQUIRE(found.size() == 1);
    // -2 to 4 ms from the peak: the pulse is 1 - |t|/4 there, its range 1 and its mean square (7/6 + 4/3)/6
    const double rms = std::sqrt((4.0 / 3 * (1 - 0.125) + 4.0 / 3) / 6);
    CHECK(found[0].nrmse.value() == Approx((factor - 1) / factor * rms).margin(2e-3));
    CHECK_FALSE(found[0].time_error.has_value());
    CHECK_THAT(found[0].note, Catch::Contains("aligned on the peaks, 5 of the series"));
}

TEST_CASE("The pressure along the wedge's face is compared at three instants of the measured fall",
          "[slots]") {
    const char* columns = "z_over_Vt [-],Cp_t4.35ms [-],Cp_t15.8ms [-],Cp_t20.2ms [-]";
    CHECK(readme_promises("zhao1996_face_pressure", columns));
    const samples::ScratchFolder references;
    const Scene scene =
        shipped("wedge", GENERATE("two-phase", "single-phase", "paper", "paper-single-phase", "free-fall"));
    const bool whole_fall = scene.variant == "free-fall";
    const double drop = whole_fall ? 1.928 : 0.02, speed = whole_fall ? 0 : 6.118015;
    const double contact = (std::sqrt(speed * speed + 2 * 9.81 * drop) - speed) / 9.81;
    // p = p0 - k s by arc length s, another one after 10 and after 18 ms
    const auto pressure = [](double s, double after) {
        const double level = after < 0.01 ? 1 : after < 0.018 ? 2 : 3;
        return level * (2e4 - 5e4 * s);
    };
    RunRecord record = empty_run(scene);
    Series face{"Pa", "made up", {}, {}, {0.002, 0.1, 0.2, 0.287}};
    for (double t = 0; t < scene.end_time; t += scene.sample_interval) {
        face.time.push_back(t);
        for (const double s : face.abscissa) face.value.push_back(pressure(s, t - contact));
    }
    record.series["face_pressure"] = face;

    const Reference fall = load_reference(reference_directory() / "wedge/zhao1996_velocity.csv");
    const Curve velocity = column_curve(fall, "t", "V");
    const auto penetration = [&](double end) {
        double depth = 0;
        constexpr int steps = 20000;
        for (int i = 0; i < steps; ++i) depth += interpolate(velocity, (i + 0.5) * end / steps) * end / steps;
        return depth;
    };
    const double instants[] = {0.00435, 0.0158, 0.0202};
    const double raised = GENERATE(0.0, 0.25);
    SlotFile file{"wedge", "zhao1996_face_pressure", columns, {-0.9, -0.5, 0.0, 0.2}, {}};
    file.row = [&](double z) {
        std::vector<double> row;
        for (const double t : instants) {
            const double V = interpolate(velocity, t), depth = penetration(t);
            const double slope = 5e4 * 2 * depth;  // of p by z/(V t), at level 1
            const double level = pressure(0, t) / pressure(0, 0);
            row.push_back((pressure(2 * depth * (1 + z), t) + raised * level * slope * 1.1) / (500 * V * V));
        }
        return row;
    };
    file.write(references);
    const auto found = comparisons_with("zhao1996_face_pressure", scene, record, references);
    REQUIRE(found.size() == 3);
    for (const ComparisonResult& c : found) {
        INFO(c.title << ": " << c.note);
        CHECK(c.nrmse.value() == Approx(raised).margin(2e-3));
    }
}

TEST_CASE("A file dropped into a slot appears in the report without another change", "[slots]") {
    const samples::ScratchFolder data, results;
    const Scene scene = shipped("dam_break", "two-phase");
    RunRecord record = samples::stored_run(0.04, 3, samples::bytes_of(find_scene("dam_break")));
    record.scene = "dam_break";
    record.scene_path = "dam_break.toml";
    record.series["front"] = sampled(
        scene, [](double t) { return 1.2 + 3 * t; }, "m");
    fs::create_directories(results / "run");
    write_run(results / "run", record);
    fs::create_directories(data / "reference_data");
    ::setenv("WETDECK_DATA", fs::path(data).c_str(), 1);
    make_report(results);
    const std::string without = samples::report_in(results);
    const SlotFile file{"dam_break", "buchner2002_front", "T [-],x_over_h [-]", {0, 1, 2.4}, [](double T) {
                            return std::vector{(1.2 + 3 * T * dam_time) / 0.6 + 0.25};
                        }};
    file.write(data / "reference_data");
    make_report(results);
    ::unsetenv("WETDECK_DATA");
    const std::string with = samples::report_in(results);
    const std::string path = "reference_data/dam_break/buchner2002_front.csv";
    CHECK_THAT(without, Catch::Contains("curve not available: " + path));
    CHECK_THAT(with, !Catch::Contains("curve not available: " + path));
    CHECK_THAT(with, Catch::Contains(path + "</a>"));
    CHECK_THAT(with, Catch::Contains("Buchner (2002) (experiment)"));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/motion_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/scene/axes.hpp"
#include "validation/scene/number_columns.hpp"

namespace wetdeck {
namespace {

/// A column of a motion file: its name there, the degree of freedom, whether it holds velocities, its unit.
struct ColumnKind {
    const char* name;
    std::size_t degree;
    bool velocity;
    const char* unit;
};
constexpr ColumnKind column_kinds[] = {
    {"x", 0, false, "m"},           {"y", 1, false, "m"},           {"angle", 2, false, "rad"},
    {"velocity_x", 0, true, "m/s"}, {"velocity_y", 1, true, "m/s"}, {"angular_velocity", 2, true, "rad/s"}};

const char* const degree_names[] = {"x", "y", "rotation"};

/// A value with a unit of the given dimension, or in SI units.
double read_value(const TomlTable& table, const std::string& key, double fallback, const char* unit) {
    if (!table.has(key)) return fallback;
    const MeasuredValue value = read_measured_value(table, key);
    if (!value.unit.empty() && !same_dimension(unit_named(value.unit), unit_named(unit)))
        table.fail(key, fmt::format("is in {}, expected {}", value.unit, unit));
    return value.number;
}

/// A number of the samples is checked before it is used: times that increase, no gap, no jump.
void check_samples(const TomlTable& table, const std::string& key, const std::vector<double>& times,
                   double end_time) {
    constexpr double longest_gap = 10;  // median intervals
    if (times.size() < 2) table.fail(key, "expected at least two samples");
    std::vector<double> steps;
    for (std::size_t k = 1; k < times.size(); ++k) {
        if (!(times[k] > times[k - 1]))
            table.fail(key, fmt::format("time {:.6g} s follows {:.6g} s, expected times that increase",
                                        times[k], times[k - 1]));
        steps.push_back(times[k] - times[k - 1]);
    }
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    const double median = steps[steps.size() / 2];
    for (std::size_t k = 1; k < times.size() && times.size() > 4; ++k)
        if (times[k] - times[k - 1] > longest_gap * median)
            table.fail(key, fmt::format("has a gap from {:.6g} to {:.6g} s, {:.0f} times the usual interval",
                                        times[k - 1], times[k], (times[k] - times[k - 1]) / median));
    if (times.front() > 0 || times.back() < end_time * (1 - 1e-9))
        table.fail(key, fmt::format("covers {:.6g} to {:.6g} s, expected samples from 0 to the end of the "
                                    "run at {:.6g} s",
                                    times.front(), times.back(), end_time));
}

/// Throws where samples of a length lead through a jump that is faster than sound.
void check_jumps(const TomlTable& samples, const ColumnKind& kind, const Curve& curve, double sound_speed) {
    for (std::size_t k = 1; k < curve.x.size() && kind.degree < 2; ++k) {
        const double speed = kind.velocity
                                 ? std::abs(curve.y[k])
                                 : std::abs(curve.y[k] - curve.y[k - 1]) / (curve.x[k] - curve.x[k - 1]);
        if (speed >= sound_speed)
            samples.fail(kind.name,
                         fmt::format("moves at {:.4g} m/s from {:.6g} to {:.6g} s, expected a speed "
                                     "below that of sound in the water, {:.4g} m/s",
                                     speed, curve.x[k - 1], curve.x[k], sound_speed));
    }
}

void read_samples(const TomlTable& samples, double end_time, double sound_speed, GivenMotions& given) {
    const std::vector<double> times = samples.numbers("t");
    check_samples(samples, "t", times, end_time);
    for (const ColumnKind& kind : column_kinds) {
        if (!samples.has(kind.name)) continue;
        const std::vector<double> values = samples.numbers(kind.name, times.size());
        if (given.motion[kind.degree])
            samples.fail(kind.name, fmt::format("the {} is given twice", degree_names[kind.degree]));
        const Curve curve{times, values};
        check_jumps(samples, kind, curve, sound_speed);
        given.motion[kind.degree] =
            kind.velocity ? piecewise_linear_velocity(curve) : from_start(sampled_motion(curve));
    }
    samples.finish();
    if (std::none_of(given.motion.begin(), given.motion.end(), [](const Motion& m) { return bool(m); }))
        samples.fail("t",
                     "stands alone, expected one of x, y, angle, velocity_x, velocity_y, "
                     "angular_velocity beside it");
}

Motion read_formula(const TomlTable& table, std::size_t degree) {
    const bool turns = degree == 2;
    const char* const length = turns ? "rad" : "m";
    const char* const speed = turns ? "rad/s" : "m/s";
    const std::string formula = table.choice("formula", {"constant", "ramp", "harmonic", "piecewise"});
    if (formula == "constant")
        return piecewise_linear_velocity({{0}, {read_value(table, "velocity", 0, speed)}});
    if (formula == "ramp") {
        const double begins = read_value(table, "begins", 0, "s");
        const double over = read_value(table, "over", 0, "s");
        if (!(over > 0)) table.fail_missing("over", "expected a positive duration [s]");
        if (begins < 0) table.fail("begins", "expected zero or a later time [s]");
        return piecewise_linear_velocity(
            {{begins, begins + over}, {0, read_value(table, "velocity", 0, speed)}});
    }
    if (formula == "piecewise") {
        const std::vector<double> times = table.numbers("times");
        return piecewise_linear_velocity({times, table.numbers("velocities", times.size())});
    }
    Harmonic harmonic;
    harmonic.amplitude = read_value(table, "amplitude", 0, length);
    harmonic.period = read_value(table, "period", 0, "s");
    harmonic.phase = read_value(table, "phase", 0, "rad");
    harmonic.ramp = read_value(table, "ramp", 0, "s");
    return from_start(harmonic_motion(harmonic));
}

/// Throws where a motion is as fast as sound: a jump of the samples, or a wrong unit.
void check_speed(const TomlTable& table, const std::string& key, const Motion& motion, bool turns,
                 double end_time, double sound_speed) {
    constexpr int instants = 2000;
    for (int k = 0; k <= instants; ++k) {
        const double time = k * end_time / instants;
        const MotionState now = motion(time);
        if (!std::isfinite(now.displacement + now.velocity + now.acceleration))
            table.fail(key, fmt::format("is no finite motion at {:.4g} s", time));
        if (!turns && std::abs(now.velocity) >= sound_speed)
            table.fail(key, fmt::format("moves at {:.4g} m/s at {:.4g} s, expected a speed below that of "
                                        "sound in the water, {:.4g} m/s",
                                        now.velocity, time, sound_speed));
    }
}

/// The samples of a motion file as an inline table.
std::string motion_table(const std::filesystem::path& file) {
    constexpr double largest_bare_angle = 2 * std::numbers::pi;
    std::string text;
    for (const NumberColumn& column : read_columns(file)) {
        const bool is_time = column.name == "t" || column.name == "time";
        const auto kind = std::find_if(std::begin(column_kinds), std::end(column_kinds),
                                       [&](const ColumnKind& k) { return k.name == column.name; });
        if (!is_time && kind == std::end(column_kinds))
            throw DataError(
                fmt::format("{}: a column is named '{}', expected t, x, y, angle, velocity_x, velocity_y, "
                            "angular_velocity",
                            file.string(), column.name));
        const char* const unit = is_time ? "s" : kind->unit;
        if (!column.unit.empty() && !same_dimension(unit_named(column.unit), unit_named(unit)))
            throw DataError(fmt::format("{}: column '{}' is in {}, expected a unit such as {}", file.string(),
                                        column.name, column.unit, unit));
        const auto large = [](double v) { return std::abs(v) > largest_bare_angle; };
        if (column.name == "angle" && column.unit.empty() &&
            std::any_of(column.values.begin(), column.values.end(), large))
            throw DataError(
                fmt::format("{}: column 'angle' exceeds a whole turn and names no unit, expected "
                            "'angle [deg]' or 'angle [rad]'",
                            file.string()));
        text += fmt::format("{}{} = [{}]", text.empty() ? "" : ", ", is_time ? "t" : column.name,
                            fmt::join(column.values, ", "));
    }
    return "{ " + text + " }";
}

/// The samples of a spring as rows: elongation and pull.
std::string spring_rows(const std::filesystem::path& file) {
    const std::vector<NumberColumn> columns = read_columns(file);
    if (columns.size() != 2)
        throw DataError(
            fmt::format("{}: holds {} columns, expected elongation and pull", file.string(), columns.size()));
    std::string rows;
    for (std::size_t k = 0; k < columns[0].values.size(); ++k)
        rows +=
            fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", columns[0].values[k], columns[1].values[k]);
    return "[" + rows + "]";
}

}  // namespace

double read_angle(const TomlTable& table, const std::string& key, double fallback) {
    return read_value(table, key, fallback, "rad");
}

GivenMotions read_motions(const TomlTable& table, double end_time, double sound_speed) {
    GivenMotions given;
    const std::optional<TomlTable> motion = table.optional_table("motion");
    if (!motion) return given;
    given.text = table.text_of("motion");
    try {
        if (motion->has("t")) {
            read_samples(*motion, end_time, sound_speed, given);
        } else {
            for (std::size_t degree = 0; degree < 3; ++degree) {
                const std::optional<TomlTable> formula = motion->optional_table(degree_names[degree]);
                if (!formula) continue;
                given.motion[degree] = read_formula(*formula, degree);
                formula->finish();
            }
            motion->finish();
        }
    } catch (const InputError& error) {
        const std::string text = error.what();
        if (text.find(": key '") != std::string::npos) throw;
        table.fail("motion", text);
    }
    for (std::size_t degree = 0; degree < 3; ++degree) {
        if (!given.motion[degree]) continue;
        check_speed(table, "motion", given.motion[degree], degree == 2, end_time, sound_speed);
    }
    return given;
}

std::string with_sample_files(std::string text, const std::filesystem::path& scene) {
    const TomlDocument document(text, scene.string());
    std::vector<TomlDocument::TextValue> files = document.texts_named("motion");
    for (const TomlDocument::TextValue& each : document.texts_named("table"))
        if (each.key.find("springs") != std::string::npos) files.push_back(each);
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.begin > b.begin; });
    for (const TomlDocument::TextValue& file : files) {  // from the end: places before it stay
        const std::filesystem::path path = scene.parent_path() / file.value;
        try {
            const bool motion = file.key.ends_with("motion");
            text.replace(file.begin, file.end - file.begin, motion ? motion_table(path) : spring_rows(path));
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("{}:{}: key '{}': {}", scene.string(), file.line, file.key, error.what()));
        }
    }
    return text;
}

}  // namespace wetdeck

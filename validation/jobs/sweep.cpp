// SPDX-License-Identifier: BSD-3-Clause
#include "validation/jobs/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/run/assemble.hpp"
#include "validation/scene/identity.hpp"
#include "validation/scene/scene.hpp"
#include "validation/scene/toml_reader.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr const char* parameter_table = "parameters.";
constexpr double most_points = 10'000;

std::string assignment(const SweepAxis& axis, double value) {
    const std::string number = fmt::format("{:.10g}", value);
    return axis.unit.empty() ? fmt::format("{}={}", axis.key, number)
                             : fmt::format("{}=\"{} {}\"", axis.key, number, axis.unit);
}

/// "10:50:5" at a colon.
std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts = {""};
    for (const char c : text) {
        if (c == ':')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string identity_at(const SweepPlan& plan, const std::vector<double>& at) {
    return setup_identity(read_scene(find_scene(plan.scene), plan.variant, overrides_at(plan, at)));
}

/// The expression that the scene has for a dotted key; empty where it has a number, or none.
std::string expression_of(const TomlTable& root, const std::string& key) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos) return root.holds_expression(key) ? root.expression(key) : "";
    const std::string table = key.substr(0, dot);
    return root.is_table(table) ? expression_of(root.table(table), key.substr(dot + 1)) : "";
}

/// Throws for a key that is no parameter and has no table, for one that follows from parameters, and for a
/// parameter in degrees that would be taken for one in radians.
void check_key(const SweepAxis& axis, const Scene& scene) {
    const TomlDocument document(scene.text, scene.path);
    const TomlTable root = document.root();
    std::vector<std::string> names;
    for (const auto& [name, value] : scene.parameters) names.push_back(name);
    const auto fail = [&axis](const std::string& what) {
        throw InputError(fmt::format("option --over {}: {}", axis.key, what));
    };
    if (axis.key.find('.') == std::string::npos)
        fail(names.empty()
                 ? "is no dotted key of the scene file, as body.velocity_y, and the scene has no parameters"
                 : fmt::format("is no dotted key of the scene file and none of its parameters: {}",
                               fmt::join(names, ", ")));
    if (const std::string expression = expression_of(root, axis.key); !expression.empty())
        fail(
            fmt::format("follows from others in this scene, '{}': what else follows from them would stay "
                        "behind; expected one of the parameters {}",
                        expression, fmt::join(names, ", ")));
    if (!axis.key.starts_with(parameter_table) || !axis.unit.empty()) return;
    const TomlTable parameters = root.table("parameters");
    const std::string name = axis.key.substr(std::string(parameter_table).size());
    if (parameters.holds_text(name))
        fail(fmt::format("is \"{}\" in the scene: expected values with a unit, KEY=\"FROM:TO:COUNT UNIT\"",
                         parameters.text(name)));
}

/// Throws for a key whose ends give the same run.
void check_effect(const SweepPlan& plan) {
    for (std::size_t k = 0; k < plan.axes.size(); ++k) {
        const SweepAxis& axis = plan.axes[k];
        if (axis.count == 1) continue;
        std::vector<double> low, high;
        for (const SweepAxis& each : plan.axes) low.push_back(each.from);
        high = low;
        high[k] = axis.to;
        if (identity_at(plan, low) == identity_at(plan, high))
            throw InputError(
                fmt::format("option --over {}: changes nothing in the run: its set-up is the "
                            "same at {:.6g} and at {:.6g}",
                            axis.key, axis.from, axis.to));
    }
}

}  // namespace

SweepAxis parse_axis(const std::string& text, const Scene& scene) {
    const auto fail = [&text](const std::string& what) -> InputError {
        return InputError(fmt::format(
            "option --over {}: {}, expected KEY=FROM:TO:COUNT, as in deadrise=\"10:50:5 deg\"", text, what));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw fail("has no '='");
    SweepAxis axis;
    axis.key = text.substr(0, equals);
    if (scene.parameters.contains(axis.key)) axis.key = parameter_table + axis.key;
    std::string values(trimmed(std::string_view(text).substr(equals + 1)));
    if (const std::size_t gap = values.find(' '); gap != std::string::npos) {
        axis.unit = trimmed(std::string_view(values).substr(gap));
        values.resize(gap);
        unit_named(axis.unit);
    }
    const std::vector<std::string> parts = parts_of(values);
    std::vector<double> numbers;
    for (const std::string& part : parts)
        if (const auto number = number_in(part); number && std::isfinite(*number)) numbers.push_back(*number);
    if (parts.size() != 3 || numbers.size() != 3) throw fail("is not three numbers with colons between them");
    axis.from = numbers[0];
    axis.to = numbers[1];
    if (numbers[2] < 1 || numbers[2] > most_points || numbers[2] != std::floor(numbers[2]))
        throw fail("has a COUNT that is no whole number from 1");
    axis.count = static_cast<int>(numbers[2]);
    if (axis.count == 1 && axis.from != axis.to) throw fail("has one value, but two different ends");
    if (axis.count > 1 && axis.from == axis.to) throw fail("has the same value at both ends");
    check_key(axis, scene);
    return axis;
}

std::vector<std::vector<double>> grid_points(const std::vector<SweepAxis>& axes) {
    std::set<std::string> keys;
    double count = 1;
    for (const SweepAxis& axis : axes) {
        if (!keys.insert(axis.key).second)
            throw InputError(fmt::format("option --over {}: is given twice", axis.key));
        count *= axis.count;
    }
    if (count > most_points)
        throw InputError(fmt::format("option --over: {} points, expected at most {}", count, most_points));
    std::vector<std::vector<double>> points = {{}};
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
        std::vector<std::vector<double>> longer;
        for (const std::vector<double>& rest : points) {
            for (int k = 0; k < axis->count; ++k) {
                longer.push_back({axis->value(k)});
                longer.back().insert(longer.back().end(), rest.begin(), rest.end());
            }
        }
        points = std::move(longer);
    }
    return points;
}

std::vector<std::string> overrides_at(const SweepPlan& plan, const std::vector<double>& at) {
    std::vector<std::string> all = plan.overrides;
    for (std::size_t k = 0; k < at.size(); ++k) all.push_back(assignment(plan.axes[k], at[k]));
    return all;
}

fs::path point_directory(const SweepPlan& plan, const std::vector<double>& at) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < at.size(); ++k) {
        std::string name = fmt::format("{}={:.10g}{}", plan.axes[k].key, at[k], plan.axes[k].unit);
        std::replace(name.begin(), name.end(), '/', '_');  // of a unit such as m/s
        names.push_back(name);
    }
    return plan.directory / "points" / fmt::format("{}", fmt::join(names, ","));
}

std::vector<SuiteRow> sweep_rows(const SweepPlan& plan) {
    std::vector<SuiteRow> rows;
    for (const std::vector<double>& at : grid_points(plan.axes)) {
        const std::vector<std::string> overrides = overrides_at(plan, at);
        const Scene scene = read_scene(find_scene(plan.scene), plan.variant, overrides);
        for (const double dx : plan.spacings) {
            check_spacing(scene, dx);
            const CostEstimate cost = estimate_cost(scene, dx);
            const fs::path folder = point_directory(plan, at);
            SuiteRow row{plan.scene,        plan.variant, dx,
                         cost.core_seconds, overrides,    folder / fmt::format("dx{}", dx)};
            row.fluid_particles = cost.fluid_particles;
            row.label = folder.filename().string();
            rows.push_back(std::move(row));
        }
    }
    check_effect(plan);
    return rows;
}

void write_sweep_plan(const SweepPlan& plan) {
    nlohmann::json axes = nlohmann::json::array();
    for (const SweepAxis& axis : plan.axes)
        axes.push_back({{"key", axis.key},
                        {"from", axis.from},
                        {"to", axis.to},
                        {"count", axis.count},
                        {"unit", axis.unit}});
    const nlohmann::json all = {{"scene", plan.scene},
                                {"variant", plan.variant},
                                {"axes", axes},
                                {"spacings", plan.spacings},
                                {"overrides", plan.overrides}};
    make_directories(plan.directory);
    atomic_write(plan.directory / sweep_file, all.dump(2) + "\n");
}

SweepPlan read_sweep_plan(const fs::path& directory) {
    const fs::path file = directory / sweep_file;
    try {
        const nlohmann::json all = nlohmann::json::parse(read_whole_file(file));
        SweepPlan plan{all.at("scene"),    all.at("variant"),   {},
                       all.at("spacings"), all.at("overrides"), directory};
        for (const nlohmann::json& axis : all.at("axes"))
            plan.axes.push_back(
                {axis.at("key"), axis.at("from"), axis.at("to"), axis.at("count"), axis.at("unit")});
        return plan;
    } catch (const nlohmann::json::exception&) {
        throw DataError(fmt::format("{}: expected the plan of a sweep", file.string()));
    }
}

}  // namespace wetdeck

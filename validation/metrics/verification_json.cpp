// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/verification_json.hpp"

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/json_fields.hpp"

namespace wetdeck {

using nlohmann::json;

static std::vector<double> read_numbers(const json& list) {
    std::vector<double> values;
    for (const json& value : list)
        values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    return values;
}

static void to_json(json& j, const Curve& curve) {
    j = {{"x", numbers(curve.x)}, {"y", numbers(curve.y)}};
}
static void from_json(const json& j, Curve& curve) {
    curve = {read_numbers(j.at("x")), read_numbers(j.at("y"))};
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LabelledCurve, label, curve)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VerificationFigure, title, x_label, x_unit, y_label, y_unit, exact,
                                   computed)

static void to_json(json& j, const VerificationRow& row) {
    const auto& range = row.claim.order;
    j = {{"quantity", row.claim.quantity},
         {"meaning", row.claim.meaning},
         {"resolution_is", row.claim.resolution},
         {"resolution", numbers(row.resolution)},
         {"error", numbers(row.error)},
         {"order", row.order},
         {"expected_order", range ? json(0.5 * (range->begin + range->end)) : json(nullptr)},
         {"expected_order_range", range},
         {"bound", row.claim.bound},
         {"reason", row.claim.reason},
         {"known_miss", row.claim.known_miss},
         {"within", row.within}};
}
static void from_json(const json& j, VerificationRow& row) {
    j.at("quantity").get_to(row.claim.quantity);
    j.at("meaning").get_to(row.claim.meaning);
    j.at("resolution_is").get_to(row.claim.resolution);
    j.at("known_miss").get_to(row.claim.known_miss);
    j.at("bound").get_to(row.claim.bound);
    j.at("reason").get_to(row.claim.reason);
    j.at("expected_order_range").get_to(row.claim.order);
    row.resolution = read_numbers(j.at("resolution"));
    row.error = read_numbers(j.at("error"));
    judge(row);
}

/// Each row with the name of its problem.
static json rows_json(const VerificationProblem& problem) {
    json rows = json::array();
    for (const VerificationRow& row : problem.rows) {
        rows.push_back(row);
        rows.back()["problem"] = problem.name;
    }
    return rows;
}

static void to_json(json& j, const VerificationProblem& problem) {
    j = {{"name", problem.name},         {"title", problem.title},     {"exact", problem.exact},
         {"rows", rows_json(problem)},   {"figures", problem.figures}, {"notes", problem.notes},
         {"unstable", problem.unstable}, {"wall_s", problem.wall_s}};
}
static void from_json(const json& j, VerificationProblem& problem) {
    j.at("name").get_to(problem.name);
    j.at("title").get_to(problem.title);
    j.at("exact").get_to(problem.exact);
    j.at("rows").get_to(problem.rows);
    j.at("figures").get_to(problem.figures);
    j.at("notes").get_to(problem.notes);
    j.at("unstable").get_to(problem.unstable);
    j.at("wall_s").get_to(problem.wall_s);
}

json verification_list(const std::vector<VerificationProblem>& problems) {
    json list = json::array();
    for (const VerificationProblem& problem : problems) {
        for (json& row : rows_json(problem)) list.push_back(std::move(row));
    }
    return list;
}

json verification_json(const std::vector<VerificationProblem>& problems) {
    return problems;
}

std::vector<VerificationProblem> read_verification(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) return {};
    try {
        return json::parse(in).get<std::vector<VerificationProblem>>();
    } catch (const json::exception& error) {
        throw DataError(file.string() + ": not the results of `wetdeck verify`: " + error.what());
    }
}

}  // namespace wetdeck

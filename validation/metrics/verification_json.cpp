// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/verification_json.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/json_numbers.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;

std::vector<double> read_numbers(const json& list) {
    std::vector<double> values;
    for (const json& value : list)
        values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    return values;
}

json curve_json(const Curve& curve) {
    return {{"x", numbers(curve.x)}, {"y", numbers(curve.y)}};
}

Curve read_curve(const json& curve) {
    return {read_numbers(curve.at("x")), read_numbers(curve.at("y"))};
}

json row_json(const std::string& problem, const VerificationRow& row) {
    const auto& range = row.claim.order;
    return {{"problem", problem},
            {"quantity", row.claim.quantity},
            {"meaning", row.claim.meaning},
            {"resolution_is", row.claim.resolution},
            {"resolution", numbers(row.resolution)},
            {"error", numbers(row.error)},
            {"order", number(row.order)},
            {"expected_order", range ? json(0.5 * (range->begin + range->end)) : json(nullptr)},
            {"expected_order_range", range ? json{range->begin, range->end} : json(nullptr)},
            {"bound", number(row.claim.bound)},
            {"reason", row.claim.reason},
            {"known_miss", row.claim.known_miss},
            {"within", row.within}};
}

VerificationRow read_row(const json& entry) {
    VerificationRow row;
    row.claim.quantity = entry.at("quantity");
    row.claim.meaning = entry.at("meaning");
    row.claim.resolution = entry.at("resolution_is");
    row.claim.known_miss = entry.at("known_miss");
    row.claim.bound = entry.at("bound");
    row.claim.reason = entry.at("reason");
    const json& range = entry.at("expected_order_range");
    if (!range.is_null()) row.claim.order = Window{range.at(0), range.at(1)};
    row.resolution = read_numbers(entry.at("resolution"));
    row.error = read_numbers(entry.at("error"));
    judge(row);
    return row;
}

json problem_json(const VerificationProblem& problem) {
    json rows = json::array(), figures = json::array();
    for (const VerificationRow& row : problem.rows) rows.push_back(row_json(problem.name, row));
    for (const VerificationFigure& figure : problem.figures) {
        json computed = json::array();
        for (const auto& [label, curve] : figure.computed)
            computed.push_back({{"label", label}, {"curve", curve_json(curve)}});
        figures.push_back({{"title", figure.title},
                           {"x_label", figure.x_label},
                           {"x_unit", figure.x_unit},
                           {"y_label", figure.y_label},
                           {"y_unit", figure.y_unit},
                           {"exact", curve_json(figure.exact)},
                           {"computed", computed}});
    }
    return {{"name", problem.name},         {"title", problem.title},
            {"exact", problem.exact},       {"rows", rows},
            {"figures", figures},           {"notes", problem.notes},
            {"unstable", problem.unstable}, {"wall_s", number(problem.wall_s)}};
}

VerificationProblem read_problem(const json& entry) {
    VerificationProblem problem;
    problem.name = entry.at("name");
    problem.title = entry.at("title");
    problem.exact = entry.at("exact");
    problem.notes = entry.at("notes").get<std::vector<std::string>>();
    problem.unstable = entry.at("unstable");
    problem.wall_s = entry.at("wall_s");
    for (const json& row : entry.at("rows")) problem.rows.push_back(read_row(row));
    for (const json& f : entry.at("figures")) {
        VerificationFigure figure{f.at("title"),
                                  f.at("x_label"),
                                  f.at("x_unit"),
                                  f.at("y_label"),
                                  f.at("y_unit"),
                                  read_curve(f.at("exact")),
                                  {}};
        for (const json& c : f.at("computed"))
            figure.computed.emplace_back(c.at("label"), read_curve(c.at("curve")));
        problem.figures.push_back(std::move(figure));
    }
    return problem;
}

}  // namespace

json verification_list(const std::vector<VerificationProblem>& problems) {
    json list = json::array();
    for (const VerificationProblem& problem : problems) {
        for (const VerificationRow& row : problem.rows) list.push_back(row_json(problem.name, row));
    }
    return list;
}

json verification_json(const std::vector<VerificationProblem>& problems) {
    json list = json::array();
    for (const VerificationProblem& problem : problems) list.push_back(problem_json(problem));
    return list;
}

std::vector<VerificationProblem> read_verification(const std::filesystem::path& file) {
    std::vector<VerificationProblem> problems;
    std::ifstream in(file);
    if (!in) return problems;
    try {
        for (const json& entry : json::parse(in)) problems.push_back(read_problem(entry));
    } catch (const json::exception& error) {
        throw DataError(file.string() + ": not the results of `wetdeck verify`: " + error.what());
    }
    return problems;
}

}  // namespace wetdeck

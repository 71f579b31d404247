// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/sweep_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace wetdeck {
namespace {

std::string cell(const std::optional<double>& value) {
    return value ? fmt::format("{:.8g}", *value) : "";
}

}  // namespace

std::string SweepAxis::title() const {
    const std::string parameters = "parameters.";
    const std::string name = key.starts_with(parameters) ? key.substr(parameters.size()) : key;
    return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string sweep_csv(const SweepResult& result) {
    std::string text = fmt::format("# wetdeck sweep of {}, variant {}\n", result.scene, result.variant);
    for (const auto& [name, value] : result.provenance) text += fmt::format("# {}: {}\n", name, value);
    text +=
        "# keys without a unit are in SI units and rad; u_num: standard uncertainty (k = 1) of the particle "
        "spacing, from all spacings of the point; "
        "empty: unknown\n";
    std::vector<std::string> titles;
    for (const SweepAxis& axis : result.axes) titles.push_back(axis.title());
    titles.emplace_back("dx [m]");
    const std::vector<SweepQuantity> none;
    const std::vector<SweepQuantity>& quantities =
        result.points.empty() ? none : result.points.front().quantities;
    for (const SweepQuantity& q : quantities) {
        titles.push_back(fmt::format("{} [{}]", q.name, q.unit));
        titles.push_back(fmt::format("{}_u_num [{}]", q.name, q.unit));
        titles.push_back(fmt::format("{}_expected [{}]", q.name, q.unit));
        for (const auto& [line, value] : q.lines)
            titles.push_back(fmt::format("{}_{} [{}]", q.name, line, q.unit));
    }
    titles.emplace_back("core_s [s]");
    titles.emplace_back("status");
    text += fmt::format("{}\n", fmt::join(titles, ","));
    for (const SweepPoint& point : result.points) {
        std::vector<std::string> cells;
        for (const double value : point.at) cells.push_back(fmt::format("{:.10g}", value));
        cells.push_back(point.dx.empty() ? "" : fmt::format("{}", point.dx.back()));
        for (const SweepQuantity& q : point.quantities) {
            for (const auto& value : {q.value, q.u_num, q.expected}) cells.push_back(cell(value));
            for (const auto& [line, value] : q.lines) cells.push_back(cell(value));
        }
        cells.push_back(fmt::format("{:.4g}", point.core_seconds));
        cells.push_back(point.status);
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

}  // namespace wetdeck

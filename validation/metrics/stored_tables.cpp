// SPDX-License-Identifier: BSD-3-Clause
// Ablation and stress results as files.
#include "validation/metrics/stored_tables.hpp"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/json_numbers.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::optional<double> optional_number(const json& row, const char* key) {
    return row.at(key).is_null() ? std::nullopt : std::optional(row.at(key).get<double>());
}

template <typename Row>
void write_rows(const fs::path& file, const std::vector<Row>& rows, json (*convert)(const Row&)) {
    json list = json::array();
    for (const Row& row : rows) list.push_back(convert(row));
    make_directories(file.parent_path());
    atomic_write(file, json{{"schema", 1}, {"rows", std::move(list)}}.dump(1) + "\n");
}

template <typename Row>
std::vector<Row> read_rows(const fs::path& file, Row (*convert)(const json&)) {
    std::vector<Row> rows;
    if (!fs::exists(file)) return rows;
    std::ifstream in(file);
    const json document = json::parse(in, nullptr, false);
    if (!document.is_object() || document.value("schema", json()) != 1 || !document.contains("rows") ||
        !document.at("rows").is_array())
        throw DataError(fmt::format("{}: expected an object with schema 1 and rows", file.string()));
    for (const json& row : document.at("rows")) {
        try {
            rows.push_back(convert(row));
        } catch (const json::exception& error) {
            throw DataError(fmt::format("{}: row {}: {}", file.string(), rows.size() + 1, error.what()));
        }
    }
    return rows;
}

AblationRow ablation_row(const json& row) {
    return {row.at("scene").get<std::string>(),      row.at("dx").get<double>(),
            row.at("ingredient").get<std::string>(), optional_number(row, "core_s_ratio"),
            optional_number(row, "error_change"),    row.at("needed").get<bool>()};
}

StressRow stress_row(const json& row) {
    return {row.at("case").get<std::string>(), row.at("setting").get<std::string>(),
            row.at("survived").get<bool>(), row.at("note").get<std::string>(),
            row.value("picture", std::string())};
}

}  // namespace

json ablation_json(const AblationRow& row) {
    return {{"scene", row.scene},
            {"dx", row.dx},
            {"ingredient", row.ingredient},
            {"core_s_ratio", number(row.core_s_ratio)},
            {"error_change", number(row.error_change)},
            {"needed", row.needed}};
}

json stress_json(const StressRow& row) {
    json out = {
        {"case", row.stress_case}, {"setting", row.setting}, {"survived", row.survived}, {"note", row.note}};
    if (!row.picture.empty()) out["picture"] = row.picture;
    return out;
}

void write_ablation(const fs::path& directory, const std::vector<AblationRow>& rows) {
    write_rows(directory / "ablation.json", rows, ablation_json);
}

void write_stress(const fs::path& directory, const std::vector<StressRow>& rows) {
    write_rows(directory / stress_file, rows, stress_json);
}

std::vector<AblationRow> read_ablation(const fs::path& directory) {
    return read_rows(directory / "ablation.json", ablation_row);
}

std::vector<StressRow> read_stress(const fs::path& directory) {
    return read_rows(directory / stress_file, stress_row);
}

}  // namespace wetdeck

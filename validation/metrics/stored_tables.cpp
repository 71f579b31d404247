// SPDX-License-Identifier: BSD-3-Clause
// Ablation and stress results as files.
#include "validation/metrics/stored_tables.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/json_fields.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

template <typename Row>
void write_rows(const fs::path& file, const std::vector<Row>& rows) {
    make_directories(file.parent_path());
    atomic_write(file, json{{"schema", 1}, {"rows", rows}}.dump(1) + "\n");
}

template <typename Row>
std::vector<Row> read_rows(const fs::path& file) {
    std::vector<Row> rows;
    if (!fs::exists(file)) return rows;
    const json document = json::parse(read_whole_file(file), nullptr, false);
    if (!document.is_object() || document.value("schema", json()) != 1 || !document.contains("rows") ||
        !document.at("rows").is_array())
        throw DataError(fmt::format("{}: expected an object with schema 1 and rows", file.string()));
    for (const json& row : document.at("rows")) {
        try {
            rows.push_back(row.get<Row>());
        } catch (const json::exception& error) {
            throw DataError(fmt::format("{}: row {}: {}", file.string(), rows.size() + 1, error.what()));
        }
    }
    return rows;
}

}  // namespace

json ablation_json(const AblationRow& row) {
    return row;
}

void write_ablation(const fs::path& directory, const std::vector<AblationRow>& rows) {
    write_rows(directory / "ablation.json", rows);
}

void write_stress(const fs::path& directory, const std::vector<StressRow>& rows) {
    write_rows(directory / stress_file, rows);
}

std::vector<AblationRow> read_ablation(const fs::path& directory) {
    return read_rows<AblationRow>(directory / "ablation.json");
}

std::vector<StressRow> read_stress(const fs::path& directory) {
    return read_rows<StressRow>(directory / stress_file);
}

}  // namespace wetdeck

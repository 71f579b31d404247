// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/peer_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/metrics/json_fields.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PeerQuantity, unit, values, curve)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PeerResult, scene, variant, code, differences, quantities)

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* peer_file = "peer.json";

PeerResult read_peer_result(const fs::path& file) {
    try {
        const json document = json::parse(read_whole_file(file));
        if (document.at("schema") != 1) throw DataError(fmt::format("{}: expected schema 1", file.string()));
        return document.get<PeerResult>();
    } catch (const json::exception& error) {
        throw DataError(fmt::format("{}: not as `wetdeck peer` writes it: {}", file.string(), error.what()));
    }
}

/// Values of this program by spacing, in the runs of one scene and variant.
std::map<double, double> own_values(const std::vector<RunSummary>& runs, const PeerResult& peer,
                                    const std::string& quantity) {
    std::map<double, double> values;
    for (const RunSummary& run : runs) {
        if (run.record.scene != peer.scene || run.record.variant != peer.variant || !counts(run)) continue;
        for (const QuantityResult& each : run.quantities)
            if (each.name == quantity && each.value) values[run.record.particle_spacing] = *each.value;
    }
    return values;
}

ValidationRow row_of(const PeerResult& peer, const PeerQuantity& theirs,
                     const std::map<double, double>& own) {
    ValidationRow row;
    row.scene = peer.scene;
    row.variant = peer.variant;
    row.quantity = theirs.values.qoi;
    row.unit = theirs.unit;
    row.against = peer.code;
    row.kind = ReferenceKind::peer_simulation;
    row.dx = own.begin()->first;
    row.simulated = own.begin()->second;
    row.reference = theirs.values.value.back();
    row.error = row.simulated - row.reference;
    row.u_grid = row.u_num = numerical_uncertainty(convergence({own.begin(), own.end()}));
    row.u_data = numerical_uncertainty(theirs.values);
    row.u_input = 0;
    row.u_known = std::hypot(row.u_num.value_or(0), row.u_data.value_or(0));
    row.verdict = "unknown";
    row.sentence = "too few spacings or meshes to tell the numerical uncertainty";
    if (!row.u_num || !row.u_data) return row;
    row.u_val = row.u_known;
    const bool within = std::abs(row.error) <= *row.u_num + *row.u_data;
    row.verdict = within ? "agree within" : "differ by more than both";
    row.sentence = within ? "both codes agree within their numerical uncertainties"
                          : "the codes differ by more than both numerical uncertainties";
    return row;
}

}  // namespace

void write_peer_result(const fs::path& directory, const PeerResult& result) {
    json document = result;
    document["schema"] = 1;
    atomic_write(directory / peer_file, document.dump(1) + "\n");
}

std::vector<PeerResult> read_peer_results(const fs::path& directory) {
    std::vector<fs::path> files;
    if (fs::is_directory(directory))
        for (const auto& entry : fs::recursive_directory_iterator(directory))
            if (entry.path().filename() == peer_file && entry.is_regular_file())
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<PeerResult> results;
    for (const fs::path& file : files) results.push_back(read_peer_result(file));
    return results;
}

std::vector<ValidationRow> peer_agreement(const std::vector<PeerResult>& peers,
                                          const std::vector<RunSummary>& runs) {
    std::vector<ValidationRow> rows;
    for (const PeerResult& peer : peers)
        for (const PeerQuantity& theirs : peer.quantities) {
            const std::map<double, double> own = own_values(runs, peer, theirs.values.qoi);
            if (own.empty() || theirs.values.value.empty()) continue;
            rows.push_back(row_of(peer, theirs, own));
        }
    return rows;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// What another code computed of a scene on several meshes, as a file, and how far this one agrees with it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// One quantity of the scene on the meshes of another code.
struct PeerQuantity {
    std::string unit;
    ConvergenceRow values;  ///< dx: size of the cells [m], coarse to fine
    std::string curve;      ///< file of the series on the finest mesh, beside peer.json
};

/// The content of peer.json.
struct PeerResult {
    std::string scene, variant;
    std::string code;  ///< "OpenFOAM v1912, interFoam"
    std::vector<std::string> differences;
    std::vector<PeerQuantity> quantities;
};

/// Writes DIR/peer.json, whole or not at all.
void write_peer_result(const std::filesystem::path& directory, const PeerResult& result);

/// Every peer.json below a directory, by path. Throws DataError "FILE: ..." for one that is not as written.
std::vector<PeerResult> read_peer_results(const std::filesystem::path& directory);

/// The finest value of this program beside the finest one of the other code, for each quantity that both
/// have. Their uncertainties are numerical_uncertainty (convergence.hpp). The verdict is "agree within" where
/// the difference is at most the sum of both, "differ by more than both" beyond it, "unknown" where one of
/// them is not known. Runs that did not end well are left out.
std::vector<ValidationRow> peer_agreement(const std::vector<PeerResult>& peers,
                                          const std::vector<RunSummary>& runs);

}  // namespace wetdeck

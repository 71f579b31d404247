// SPDX-License-Identifier: BSD-3-Clause
// A scene on several meshes of OpenFOAM: run, read, compared.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "validation/metrics/peer_result.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

struct FoamPeerOptions {
    std::vector<double> cells;    ///< sizes of the cells [m], coarse to fine
    std::optional<double> until;  ///< end of the runs [s]
    double limit = 0;             ///< wall time of all runs [s]
};

/// Runs the meshes that are not finished into DIR/cell<size>, writes DIR/peer.json and the curves of the
/// finest mesh, and returns the result. Throws what run_case throws, and InputError for a scene that fits no
/// mesh.
PeerResult run_foam_peer(const Scene& scene, const std::filesystem::path& directory,
                         const FoamPeerOptions& options);

}  // namespace wetdeck

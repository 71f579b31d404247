// SPDX-License-Identifier: BSD-3-Clause
// Which cells of a mesh hold a point, or lie along a ray.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "validation/openfoam/plane_mesh.hpp"

namespace wetdeck {

/// Cells of a mesh by place. The mesh must live as long as the object.
class CellFinder {
  public:
    explicit CellFinder(const PlaneMesh& mesh);

    /// The cell that holds the point; nothing outside the mesh.
    std::optional<std::size_t> at(Vec2 point) const;

    /// A cell that a ray passes.
    struct Passed {
        std::size_t cell;
        double distance;  ///< of its centre from the beginning, along the ray [m]
    };
    /// The cells along a ray, by distance; parts of the ray outside the mesh have none.
    /// @param direction  unit vector
    /// @param step       how far apart places on the ray are looked at: thinner cells may be missed [m]
    std::vector<Passed> along(Vec2 begin, Vec2 direction, double length, double step) const;

  private:
    std::size_t bin_of(double x, int axis) const;

    const PlaneMesh& mesh_;
    Vec2 low_, width_;  ///< of all bins, of one bin [m]
    std::size_t columns_ = 1;
    std::vector<std::vector<std::size_t>> bins_;  ///< cells whose extent meets a bin, row by row
};

}  // namespace wetdeck

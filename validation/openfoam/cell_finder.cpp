// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/cell_finder.hpp"

#include <algorithm>
#include <cmath>

#include "solver/core/cross.hpp"

namespace wetdeck {
namespace {

bool holds(const std::array<Vec2, 4>& corners, Vec2 point) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 side = corners[(k + 1) % 4] - corners[k];
        if (cross(side, point - corners[k]) < -1e-12 * side.norm()) return false;
    }
    return true;
}

}  // namespace

CellFinder::CellFinder(const PlaneMesh& mesh) : mesh_(mesh) {
    low_ = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
    for (const Vec2& point : mesh.points) {
        low_ = low_.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    columns_ =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(mesh.cells.size()))));
    width_ = (high - low_) / static_cast<double>(columns_);
    bins_.resize(columns_ * columns_);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        const auto corners = mesh.corners(c);
        Vec2 from = corners[0], to = corners[0];
        for (const Vec2& corner : corners) {
            from = from.cwiseMin(corner);
            to = to.cwiseMax(corner);
        }
        for (std::size_t j = bin_of(from.y(), 1); j <= bin_of(to.y(), 1); ++j)
            for (std::size_t i = bin_of(from.x(), 0); i <= bin_of(to.x(), 0); ++i)
                bins_[j * columns_ + i].push_back(c);
    }
}

std::size_t CellFinder::bin_of(double x, int axis) const {
    const double bin = std::floor((x - low_[axis]) / width_[axis]);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(columns_ - 1)));
}

std::optional<std::size_t> CellFinder::at(Vec2 point) const {
    for (const std::size_t c : bins_[bin_of(point.y(), 1) * columns_ + bin_of(point.x(), 0)])
        if (holds(mesh_.corners(c), point)) return c;
    return std::nullopt;
}

std::vector<CellFinder::Passed> CellFinder::along(Vec2 begin, Vec2 direction, double length,
                                                  double step) const {
    std::vector<Passed> passed;
    const auto count = static_cast<std::size_t>(std::ceil(length / step));
    for (std::size_t k = 0; k < count; ++k) {
        const double s = (static_cast<double>(k) + 0.5) * length / static_cast<double>(count);
        const auto cell = at(begin + s * direction);
        if (!cell || (!passed.empty() && passed.back().cell == *cell)) continue;
        passed.push_back({*cell, (mesh_.centre(*cell) - begin).dot(direction)});
    }
    std::stable_sort(passed.begin(), passed.end(),
                     [](const Passed& a, const Passed& b) { return a.distance < b.distance; });
    return passed;
}

}  // namespace wetdeck

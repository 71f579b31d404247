// SPDX-License-Identifier: BSD-3-Clause
#include "solver/neighbours/relative_motion.hpp"

#include <algorithm>
#include <cmath>

namespace wetdeck {
namespace {

/// How far a particle may move before blocks that do not touch count, in skins.
constexpr double moves_within_blocks = 1.5;

/// Square of the diagonal of the box around both.
double diagonal2(const Box& a, const Box& b) {
    return (a.high.cwiseMax(b.high) - a.low.cwiseMin(b.low)).squaredNorm();
}

bool empty(const Box& box) {
    return box.low.x() > box.high.x();
}

}  // namespace

RelativeMotion::RelativeMotion(const CellGrid& grid, double reach, double skin) : grid_(grid) {
    const double side = reach + (2 * moves_within_blocks - 1) * skin;
    block_strips_ = static_cast<std::uint32_t>(std::ceil(side / grid.cell_width));
    block_rows_ = static_cast<std::uint32_t>(std::ceil(side / grid.cell_height));
    columns_ = (grid.strips + block_strips_ - 1) / block_strips_;
    layers_ = (grid.rows + block_rows_ - 1) / block_rows_;
    spare_ = std::min(block_strips_ * grid.cell_width, block_rows_ * grid.cell_height) - reach;
    at_rest_.assign(std::size_t{columns_} * layers_, empty_box());
    moves_ = at_rest_;
}

double RelativeMotion::approach(int threads) const {
    double widest2 = 0, longest2 = 0;
    const auto columns = static_cast<std::int64_t>(columns_);
#pragma omp parallel for schedule(static) num_threads(threads) reduction(max : widest2, longest2)
    for (std::int64_t column = 0; column < columns; ++column) {
        const Box* here = moves_.data() + static_cast<std::size_t>(column) * layers_;
        const Box* right = column + 1 < columns ? here + layers_ : nullptr;
        for (std::uint32_t n = 0; n < layers_; ++n) {
            if (empty(here[n])) continue;
            const Vec2 corner = here[n].high.cwiseMax(-here[n].low);
            longest2 = std::max(longest2, corner.squaredNorm());
            // an empty box adds nothing to another
            widest2 = std::max(widest2, diagonal2(here[n], here[n]));
            if (n + 1 < layers_) widest2 = std::max(widest2, diagonal2(here[n], here[n + 1]));
            if (!right) continue;
            for (std::uint32_t m = n > 0 ? n - 1 : 0; m < std::min(n + 2, layers_); ++m)
                widest2 = std::max(widest2, diagonal2(here[n], right[m]));
        }
    }
    return std::max(std::sqrt(widest2), 2 * std::sqrt(longest2) - spare_);
}

}  // namespace wetdeck

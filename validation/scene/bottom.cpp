// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/bottom.hpp"

#include <algorithm>
#include <cmath>

#include "validation/scene/faces.hpp"

namespace wetdeck {
namespace {

/// Short sides that follow each other up, or down.
class Run {
  public:
    void add(const Vec2& from, const Vec2& to) {
        width_ += std::abs(to.x() - from.x());
        rise_ += to.y() - from.y();
        top_ = std::max({top_, from.y(), to.y()});
    }
    bool turns(double rise) const { return rise_ * rise < 0; }
    double width() const { return width_; }
    BottomSide side(double beam) const { return {std::atan2(std::abs(rise_), width_), width_ / beam, top_}; }

  private:
    double width_ = 0, rise_ = 0, top_ = -1e300;
};

bool counts(const BottomSide& side) {
    return side.share_of_beam >= least_share_of_beam;
}

}  // namespace

std::vector<BottomSide> bottom_sides(const Outline& outline) {
    const Box extent = extent_of(outline);
    const double beam = extent.high.x() - extent.low.x(), onwards = counter_clockwise(outline) ? 1 : -1;
    std::vector<BottomSide> sides;
    Run run;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 &from = outline[k], &to = outline[(k + 1) % outline.size()];
        const bool faces_down = onwards * (to.x() - from.x()) > 0;
        const bool alone = std::abs(to.x() - from.x()) >= least_share_of_beam * beam;
        if (!faces_down || alone || run.turns(to.y() - from.y())) run = {};
        if (!faces_down) continue;
        if (alone) {
            Run one;
            one.add(from, to);
            sides.push_back(one.side(beam));
            continue;
        }
        run.add(from, to);
        if (run.width() < least_share_of_beam * beam) continue;
        sides.push_back(run.side(beam));
        run = {};
    }
    return sides;
}

std::optional<double> flattest_deadrise(const Outline& outline) {
    std::optional<double> least;
    for (const BottomSide& side : bottom_sides(outline)) {
        const bool wedge = counts(side) && side.deadrise < steepest_deadrise_of_wedge &&
                           side.deadrise >= flattest_deadrise_of_wedge;
        if (wedge) least = std::min(least.value_or(steepest_deadrise_of_wedge), side.deadrise);
    }
    return least;
}

bool has_flat_bottom(const Outline& outline) {
    const std::vector<BottomSide> sides = bottom_sides(outline);
    return std::any_of(sides.begin(), sides.end(), [](const BottomSide& side) {
        return counts(side) && side.deadrise < flattest_deadrise_of_wedge;
    });
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/sections/joined_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wetdeck {
namespace {

/// The first or the last point of a piece.
struct End {
    std::size_t piece = 0;
    bool last = false;
    bool operator==(const End&) const = default;
};

Box box_of(const PlaneCurve& curve) {
    Box box{curve.points.front(), curve.points.front()};
    for (const Vec2& point : curve.points) {
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    }
    return box;
}

class Joiner {
  public:
    Joiner(const std::vector<PlaneCurve>& pieces, double room) : pieces_(pieces), room_(room) {}

    JoinedCurves join() {
        std::vector<bool> used(pieces_.size(), false);
        JoinedCurves all;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (used[k]) continue;
            if (pieces_[k].closed) {
                used[k] = true;
                all.curves.push_back({pieces_[k].points, true, {k}});
                continue;
            }
            End start{k, false};  // goes back to a free end, or once around
            while (const auto before = partner(start)) {
                start = {before->piece, !before->last};
                if (start.piece == k) break;
            }
            all.curves.push_back(follow(start, used, all.widest_gap));
        }
        return all;
    }

  private:
    Vec2 place(End end) const {
        const auto& points = pieces_[end.piece].points;
        return end.last ? points.back() : points.front();
    }

    /// The end that this one is joined to.
    std::optional<End> partner(End end) const {
        const std::optional<End> found = only_neighbour(end);
        return found && only_neighbour(*found) == end && !two_halves(end, *found) ? found : std::nullopt;
    }

    /// The one other end that lies here.
    std::optional<End> only_neighbour(End end) const {
        std::optional<End> found;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (pieces_[k].closed) continue;
            for (const bool last : {false, true}) {
                const End other{k, last};
                if (other == end || (place(other) - place(end)).norm() > room_) continue;
                if (found) return std::nullopt;
                found = other;
            }
        }
        return found;
    }

    bool two_halves(End a, End b) const {
        if (a.piece == b.piece || std::abs(place(a).x()) > room_) return false;
        const Box one = box_of(pieces_[a.piece]), other = box_of(pieces_[b.piece]);
        const auto at_port = [this](const Box& box) { return box.high.x() <= room_ && box.low.x() < -room_; };
        const auto at_starboard = [this](const Box& box) {
            return box.low.x() >= -room_ && box.high.x() > room_;
        };
        const bool apart = (at_port(one) && at_starboard(other)) || (at_port(other) && at_starboard(one));
        const double size = std::max((one.high - one.low).maxCoeff(), (other.high - other.low).maxCoeff());
        const auto differ = [size](double p, double q) { return std::abs(p - q) > 1e-3 * size; };
        return apart && (differ(one.high.x() - one.low.x(), other.high.x() - other.low.x()) ||
                         differ(one.high.y(), other.high.y()) || differ(one.low.y(), other.low.y()));
    }

    PlaneCurve follow(End start, std::vector<bool>& used, double& widest_gap) const {
        PlaneCurve curve;
        for (std::optional<End> at = start; at;) {
            used[at->piece] = true;
            curve.pieces.push_back(at->piece);
            std::vector<Vec2> points = pieces_[at->piece].points;
            if (at->last) std::reverse(points.begin(), points.end());
            const bool met = !curve.points.empty();
            if (met) widest_gap = std::max(widest_gap, (curve.points.back() - points.front()).norm());
            curve.points.insert(curve.points.end(), points.begin() + (met ? 1 : 0), points.end());
            at = partner({at->piece, !at->last});
            if (at && used[at->piece]) {
                curve.closed = true;
                widest_gap = std::max(widest_gap, (curve.points.back() - curve.points.front()).norm());
                curve.points.pop_back();
                break;
            }
        }
        return curve;
    }

    const std::vector<PlaneCurve>& pieces_;
    double room_;
};

}  // namespace

JoinedCurves joined(const std::vector<PlaneCurve>& pieces, double room) {
    return Joiner(pieces, room).join();
}

}  // namespace wetdeck

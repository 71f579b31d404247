// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/rotating_patch.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace wetdeck::verification {
namespace {

using Corners = std::array<int, 4>;  // counterclockwise

double cell_area(const Eigen::VectorXd& values, const Corners& c) {
    const double ax = values[2 * c[2]] - values[2 * c[0]], ay = values[2 * c[2] + 1] - values[2 * c[0] + 1];
    const double bx = values[2 * c[3]] - values[2 * c[1]], by = values[2 * c[3] + 1] - values[2 * c[1] + 1];
    return 0.5 * (ax * by - ay * bx);
}

}  // namespace

template <class Visit>
void RotatingPatch::each_cell(Visit visit) const {
    for (int column = 0; column < cells_; ++column) {
        for (int row = 0; row < cells_; ++row) {
            visit(column * cells_ + row, Corners{node(column, row), node(column + 1, row),
                                                 node(column + 1, row + 1), node(column, row + 1)});
        }
    }
}

RotatingPatch::RotatingPatch(double side, double rotation, int cells) : side_(side), cells_(cells) {
    const int nodes = (cells + 1) * (cells + 1);
    mass_ = Vector::Zero(2 * nodes);
    place_.resize(2 * nodes);
    velocity_.resize(2 * nodes);
    for (int column = 0; column <= cells; ++column) {
        for (int row = 0; row <= cells; ++row) {
            const int n = node(column, row);
            place_[2 * n] = side * (static_cast<double>(column) / cells - 0.5);
            place_[2 * n + 1] = side * (static_cast<double>(row) / cells - 0.5);
            velocity_[2 * n] = -rotation * place_[2 * n + 1];
            velocity_[2 * n + 1] = rotation * place_[2 * n];
        }
    }
    each_cell([&](int, const Corners& corners) {
        for (const int n : corners) {
            mass_[2 * n] += 0.25 * side * side / (cells * cells);
            mass_[2 * n + 1] = mass_[2 * n];
        }
    });
}

/// Areas are bilinear in the positions: area'' = 2 area(velocity) + slope . acceleration = 0, and the
/// accelerations are slopes times pressures over masses.
RotatingPatch::Vector RotatingPatch::accelerations(const Vector& position, const Vector& velocity) const {
    const int count = cells_ * cells_;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(count) * 8);
    Vector growth(count);
    each_cell([&](int cell, const Corners& c) {
        growth[cell] = -2 * cell_area(velocity, c);
        for (int k = 0; k < 4; ++k) {
            const int here = c[static_cast<std::size_t>(k)], next = c[static_cast<std::size_t>((k + 1) % 4)],
                      before = c[static_cast<std::size_t>((k + 3) % 4)];
            entries.emplace_back(cell, 2 * here, 0.5 * (position[2 * next + 1] - position[2 * before + 1]));
            entries.emplace_back(cell, 2 * here + 1, -0.5 * (position[2 * next] - position[2 * before]));
        }
    });
    Eigen::SparseMatrix<double> slope(count, position.size());
    slope.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> transposed = slope.transpose();
    const Vector mobility = mass_.cwiseInverse();
    const Eigen::SparseMatrix<double> matrix = slope * mobility.asDiagonal() * transposed;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    return mobility.cwiseProduct(transposed * solver.solve(growth));
}

void RotatingPatch::advance(double duration, int steps) {
    const double dt = duration / steps;
    for (int k = 0; k < steps; ++k) {
        const Vector v1 = velocity_, a1 = accelerations(place_, v1);
        const Vector v2 = velocity_ + 0.5 * dt * a1, a2 = accelerations(place_ + 0.5 * dt * v1, v2);
        const Vector v3 = velocity_ + 0.5 * dt * a2, a3 = accelerations(place_ + 0.5 * dt * v2, v3);
        const Vector v4 = velocity_ + dt * a3, a4 = accelerations(place_ + dt * v3, v4);
        place_ += dt / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        velocity_ += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
}

Vec2 RotatingPatch::place_of(Vec2 start) const {
    const Vec2 share = (start / side_ + Vec2(0.5, 0.5)) * cells_;
    const int column = std::clamp(static_cast<int>(share.x()), 0, cells_ - 1);
    const int row = std::clamp(static_cast<int>(share.y()), 0, cells_ - 1);
    const double s = share.x() - column, t = share.y() - row;
    const auto at = [&](int n) { return Vec2(place_[2 * n], place_[2 * n + 1]); };
    return (1 - s) * ((1 - t) * at(node(column, row)) + t * at(node(column, row + 1))) +
           s * ((1 - t) * at(node(column + 1, row)) + t * at(node(column + 1, row + 1)));
}

double RotatingPatch::largest_area_error() const {
    double largest = 0;
    each_cell([&](int, const Corners& corners) {
        const double relative = cell_area(place_, corners) / (side_ * side_ / (cells_ * cells_)) - 1;
        largest = std::max(largest, std::abs(relative));
    });
    return largest;
}

}  // namespace wetdeck::verification

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/plane_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "solver/core/cross.hpp"
#include "validation/openfoam/foam_text.hpp"

namespace wetdeck {
namespace {

using Polygon = std::vector<Vec2>;

double area_of(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
    return 0.5 * twice;
}

/// The part of a polygon where `inside`, a linear function, is not negative.
template <class Inside>
Polygon clipped(const Polygon& polygon, Inside inside) {
    Polygon part;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0) part.push_back(a);
        if ((at_a < 0) != (at_b < 0)) part.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    return part;
}

double area_in(const Polygon& polygon, const Box& box) {
    Polygon part = clipped(polygon, [&](Vec2 p) { return p.x() - box.low.x(); });
    part = clipped(part, [&](Vec2 p) { return box.high.x() - p.x(); });
    part = clipped(part, [&](Vec2 p) { return p.y() - box.low.y(); });
    part = clipped(part, [&](Vec2 p) { return box.high.y() - p.y(); });
    return part.size() < 3 ? 0 : area_of(part);
}

/// A face between two cells, or of one cell and the boundary.
struct Face {
    std::size_t a, b, owner, neighbour;
};

/// Inner sides, in the order that OpenFOAM asks for: by owner, then by neighbour.
std::vector<Face> inner_faces(const PlaneMesh& mesh) {
    std::map<std::pair<std::size_t, std::size_t>, Face> sides;  // by points, the smaller one first
    std::vector<Face> inner;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t a = mesh.cells[c][k], b = mesh.cells[c][(k + 1) % 4];
            const auto [found, is_new] = sides.emplace(std::minmax(a, b), Face{a, b, c, c});
            if (!is_new) inner.push_back({found->second.a, found->second.b, found->second.owner, c});
        }
    std::sort(inner.begin(), inner.end(), [](const Face& x, const Face& y) {
        return std::pair(x.owner, x.neighbour) < std::pair(y.owner, y.neighbour);
    });
    return inner;
}

std::string file_of(const std::string& kind, const std::string& name, std::size_t count,
                    const std::string& list) {
    return foam_head(kind, name) + fmt::format("{}\n(\n{})\n", count, list);
}

}  // namespace

std::array<Vec2, 4> PlaneMesh::corners(std::size_t cell) const {
    const auto& c = cells[cell];
    return {points[c[0]], points[c[1]], points[c[2]], points[c[3]]};
}

double PlaneMesh::area(std::size_t cell) const {
    const auto c = corners(cell);
    return area_of({c.begin(), c.end()});
}

Vec2 PlaneMesh::centre(std::size_t cell) const {
    const auto c = corners(cell);
    Vec2 sum = Vec2::Zero();
    double weight = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        const double area = cross(c[k] - c[0], c[k + 1] - c[0]);
        sum += area * (c[0] + c[k] + c[k + 1]) / 3;
        weight += area;
    }
    return sum / weight;
}

PlaneMesh mesh_of(const MeshGrid& grid) {
    const std::size_t columns = grid.u.size() - 1, rows = grid.v.size() - 1;
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    const auto middle = [&](std::size_t i, std::size_t j) {
        return Vec2(0.5 * (grid.u[i] + grid.u[i + 1]), 0.5 * (grid.v[j] + grid.v[j + 1]));
    };
    const auto filled = [&](std::size_t i, std::size_t j) {  // none wraps around to beyond the end
        return i < columns && j < rows && !(grid.hole && grid.hole(middle(i, j)));
    };
    PlaneMesh mesh;
    std::vector<std::size_t> number((columns + 1) * (rows + 1), none);
    const auto point = [&](std::size_t i, std::size_t j) {
        std::size_t& found = number[j * (columns + 1) + i];
        if (found == none) {
            found = mesh.points.size();
            mesh.points.push_back(grid.place({grid.u[i], grid.v[j]}));
        }
        return found;
    };
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            if (!filled(i, j)) continue;
            const std::size_t cell = mesh.cells.size();
            const std::array<std::pair<std::size_t, std::size_t>, 4> at{
                {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
            const std::array<std::pair<std::size_t, std::size_t>, 4> beyond{
                {{i, j - 1}, {i + 1, j}, {i, j + 1}, {i - 1, j}}};
            std::array<std::size_t, 4> corners{};
            for (std::size_t k = 0; k < 4; ++k) corners[k] = point(at[k].first, at[k].second);
            for (std::size_t k = 0; k < 4; ++k) {
                if (filled(beyond[k].first, beyond[k].second)) continue;
                const auto [ia, ja] = at[k];
                const auto [ib, jb] = at[(k + 1) % 4];
                const Vec2 side(0.5 * (grid.u[ia] + grid.u[ib]), 0.5 * (grid.v[ja] + grid.v[jb]));
                mesh.boundary.push_back({corners[k], corners[(k + 1) % 4], cell, grid.patch(side)});
            }
            mesh.cells.push_back(corners);
        }
    return mesh;
}

std::vector<double> graded_lines(double begin, double end, double first, double growth, double largest) {
    const double length = std::abs(end - begin);
    std::vector<double> at{0};
    for (double step = std::min(first, largest); at.back() < length - 0.5 * step;
         step = std::min(step * growth, largest))
        at.push_back(at.back() + step);
    if (at.size() < 2) at.push_back(length);
    const double stretch = length / at.back();
    for (double& x : at) x = begin + (end > begin ? 1 : -1) * stretch * x;
    at.back() = end;
    if (end < begin) std::reverse(at.begin(), at.end());
    return at;
}

std::vector<double> even_lines(double begin, double end, double distance) {
    const auto count = static_cast<std::size_t>(std::max(1.0, std::round((end - begin) / distance)));
    std::vector<double> at;
    for (std::size_t k = 0; k <= count; ++k)
        at.push_back(begin + (end - begin) * static_cast<double>(k) / static_cast<double>(count));
    return at;
}

std::vector<double> joined_lines(std::vector<double> a, const std::vector<double>& b) {
    a.insert(a.end(), b.begin() + 1, b.end());
    return a;
}

std::vector<double> shares_in(const PlaneMesh& mesh, const std::vector<Box>& boxes) {
    std::vector<double> shares;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        const auto corners = mesh.corners(c);
        const Polygon polygon(corners.begin(), corners.end());
        double area = 0;
        for (const Box& box : boxes) area += area_in(polygon, box);
        const double share = area / area_of(polygon);
        shares.push_back(share < 1e-9 ? 0 : share > 1 - 1e-9 ? 1 : share);
    }
    return shares;
}

double slant(const PlaneMesh& mesh, std::size_t cell) {
    const auto c = mesh.corners(cell);
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 along = c[(k + 1) % 4] - c[k];
        const double length = along.norm();
        xx += along.y() * along.y() / length;
        yy += along.x() * along.x() / length;
        xy -= along.x() * along.y() / length;
    }
    return 2 * std::abs(xy) / (xx + yy);
}

std::map<std::string, std::string> poly_mesh_files(const PlaneMesh& mesh, double thickness,
                                                   const std::map<std::string, std::string>& types) {
    const std::size_t n = mesh.points.size();
    std::string points, faces, owner, neighbour, boundary;
    for (const double z : {0.0, thickness})
        for (const Vec2& p : mesh.points) points += foam_vector(p, z) + "\n";
    std::size_t count = 0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t cell) {
        faces += fmt::format("4({} {} {} {})\n", a, b, b + n, a + n);
        owner += fmt::format("{}\n", cell);
        ++count;
    };
    for (const Face& face : inner_faces(mesh)) {
        add(face.a, face.b, face.owner);
        neighbour += fmt::format("{}\n", face.neighbour);
    }
    const std::size_t inner = count;
    std::map<std::string, std::vector<const PlaneMesh::Side*>> patches;
    for (const PlaneMesh::Side& side : mesh.boundary) patches[side.patch].push_back(&side);
    for (const auto& [name, sides] : patches) {
        boundary += fmt::format("{} {{ type {}; nFaces {}; startFace {}; }}\n", name, types.at(name),
                                sides.size(), count);
        for (const PlaneMesh::Side* side : sides) add(side->a, side->b, side->cell);
    }
    boundary += fmt::format("sides {{ type empty; inGroups 1(empty); nFaces {}; startFace {}; }}\n",
                            2 * mesh.cells.size(), count);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        const auto& k = mesh.cells[c];
        faces += fmt::format("4({} {} {} {})\n4({} {} {} {})\n", k[3], k[2], k[1], k[0], k[0] + n, k[1] + n,
                             k[2] + n, k[3] + n);
        owner += fmt::format("{}\n{}\n", c, c);
        count += 2;
    }
    return {{"points", file_of("vectorField", "points", 2 * n, points)},
            {"faces", file_of("faceList", "faces", count, faces)},
            {"owner", file_of("labelList", "owner", count, owner)},
            {"neighbour", file_of("labelList", "neighbour", inner, neighbour)},
            {"boundary", file_of("polyBoundaryMesh", "boundary", patches.size() + 1, boundary)}};
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/plane_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "validation/import/openfoam_files.hpp"
#include "validation/openfoam/shapes.hpp"

using namespace wetdeck;

namespace {

double area_of(const PlaneMesh& mesh) {
    double sum = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) sum += mesh.area(c);
    return sum;
}

double worst_slant(const PlaneMesh& mesh) {
    double worst = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) worst = std::max(worst, slant(mesh, c));
    return worst;
}

double length_of(const PlaneMesh& mesh, const std::string& patch) {
    double sum = 0;
    for (const PlaneMesh::Side& side : mesh.boundary)
        if (side.patch == patch) sum += (mesh.points[side.b] - mesh.points[side.a]).norm();
    return sum;
}

constexpr double degree = std::numbers::pi / 180;

}  // namespace

TEST_CASE("A tank fills its box with even cells, anticlockwise, in one patch") {
    const PlaneMesh mesh = tank_mesh({{1, 2}, {3, 3}}, 0.1);
    CHECK(mesh.cells.size() == 200);
    CHECK(area_of(mesh) == Approx(2));
    CHECK(length_of(mesh, "walls") == Approx(6));
    CHECK(worst_slant(mesh) == 0);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) CHECK(mesh.area(c) > 0);
}

TEST_CASE("The mesh of a plate leaves the plate out, with flat cells below it") {
    const PlateShape shape{{{0, 0}, {1.2, 0.7}}, {{0.475, 0.42}, {0.725, 0.44}}, 0.01};
    const PlaneMesh mesh = plate_mesh(shape);
    CHECK(area_of(mesh) == Approx(0.6 * 0.7 - 0.125 * 0.02));
    CHECK(length_of(mesh, "body") == Approx(0.125 + 0.02 + 0.125));
    CHECK(length_of(mesh, "symmetry") == Approx(0.7 - 0.02));
    CHECK(length_of(mesh, "inflow") == Approx(0.6));
    CHECK(length_of(mesh, "atmosphere") == Approx(0.6));
    CHECK(length_of(mesh, "walls") == Approx(0.7));
    CHECK(worst_slant(mesh) == 0);
    double lowest = 1;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        const auto corners = mesh.corners(c);
        if (std::abs(corners[2].y() - 0.42) < 1e-9)
            lowest = std::min(lowest, corners[2].y() - corners[1].y());
    }
    CHECK(lowest == Approx(film_cell(0.01)).epsilon(0.02));
}

TEST_CASE("The mesh of a wedge follows its side and the axis with locally square cells") {
    for (const double deadrise : {10 * degree, 30 * degree, 45 * degree}) {
        const WedgeShape shape{{2.3, 2.22}, deadrise, 0.3, 2, std::sin(deadrise), 0.02};
        const PlaneMesh mesh = wedge_mesh(shape);
        for (const PlaneMesh::Side& side : mesh.boundary) {
            const Vec2 from_keel = mesh.points[side.b] - shape.keel;
            if (side.patch == "body" && from_keel.norm() > 1e-9)
                CHECK(std::atan2(from_keel.y(), from_keel.x()) == Approx(deadrise));
            if (side.patch == "symmetry") CHECK(from_keel.x() == Approx(0).margin(1e-9));
        }
        CHECK(length_of(mesh, "body") == Approx(2));
        CHECK(length_of(mesh, "symmetry") == Approx(2));
        CHECK(length_of(mesh, "atmosphere") > 0);
        CHECK(worst_slant(mesh) < 0.1);
        std::size_t near = 0;
        double size = 0;
        for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
            CHECK(mesh.area(c) > 0);
            const Vec2 at = mesh.centre(c) - shape.keel;
            if (std::abs(at.norm() - 0.3) > 0.02 || at.y() < 0) continue;
            ++near;
            size += std::sqrt(mesh.area(c));
        }
        CHECK(size / static_cast<double>(near) == Approx(0.02).epsilon(0.05));
    }
}

TEST_CASE("Shares of water are exact areas, in cells along the axes and in slanted ones") {
    const std::vector<Box> water{{{0, 0}, {0.33, 0.57}}, {{0.9, 0}, {1, 0.1}}};
    for (const double shear : {0.0, 0.4}) {
        MeshGrid grid;
        grid.u = even_lines(-1, 2, 0.1);
        grid.v = even_lines(-1, 2, 0.1);
        grid.place = [shear](Vec2 p) { return Vec2(p.x() + shear * p.y(), p.y()); };
        grid.patch = [](Vec2) { return "walls"; };
        const PlaneMesh mesh = mesh_of(grid);
        const std::vector<double> shares = shares_in(mesh, water);
        double sum = 0;
        for (std::size_t c = 0; c < shares.size(); ++c) sum += shares[c] * mesh.area(c);
        CHECK(sum == Approx(0.33 * 0.57 + 0.01));
        CHECK((worst_slant(mesh) > 0.1) == (shear > 0));
    }
}

TEST_CASE("Graded lines end where they should and grow away from the beginning") {
    for (const auto& [begin, end] : {std::pair(0.0, 1.0), std::pair(1.0, 0.0)}) {
        const std::vector<double> lines = graded_lines(begin, end, 0.01, 1.2, 0.1);
        CHECK(lines.front() == Approx(0).margin(1e-12));
        CHECK(lines.back() == Approx(1));
        const double first = lines[1] - lines[0], last = lines.back() - lines[lines.size() - 2];
        CHECK((first < last) == (begin < end));
        CHECK(std::min(first, last) == Approx(0.01).epsilon(0.15));
    }
}

TEST_CASE(
    "Faces: inner ones rise by owner and neighbour, each is counted once, the layer is that asked for") {
    const auto files = poly_mesh_files(tank_mesh({{0, 0}, {0.3, 0.2}}, 0.1), 0.5, {{"walls", "wall"}});
    const auto numbers = [&](const std::string& name) {
        std::vector<std::size_t> all;
        std::istringstream text(files.at(name).substr(files.at(name).find("\n(\n") + 3));
        for (std::size_t n = 0; text >> n;) all.push_back(n);
        return all;
    };
    const std::vector<std::size_t> owner = numbers("owner"), neighbour = numbers("neighbour");
    CHECK(owner.size() == 7 + 10 + 2 * 6);
    REQUIRE(neighbour.size() == 7);
    for (std::size_t k = 0; k < 7; ++k) {
        CHECK(owner[k] < neighbour[k]);
        if (k > 0) CHECK(std::pair(owner[k - 1], neighbour[k - 1]) < std::pair(owner[k], neighbour[k]));
    }
    CHECK(layer_of_points(files.at("points")) == 0.5);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/section_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"
#include "validation/openfoam/cell_finder.hpp"
#include "validation/openfoam/shapes.hpp"
#include "validation/store/child_process.hpp"

using namespace wetdeck;
using Catch::Matchers::Contains;

namespace {

/// Two squares side by side, the second one clockwise; a node that no cell has.
const char* const two_squares =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"body\"\n1 2 \"walls\"\n2 3 \"fluid\"\n"
    "$EndPhysicalNames\n$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n7 9 9 0\n$EndNodes\n"
    "$Elements\n8\n1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n3 1 2 2 2 3 6\n4 1 2 2 2 6 5\n5 1 2 2 2 5 4\n6 1 2 2 2 4 1\n"
    "7 3 2 3 1 1 2 5 4\n8 3 2 3 1 2 5 6 3\n$EndElements\n";

std::string with(std::string text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), now);
}

std::string refusal(const std::string& text) {
    try {
        mesh_of_gmsh(text, {"body", "walls"});
    } catch (const DataError& error) {
        return error.what();
    }
    return "none";
}

std::vector<Vec2> circle(std::size_t pieces, double radius) {
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < pieces; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(pieces);
        points.push_back({1 + radius * std::sin(angle), 1 - radius * std::cos(angle)});
    }
    return points;
}

}  // namespace

TEST_CASE("A mesh of gmsh: cells anticlockwise, sides by the names of their lines, no stray points") {
    const PlaneMesh mesh = mesh_of_gmsh(two_squares, {"body", "walls"});
    REQUIRE(mesh.cells.size() == 2);
    CHECK(mesh.points.size() == 6);
    for (std::size_t c = 0; c < 2; ++c) CHECK(mesh.area(c) == Approx(1));
    CHECK(mesh.boundary.size() == 6);
    double body = 0;
    for (const PlaneMesh::Side& side : mesh.boundary) {
        const Vec2 along = mesh.points[side.b] - mesh.points[side.a];
        if (side.patch == "body") body += along.x();  // the fluid lies to the left
    }
    CHECK(body == Approx(2));
}

TEST_CASE("A mesh of gmsh that is not what a case needs is refused with numbers") {
    CHECK(refusal(two_squares) == "none");
    CHECK_THAT(refusal(with(two_squares, "8 3 2 3 1 2 5 6 3", "8 2 2 3 1 2 5 6")),
               Contains("1 triangles beside 1 cells"));
    CHECK_THAT(refusal(with(two_squares, "3 1 2 2 2 3 6", "3 1 2 2 2 1 6")),
               Contains("1 of 6 sides on the boundary belong to no patch"));
    CHECK_THAT(refusal(with(two_squares, "\"walls\"", "\"others\"")), Contains("no patch walls"));
    CHECK_THAT(refusal(with(two_squares, "6 2 1 0", "6 1.2 0.1 0")), Contains("1 of 2 cells are not convex"));
    CHECK_THAT(refusal(with(two_squares, "2.2 0 8", "4.1 0 8")), Contains("expected version 2.2"));
    CHECK_THAT(refusal(with(two_squares, "1 2 5 6 3", "1 2 5 6 8")), Contains("unknown node"));
    CHECK_THAT(refusal(std::string(two_squares).substr(0, 150)), Contains("expected"));
    CHECK_THAT(refusal(""), Contains("no cells"));
}

TEST_CASE("A mesh keeps the corners of a section and every second or so of a curve's, the lowest one first") {
    const std::vector<Vec2> wedge{{2, 0}, {2.25, 0.14}, {1.75, 0.14}};
    CHECK(meshed_corners(wedge, 0.5).size() == 3);
    const std::vector<Vec2> round = meshed_corners(circle(96, 0.055), 0.0025);
    CHECK(round.size() < 96);
    CHECK(round.size() > 40);
    CHECK(round.front().y() == Approx(0.945));
    for (std::size_t k = 0; k < round.size(); ++k)
        CHECK((round[(k + 1) % round.size()] - round[k]).norm() > 0.00374);
    CHECK(meshed_corners(circle(24, 0.055), 0.0025).size() == 24);
}

TEST_CASE("gmsh fills a tank around a section with four-cornered cells of the wanted size") {
    if (!program_found("gmsh")) {
        WARN("not tested: gmsh is not installed");
        return;
    }
    const SectionShape shape{{{0, 0}, {2, 2}}, circle(96, 0.2), {{0.7, 0.7}, {1.3, 1.3}}, 0.02};
    const PlaneMesh mesh = section_mesh(shape);
    double area = 0, near = 0;
    std::size_t count = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        CHECK(mesh.area(c) > 0);
        area += mesh.area(c);
        const Vec2 from_middle = (mesh.centre(c) - Vec2(1, 1)).cwiseAbs();
        if (from_middle.maxCoeff() > 0.28) continue;
        near += mesh.area(c);
        ++count;
    }
    CHECK(area == Approx(4 - std::numbers::pi * 0.04).epsilon(1e-3));
    CHECK(std::sqrt(near / static_cast<double>(count)) == Approx(0.02).epsilon(0.2));
    double body = 0;
    for (const PlaneMesh::Side& side : mesh.boundary)
        if (side.patch == "body") body += (mesh.points[side.b] - mesh.points[side.a]).norm();
    CHECK(body == Approx(2 * std::numbers::pi * 0.2).epsilon(1e-2));
}

TEST_CASE("The cell that holds a point, and the cells along a ray, around a hole") {
    const PlaneMesh mesh = plate_mesh({{{0, 0}, {1.2, 0.7}}, {{0.475, 0.42}, {0.725, 0.44}}, 0.01});
    const CellFinder finder(mesh);
    for (std::size_t c = 0; c < mesh.cells.size(); c += 7) CHECK(finder.at(mesh.centre(c)) == c);
    CHECK_FALSE(finder.at({0.65, 0.43}));  // in the plate
    CHECK_FALSE(finder.at({0.3, 0.3}));    // the half that is left out
    CHECK_FALSE(finder.at({5, 5}));
    const auto ray = finder.along({0.653, 0.7}, {0, -1}, 0.7, 0.0002);
    REQUIRE(ray.size() > 20);
    double height = 0;
    for (std::size_t k = 0; k < ray.size(); ++k) {
        const auto corners = mesh.corners(ray[k].cell);
        height += corners[2].y() - corners[1].y();
        if (k > 0) CHECK(ray[k].distance > ray[k - 1].distance);
    }
    CHECK(height == Approx(0.68));
}

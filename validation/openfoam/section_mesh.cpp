// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/section_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "solver/core/cross.hpp"
#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/child_process.hpp"
#include "validation/store/temporary_folder.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

constexpr double smooth_turn = std::numbers::pi / 18;  // between two sides of one curve
constexpr double side_in_cells = 1.5;                  // shortest side of a curve: it becomes two cells
constexpr double shrunk = 0.88;                        // size of the cells over that asked of gmsh
constexpr double growth = 0.12;                        // of the size of cells over the distance
constexpr double coarsest = 6;                         // far cells over those at the section
constexpr int limit = 300;                             // of gmsh's wall time [s]

/// Type numbers of gmsh's elements.
enum ElementType { line = 1, triangle = 2, quadrangle = 3 };

double turn_at(const std::vector<Vec2>& outline, std::size_t k) {
    const std::size_t n = outline.size();
    const Vec2 before = outline[k] - outline[(k + n - 1) % n], after = outline[(k + 1) % n] - outline[k];
    return std::abs(std::atan2(cross(before, after), before.dot(after)));
}

/// A mesh file as it is read.
struct GmshText {
    std::map<std::size_t, std::string> names;  ///< of groups
    std::map<std::size_t, Vec2> nodes;
    std::vector<std::array<std::size_t, 4>> cells;                     ///< of nodes
    std::map<std::pair<std::size_t, std::size_t>, std::string> sides;  ///< patch by nodes, smaller first
    std::size_t triangles = 0;
};

/// Numbers of a line, which must be as many at least.
std::vector<double> numbers_of(TextLines& lines, std::size_t least) {
    if (!lines.next()) lines.fail("the file ends early");
    std::vector<double> numbers;
    for (const std::string_view cell : cells_of(lines.line(), ' '))
        if (const auto number = number_in(cell)) numbers.push_back(*number);
    if (numbers.size() < least)
        lines.fail(fmt::format("expected {} numbers, found {}", least, numbers.size()));
    return numbers;
}

std::size_t count_of(TextLines& lines) {
    return static_cast<std::size_t>(numbers_of(lines, 1).front());
}

void read_element(const std::vector<double>& numbers, GmshText& read, const TextLines& lines) {
    const auto at = [&](std::size_t k) { return static_cast<std::size_t>(numbers[k]); };
    const std::size_t type = at(1), first = 3 + at(2);
    if (type != line && type != triangle && type != quadrangle) return;
    if (numbers.size() < first + type + 1 || at(2) < 1) lines.fail("an element lacks nodes or its group");
    if (type == triangle) ++read.triangles;
    if (type == quadrangle) read.cells.push_back({at(first), at(first + 1), at(first + 2), at(first + 3)});
    if (type == line) read.sides[std::minmax(at(first), at(first + 1))] = read.names[at(3)];
}

GmshText read_gmsh(const std::string& text) {
    TextLines lines("mesh of gmsh", text);
    GmshText read;
    while (lines.next()) {
        if (lines.line() == "$MeshFormat") {
            if (const auto format = numbers_of(lines, 2); format[0] != 2.2 || format[1] != 0)
                lines.fail("expected version 2.2 as text");
        } else if (lines.line() == "$PhysicalNames") {
            for (std::size_t k = count_of(lines); k-- > 0;) {
                const auto numbers = numbers_of(lines, 2);
                const std::size_t open = lines.line().find('"'), close = lines.line().rfind('"');
                if (open >= close) lines.fail("expected a name in quotes");
                read.names[static_cast<std::size_t>(numbers[1])] =
                    lines.line().substr(open + 1, close - open - 1);
            }
        } else if (lines.line() == "$Nodes") {
            for (std::size_t k = count_of(lines); k-- > 0;) {
                const auto numbers = numbers_of(lines, 4);
                read.nodes[static_cast<std::size_t>(numbers[0])] = {numbers[1], numbers[2]};
            }
        } else if (lines.line() == "$Elements") {
            for (std::size_t k = count_of(lines); k-- > 0;) read_element(numbers_of(lines, 3), read, lines);
        }
    }
    return read;
}

bool is_convex(const std::array<Vec2, 4>& c) {
    for (std::size_t k = 0; k < 4; ++k)
        if (cross(c[(k + 1) % 4] - c[k], c[(k + 2) % 4] - c[(k + 1) % 4]) <= 0) return false;
    return true;
}

/// Cells anticlockwise, ordered from left to right so that neighbours have near numbers; nodes that no cell
/// has are left out.
PlaneMesh cells_of_mesh(const GmshText& read, std::vector<std::size_t>& node_of_point) {
    std::vector<std::pair<double, std::array<std::size_t, 4>>> cells;
    for (std::array<std::size_t, 4> nodes : read.cells) {
        std::array<Vec2, 4> c;
        double x = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto found = read.nodes.find(nodes[k]);
            if (found == read.nodes.end()) throw DataError("mesh of gmsh: a cell has an unknown node");
            c[k] = found->second;
            x += c[k].x();
        }
        if (cross(c[2] - c[0], c[3] - c[1]) < 0) std::swap(nodes[1], nodes[3]);
        cells.emplace_back(x, nodes);
    }
    std::stable_sort(cells.begin(), cells.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    PlaneMesh mesh;
    std::map<std::size_t, std::size_t> points;
    for (const auto& [x, nodes] : cells) {
        std::array<std::size_t, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto [found, is_new] = points.emplace(nodes[k], mesh.points.size());
            if (is_new) {
                mesh.points.push_back(read.nodes.at(nodes[k]));
                node_of_point.push_back(nodes[k]);
            }
            corners[k] = found->second;
        }
        mesh.cells.push_back(corners);
    }
    return mesh;
}

}  // namespace

std::vector<Vec2> meshed_corners(const std::vector<Vec2>& outline, double cell) {
    const std::size_t n = outline.size();
    std::size_t first = 0;  // a sharp corner, or the lowest: the instant of contact depends on it
    for (std::size_t k = 0; k < n; ++k)
        if (outline[k].y() < outline[first].y()) first = k;
    std::vector<Vec2> kept{outline[first]};
    for (std::size_t i = 1; i < n; ++i) {
        const std::size_t k = (first + i) % n;
        const double shortest = side_in_cells * cell * (1 - 1e-9);
        const bool far =
            (outline[k] - kept.back()).norm() >= shortest && (outline[k] - outline[first]).norm() >= shortest;
        if (far || turn_at(outline, k) >= smooth_turn) kept.push_back(outline[k]);
    }
    return kept;
}

std::string section_geometry(const SectionShape& shape) {
    const Box& tank = shape.tank;
    std::string text =
        "// The section in its tank, for gmsh: gmsh -2 -format msh22 -o section.msh section.geo\n";
    std::vector<Vec2> points{
        tank.low, {tank.high.x(), tank.low.y()}, tank.high, {tank.low.x(), tank.high.y()}};
    const std::vector<Vec2> corners = meshed_corners(shape.outline, shape.cell);
    points.insert(points.end(), corners.begin(), corners.end());
    for (std::size_t k = 0; k < points.size(); ++k)
        text += fmt::format("Point({}) = {{{:.15g}, {:.15g}, 0}};\n", k + 1, points[k].x(), points[k].y());
    const std::size_t last = points.size();
    const auto loop = [&](int number, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k <= end; ++k)
            text += fmt::format("Line({}) = {{{}, {}}};\n", k, k, k == end ? begin : k + 1);
        text += fmt::format("Curve Loop({}) = {{{}:{}}};\n", number, begin, end);
    };
    loop(1, 1, 4);
    loop(2, 5, last);
    text += fmt::format(
        "Plane Surface(1) = {{1, 2}};\nPhysical Curve(\"inflow\") = {{1}};\nPhysical Curve(\"walls\") = {{2, "
        "4}};\nPhysical Curve(\"atmosphere\") = {{3}};\nPhysical Curve(\"body\") = {{5:{}}};\nPhysical "
        "Surface(\"fluid\") = {{1}};\n",
        last);
    const Box& fine = shape.fine;
    text += fmt::format(
        "Field[1] = Box;\nField[1].VIn = {:.9g};\nField[1].VOut = {:.9g};\nField[1].XMin = {:.9g};\n"
        "Field[1].XMax = {:.9g};\nField[1].YMin = {:.9g};\nField[1].YMax = {:.9g};\nField[1].Thickness = "
        "{:.9g};\nBackground Field = 1;\n",
        shape.cell / shrunk, coarsest * shape.cell / shrunk, fine.low.x(), fine.high.x(), fine.low.y(),
        fine.high.y(), (coarsest - 1) * shape.cell / growth);
    // Recombination 2 cuts what is left in four-cornered cells: no triangles stay.
    return text +
           "Mesh.MeshSizeExtendFromBoundary = 0;\nMesh.MeshSizeFromPoints = 0;\nMesh.Algorithm = 6;\n"
           "Mesh.RecombineAll = 1;\nMesh.RecombinationAlgorithm = 2;\n";
}

PlaneMesh mesh_of_gmsh(const std::string& text, const std::vector<std::string>& patches) {
    const GmshText read = read_gmsh(text);
    if (read.triangles > 0)
        throw DataError(
            fmt::format("mesh of gmsh: {} triangles beside {} cells with four corners, expected none",
                        read.triangles, read.cells.size()));
    if (read.cells.empty()) throw DataError("mesh of gmsh: no cells, expected a named surface");
    std::vector<std::size_t> node_of_point;
    PlaneMesh mesh = cells_of_mesh(read, node_of_point);
    std::map<std::pair<std::size_t, std::size_t>, PlaneMesh::Side> once;
    std::size_t crooked = 0, nameless = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        if (!is_convex(mesh.corners(c))) ++crooked;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t a = mesh.cells[c][k], b = mesh.cells[c][(k + 1) % 4];
            const auto [found, is_new] = once.emplace(std::minmax(a, b), PlaneMesh::Side{a, b, c, ""});
            if (!is_new) once.erase(found);
        }
    }
    std::set<std::string> present;
    for (auto& [points, side] : once) {
        const auto found = read.sides.find(std::minmax(node_of_point[side.a], node_of_point[side.b]));
        if (found == read.sides.end() || found->second.empty()) {
            ++nameless;
            continue;
        }
        side.patch = found->second;
        present.insert(side.patch);
        mesh.boundary.push_back(side);
    }
    if (crooked > 0)
        throw DataError(
            fmt::format("mesh of gmsh: {} of {} cells are not convex", crooked, mesh.cells.size()));
    if (nameless > 0)
        throw DataError(fmt::format("mesh of gmsh: {} of {} sides on the boundary belong to no patch",
                                    nameless, once.size()));
    for (const std::string& patch : patches)
        if (present.count(patch) == 0) throw DataError(fmt::format("mesh of gmsh: no patch {}", patch));
    return mesh;
}

PlaneMesh section_mesh(const SectionShape& shape) {
    if (!program_found("gmsh"))
        throw EnvironmentError(
            "gmsh was not found: it makes the mesh of a section that is neither a plate nor an upright wedge "
            "(Debian: apt install gmsh)");
    const TemporaryFolder folder;
    atomic_write(folder.path() / "section.geo", section_geometry(shape));
    // its own home: options that a user has stored for gmsh would change the mesh
    const ShellResult result = run_in_shell(
        fmt::format("cd {} && HOME=$PWD timeout {} gmsh -2 -nt 1 -format msh22 -o section.msh section.geo",
                    shell_quoted(folder.path().string()), limit));
    if (!result.succeeded() || !std::filesystem::exists(folder.path() / "section.msh")) {
        const std::size_t at = result.output.find("Error");
        throw EnvironmentError(fmt::format(
            "gmsh ended with {}: {}", result.status,
            at == std::string::npos ? "no mesh"
                                    : result.output.substr(at, result.output.find('\n', at) - at)));
    }
    return mesh_of_gmsh(read_whole_file(folder.path() / "section.msh"),
                        {"body", "inflow", "walls", "atmosphere"});
}

}  // namespace wetdeck

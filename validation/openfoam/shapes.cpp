// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace wetdeck {
namespace {

constexpr double growth = 1.12;     // of cells away from a plate
constexpr double coarsest = 6;      // far cells over those at the plate
constexpr double film_share = 0.1;  // height over width of the cells under a plate
constexpr int film_rows = 10;       // of that height

}  // namespace

double film_cell(double cell) {
    return film_share * cell;
}

PlaneMesh tank_mesh(const Box& tank, double cell) {
    MeshGrid grid;
    grid.u = even_lines(tank.low.x(), tank.high.x(), cell);
    grid.v = even_lines(tank.low.y(), tank.high.y(), cell);
    grid.patch = [](Vec2) { return "walls"; };
    return mesh_of(grid);
}

PlaneMesh plate_mesh(const PlateShape& shape) {
    const Box &tank = shape.tank, &plate = shape.plate;
    const double middle = 0.5 * (plate.low.x() + plate.high.x()), cell = shape.cell, film = film_cell(cell);
    const double film_end = std::max(plate.low.y() - film_rows * film, 0.5 * (plate.low.y() + tank.low.y()));
    MeshGrid grid;
    grid.u = joined_lines(even_lines(middle, plate.high.x(), cell),
                          graded_lines(plate.high.x(), tank.high.x(), cell, growth, coarsest * cell));
    grid.v = joined_lines(graded_lines(film_end, tank.low.y(), film, growth, coarsest * cell),
                          even_lines(film_end, plate.low.y(), film));
    grid.v = joined_lines(grid.v, graded_lines(plate.low.y(), plate.high.y(), film, growth, cell));
    grid.v = joined_lines(grid.v, graded_lines(plate.high.y(), tank.high.y(), cell, growth, coarsest * cell));
    const auto in_plate = [plate](Vec2 p, double margin) {
        return p.x() < plate.high.x() + margin && p.y() > plate.low.y() - margin &&
               p.y() < plate.high.y() + margin;
    };
    grid.hole = [in_plate](Vec2 p) { return in_plate(p, 0); };
    const double tiny = 1e-6 * film;
    grid.patch = [=](Vec2 p) {
        if (in_plate(p, tiny) && p.x() > middle + tiny) return "body";
        if (p.x() < middle + tiny) return "symmetry";
        if (p.x() > tank.high.x() - tiny) return "walls";
        return p.y() < tank.low.y() + tiny ? "inflow" : "atmosphere";
    };
    return mesh_of(grid);
}

PlaneMesh wedge_mesh(const WedgeShape& shape) {
    using Complex = std::complex<double>;
    const double power = 1 + shape.deadrise / (0.5 * std::numbers::pi);
    const double reach = std::pow(shape.radius, 1 / power);  // of the square in w
    const double at_side = std::pow(shape.side, 1 / power);
    const double step = shape.cell / (power * std::pow(at_side, power - 1));
    const auto place = [=](Vec2 w) -> Vec2 {
        if (w.x() == 0 && w.y() == 0) return shape.keel;  // where the logarithm of the power has no value
        const Complex z = Complex(0, -1) * std::pow(Complex(w.x(), w.y()), power);
        return shape.keel + Vec2(z.real(), z.imag());
    };
    MeshGrid grid;
    grid.u = even_lines(0, reach, step);
    grid.v = even_lines(0, reach, step);
    grid.place = place;
    const double tiny = 1e-6 * step;
    grid.patch = [=](Vec2 w) {
        if (w.x() < tiny) return "body";
        if (w.y() < tiny) return "symmetry";
        if (w.x() > reach - tiny) return "inflow";
        return (place(w) - shape.keel).y() > shape.outflow_above ? "atmosphere" : "far";
    };
    return mesh_of(grid);
}

}  // namespace wetdeck

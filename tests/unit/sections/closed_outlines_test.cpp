// SPDX-License-Identifier: BSD-3-Clause
// Adding, taking away and parting closed curves, and figures of outlines.
#include "validation/sections/closed_outlines.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "tests/unit/sections/section_samples.hpp"

using namespace wetdeck;

namespace {

Outline rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double area(const ClosedOutlines& all) {
    double sum = 0;
    for (const Outline& outline : all.outlines) sum += signed_area(outline);
    for (const Outline& hole : all.holes) sum += signed_area(hole);
    return sum;
}

}  // namespace

TEST_CASE("a simple curve stays as it is written, and counter-clockwise") {
    const Outline box = rectangle(0, 0, 2, 1);
    CHECK(closed_outlines({box}).outlines.at(0) == box);
    const Outline turned(box.rbegin(), box.rend());
    CHECK(signed_area(closed_outlines({turned}).outlines.at(0)) == Approx(2));
}

TEST_CASE("curves that overlap, touch along a side, touch in a corner or enclose a hole") {
    const Outline box = rectangle(0, 0, 2, 2);
    struct Case {
        Outline other;
        double sum, rest;
        std::size_t parts, holes;
    };
    for (const Case& c :
         {Case{rectangle(1, 1, 3, 3), 7, 3, 1, 0}, Case{rectangle(2, 0, 3, 2), 6, 4, 1, 0},
          Case{rectangle(2, 0.5, 3, 1.5), 5, 4, 1, 0}, Case{rectangle(2, 2, 3, 3), 5, 4, 2, 0},
          Case{rectangle(0.5, 0.5, 1, 1), 4, 3.75, 1, 0}, Case{rectangle(5, 5, 6, 6), 5, 4, 2, 0},
          Case{rectangle(0, 0, 2, 2), 4, 0, 1, 0}, Case{rectangle(0, 1, 2, 3), 6, 2, 1, 0}}) {
        const ClosedOutlines sum = closed_outlines({box, c.other}), rest = closed_outlines({box}, {c.other});
        CAPTURE(c.other.front().transpose(), c.other[2].transpose());
        CHECK(area(sum) == Approx(c.sum));
        CHECK(area(rest) == Approx(c.rest).margin(1e-12));
        CHECK(sum.outlines.size() == c.parts);
        for (const Outline& outline : sum.outlines) CHECK_NOTHROW(check_outline(outline));
    }
    const ClosedOutlines frame = closed_outlines(
        {rectangle(0, 0, 4, 1), rectangle(0, 3, 4, 4), rectangle(0, 0, 1, 4), rectangle(3, 0, 4, 4)});
    CHECK(frame.outlines.size() == 1);
    CHECK(frame.holes.size() == 1);
    CHECK(area(frame) == Approx(12));
}

TEST_CASE("boxes at random: the area of their sum and difference is that of a count of cells") {
    std::mt19937 dice(7);
    std::uniform_int_distribution<int> place(0, 9), size(1, 5);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Outline> added, taken;
        std::array<std::array<int, 16>, 16> cells{};
        for (int k = 0; k < 5; ++k) {
            const int x = place(dice), y = place(dice), w = size(dice), h = size(dice);
            (k < 3 ? added : taken).push_back(rectangle(x, y, x + w, y + h));
            for (int i = x; i < x + w; ++i)
                for (int j = y; j < y + h; ++j)
                    cells.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j)) |= k < 3 ? 1 : 2;
        }
        int count = 0;
        for (const auto& column : cells)
            count += static_cast<int>(std::count(column.begin(), column.end(), 1));
        CAPTURE(trial);
        const ClosedOutlines all = closed_outlines(added, taken);
        CHECK(area(all) == Approx(count).margin(1e-9));
        for (const Outline& outline : all.outlines) CHECK_NOTHROW(check_outline(outline));
    }
}

TEST_CASE("figures of a wedge, of its half and of two hulls") {
    const double rise = std::tan(20 * std::numbers::pi / 180);
    const SectionOutline wedge{{{0, 1}, {1, 1 + rise}, {1, 2}, {-1, 2}, {-1, 1 + rise}}, true},
        half{{{0, 1}, {-1, 1 + rise}, {-1, 2}}, false};
    for (const SectionOutline& outline : {wedge, half}) {
        const SectionFigures f = figures_of(outline);
        CHECK(f.beam == Approx(2));
        CHECK(f.depth() == Approx(1));
        CHECK(f.area == Approx(2 - rise));
        CHECK(f.deadrise.value() == Approx(20 * std::numbers::pi / 180));
        CHECK(half_breadth_at(outline, 1 + rise / 2).value() == Approx(0.5));
        CHECK_FALSE(half_breadth_at(outline, 0.9));
    }
    CHECK(is_half_section(half));
    CHECK_FALSE(is_half_section(wedge));
    CHECK(figures_of({rectangle(-1, 0, 1, 1), true}).deadrise.value() == Approx(0).margin(1e-12));
}

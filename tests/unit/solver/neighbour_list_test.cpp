// SPDX-License-Identifier: BSD-3-Clause
// The neighbour list against brute force.
#include "solver/neighbours/neighbour_list.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

constexpr double spacing = 0.05, support = 0.125, skin = 0.02;

/// The shaken tank; every 40th particle is thrown out of the tank, some of them very far.
samples::Setup spilling_tank(std::uint64_t seed) {
    samples::Setup setup = samples::shaken_tank(samples::two_phase_model(), seed);
    double throw_distance = 0.05;
    for (std::size_t i = 0; i < setup.fluid.size(); i += 40) {
        FluidState& p = setup.fluid.state[i];
        const double direction = static_cast<double>(i);
        p.x += throw_distance * std::cos(direction);
        p.y += throw_distance * std::sin(direction);
        throw_distance *= 2;
    }
    // two neighbours far outside must find each other too
    setup.fluid.state[1].x = setup.fluid.state[2].x = 40;
    setup.fluid.state[1].y = 3;
    setup.fluid.state[2].y = 3.02;
    return setup;
}

struct Listed {
    samples::Setup setup;
    NeighbourList list;

    Listed(samples::Setup made, int threads)
        : setup(std::move(made)), list(setup.domain, spacing, support, skin, true) {
        list.place_fixed(setup.walls);
        list.build(setup.fluid, setup.walls, pair_loops(setup.model), threads);
    }
};

Vec2 position(const WallState& w) {
    return {w.x, w.y};
}

/// Pairs (particle, neighbour) that are closer than `reach` but missing from the lists, of fluid with fluid
/// and walls.
std::size_t missing(const Listed& listed, double reach) {
    const FluidParticles& fluid = listed.setup.fluid;
    const WallParticles& walls = listed.setup.walls;
    std::size_t count = 0;
    for (const Cluster& c : listed.list.clusters()) {
        const std::uint32_t fluid_count = c.fluid_neighbours[0] + c.fluid_neighbours[1];
        const std::set<std::uint32_t> near(c.neighbours, c.neighbours + fluid_count);
        const std::set<std::uint32_t> near_walls(c.neighbours + fluid_count,
                                                 c.neighbours + fluid_count + c.wall_neighbours);
        for (std::uint32_t i = c.first; i < c.first + c.count; ++i) {
            const Vec2 here = fluid.state[i].position();
            for (std::uint32_t j = 0; j < fluid.size(); ++j) {
                count += (here - fluid.state[j].position()).norm() < reach && near.count(j) == 0;
            }
            for (std::uint32_t w = 0; w < walls.size(); ++w) {
                count += (here - position(walls.state[w])).norm() < reach && near_walls.count(w) == 0;
            }
        }
    }
    return count;
}

std::size_t missing_of_walls(const Listed& listed, double reach) {
    const FluidParticles& fluid = listed.setup.fluid;
    std::set<std::pair<std::uint32_t, std::uint32_t>> near;
    for (const Cluster& c : listed.list.wall_clusters()) {
        for (std::uint32_t k = 0; k < c.fluid_neighbours[0] + c.fluid_neighbours[1]; ++k) {
            for (std::uint32_t w = c.first; w < c.first + c.count; ++w) near.emplace(w, c.neighbours[k]);
        }
    }
    std::size_t count = 0;
    for (std::uint32_t w = 0; w < listed.setup.walls.size(); ++w) {
        for (std::uint32_t f = 0; f < fluid.size(); ++f) {
            const double distance =
                (position(listed.setup.walls.state[w]) - fluid.state[f].position()).norm();
            count += distance < reach && near.count({w, f}) == 0;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("The list holds every pair within support and skin, for disordered sets and outside the tank",
          "[neighbours]") {
    const std::uint64_t seed = GENERATE(1, 2, 3);
    const Listed listed(spilling_tank(seed), GENERATE(1, 3));
    CHECK(missing(listed, support + skin) == 0);
    CHECK(missing_of_walls(listed, support + skin) == 0);
    // the counting itself sees pairs that are too far to be listed
    CHECK(missing(listed, support + 4 * skin) > 0);
    CHECK(missing_of_walls(listed, support + 8 * skin) > 0);
}

TEST_CASE("The list still holds every pair in support after all moved by just under half the skin",
          "[neighbours]") {
    Listed listed(spilling_tank(4), 1);
    CHECK(listed.list.allowance() == Approx(0.5 * skin));
    for (std::size_t i = 0; i < listed.setup.fluid.size(); ++i) {
        FluidState& p = listed.setup.fluid.state[i];
        REQUIRE(p.position() == listed.list.built_at(i));
        const double direction = 2.3 * static_cast<double>(listed.setup.fluid.id[i]);
        p.x += 0.999 * listed.list.allowance() * std::cos(direction);
        p.y += 0.999 * listed.list.allowance() * std::sin(direction);
    }
    CHECK(missing(listed, support) == 0);
    CHECK(missing_of_walls(listed, support) == 0);
}

TEST_CASE(
    "Each cluster lists its neighbours once, by kind, and none that is out of reach of all its particles",
    "[neighbours]") {
    const Listed listed(spilling_tank(5), 1);
    const FluidParticles& fluid = listed.setup.fluid;
    std::size_t particles = 0, wrong_kind = 0, repeated = 0, too_far = 0;
    for (const Cluster& c : listed.list.clusters()) {
        CHECK(c.first == particles);  // clusters cover all particles in order, none twice
        particles += c.count;
        CHECK(c.count <= cluster_width);
        CHECK(c.phase == fluid.phase(c.first));
        CHECK(c.phase == fluid.phase(c.first + c.count - 1));
        const std::uint32_t fluid_count = c.fluid_neighbours[0] + c.fluid_neighbours[1];
        const std::set<std::uint32_t> near(c.neighbours, c.neighbours + fluid_count);
        repeated += fluid_count - near.size();
        for (std::uint32_t k = 0; k < fluid_count; ++k) {
            const std::uint32_t j = c.neighbours[k];
            wrong_kind += fluid.phase(j) != (k < c.fluid_neighbours[0] ? Phase::water : Phase::air);
            double nearest = 1e300;
            for (std::uint32_t i = c.first; i < c.first + c.count; ++i) {
                nearest = std::min(nearest, (fluid.state[i].position() - fluid.state[j].position()).norm());
            }
            too_far += nearest > support + skin + 1e-12;
        }
    }
    CHECK(particles == fluid.size());
    CHECK(repeated == 0);
    CHECK(wrong_kind == 0);
    CHECK(too_far == 0);
}

TEST_CASE("Sorting keeps each particle's state, mass and id together and water before air", "[neighbours]") {
    const samples::Setup before = spilling_tank(6);
    const Listed listed(before, 1);
    const FluidParticles& fluid = listed.setup.fluid;
    REQUIRE(fluid.size() == before.fluid.size());
    CHECK(fluid.water == before.fluid.water);
    CHECK(std::set<std::uint32_t>(fluid.id.begin(), fluid.id.end()).size() == fluid.size());
    std::size_t torn = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const std::uint32_t id = fluid.id[i];
        torn += fluid.state[i].position() != before.fluid.state[id].position() ||
                fluid.state[i].velocity() != before.fluid.state[id].velocity() ||
                fluid.mass[i] != before.fluid.mass[id] || fluid.phase(i) != before.fluid.phase(id);
    }
    CHECK(torn == 0);
}

TEST_CASE("A set of one phase without walls has a list too", "[neighbours]") {
    samples::Setup setup{samples::two_phase_model(), {}, {}, spacing, Box{{0, 0}, {1, 1}}};
    const Phase phase = GENERATE(Phase::water, Phase::air);
    for (int n = 0; n < 9; ++n) setup.fluid.add(phase, {0.5 + 0.04 * (n % 3), 0.5 + 0.04 * (n / 3)}, 1, 1000);
    const Listed listed(setup, 1);
    CHECK(listed.list.clusters().size() == 2);
    CHECK(missing(listed, support) == 0);
    CHECK(listed.list.entries() == 9 + 9);
}

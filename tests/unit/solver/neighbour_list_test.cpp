// SPDX-License-Identifier: BSD-3-Clause
// The neighbour list against brute force.
#include "solver/neighbours/neighbour_list.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "solver/setup/lattice.hpp"
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
        list.sort_fixed_walls(setup.walls);
        list.build(setup.fluid, setup.walls, pair_passes(setup.model).filter_near, threads);
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
        const NeighbourBlocks& blocks = listed.list.blocks();
        std::set<std::uint32_t> near, near_walls;
        for (std::size_t phase = 0; phase < phase_count; ++phase)
            for (const std::uint32_t j : fluid_neighbours(blocks, c, phase)) near.insert(j);
        for (const std::uint32_t w : wall_neighbours(blocks, c)) near_walls.insert(w);
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
        for (std::size_t phase = 0; phase < phase_count; ++phase)
            for (const std::uint32_t j : fluid_neighbours(listed.list.blocks(), c, phase))
                for (std::uint32_t w = c.first; w < c.first + c.count; ++w) near.emplace(w, j);
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

TEST_CASE("Where particles differ in their smoothing lengths the list holds every pair within its own reach",
          "[neighbours]") {
    samples::Setup setup = samples::graded_tank(samples::two_phase_model(), GENERATE(1, 2));
    // some thrown about, so that fine and coarse ones lie side by side, and out of the tank
    for (std::size_t i = 0; i < setup.fluid.size(); i += 20) {
        setup.fluid.state[i].x += 0.013 * static_cast<double>(i % 100) - 0.6;
        setup.fluid.state[i].y -= 0.007 * static_cast<double>(i % 130) - 0.4;
    }
    const ListReach reach{2.5 * setup.particle_spacing, 0.01};
    NeighbourList list(setup.domain, setup.particle_spacing, reach.support, reach.skin, true,
                       DomainEnds::walls, setup.coarsest);
    list.sort_fixed_walls(setup.walls);
    const PairPasses passes = pair_passes(setup.model, "", Precision::double_precision, true);
    list.build(setup.fluid, setup.walls, passes.filter_near, GENERATE(1, 3));
    const FluidParticles& fluid = setup.fluid;
    const auto mean = [](double a, double b) { return 0.5 * (a + b); };
    std::size_t lacking = 0, listed = 0, within = 0;
    for (const Cluster& c : list.clusters()) {
        std::set<std::uint32_t> near, near_walls;
        for (std::size_t phase = 0; phase < phase_count; ++phase)
            for (const std::uint32_t j : fluid_neighbours(list.blocks(), c, phase)) near.insert(j);
        for (const std::uint32_t w : wall_neighbours(list.blocks(), c)) near_walls.insert(w);
        listed += c.count * near.size();
        for (std::uint32_t i = c.first; i < c.first + c.count; ++i) {
            const FluidState& p = fluid.state[i];
            for (std::uint32_t j = 0; j < fluid.size(); ++j) {
                const FluidState& q = fluid.state[j];
                const bool close =
                    (p.position() - q.position()).norm() < reach.of(mean(p.fineness, q.fineness));
                within += close;
                lacking += close && near.count(j) == 0;
            }
            for (std::uint32_t w = 0; w < setup.walls.size(); ++w) {
                const Vec2 apart = p.position() - position(setup.walls.state[w]);
                const double farthest = reach.of(mean(p.fineness, setup.walls.fineness[w]));
                lacking += apart.norm() < farthest && near_walls.count(w) == 0;
            }
        }
    }
    CHECK(lacking == 0);
    CHECK(listed < 4 * within);  // a list that held far pairs, too, would be slow
}

TEST_CASE("A list with another skin holds every pair within that", "[neighbours]") {
    Listed listed(spilling_tank(5), 1);
    const double other = GENERATE(0.2, 0.5, 4.0) * skin;
    listed.list.set_skin(other, listed.setup.walls);
    listed.list.build(listed.setup.fluid, listed.setup.walls, pair_passes(listed.setup.model).filter_near, 2);
    CHECK(listed.list.slack() == other);
    CHECK(missing(listed, support + other) == 0);
    CHECK(missing_of_walls(listed, support + other) == 0);
    CHECK(missing(listed, support + 4 * other) > 0);
}

TEST_CASE("A periodic domain that has no room for a thick skin takes a thinner one", "[neighbours]") {
    samples::Setup setup = samples::shaken_tank(samples::two_phase_model(), 1);
    const double width = setup.domain.high.x() - setup.domain.low.x(), reach = 0.45 * width;
    NeighbourList list(setup.domain, spacing, reach, 0.01 * width, true, DomainEnds::periodic);
    list.set_skin(0.03 * width, setup.walls);
    CHECK(list.skin() == Approx(0.03 * width));
    list.set_skin(0.2 * width, setup.walls);
    CHECK(list.skin() == Approx(0.05 * width));
}

/// Moves all fluid to where `flow` takes it from where the list was built; returns the longest move.
template <class Flow>
double move(Listed& listed, const Flow& flow) {
    double longest = 0;
    for (std::size_t i = 0; i < listed.setup.fluid.size(); ++i) {
        FluidState& p = listed.setup.fluid.state[i];
        const Vec2 by = flow(listed.list.built_at(i), listed.setup.fluid.id[i]);
        p.x = listed.list.built_at(i).x() + by.x();
        p.y = listed.list.built_at(i).y() + by.y();
        longest = std::max(longest, by.norm());
    }
    return longest;
}

/// Goes with a flow that grows step by step until the list gives up. Returns how far the fastest had moved
/// when it was complete for the last time.
template <class Flow>
double moved_while_complete(Listed& listed, const Flow& flow) {
    double moved = 0, step = 0.05 * skin;
    for (int n = 1; n <= 1000; ++n) {
        const double longest =
            move(listed, [&](Vec2 at, std::uint32_t id) -> Vec2 { return n * step * flow(at, id); });
        if (!listed.list.still_complete(step, listed.setup.fluid, listed.setup.walls, 2)) return moved;
        if (n % 5 == 0) {
            CHECK(missing(listed, support) == 0);
            CHECK(missing_of_walls(listed, support) == 0);
        }
        moved = longest;
    }
    return moved;
}

TEST_CASE("The list says that it is complete as long as it holds every pair in support, whatever the flow",
          "[neighbours]") {
    Listed listed(spilling_tank(4), 1);
    CHECK(listed.list.slack() == Approx(skin));
    SECTION("each particle goes its own way: half the skin for each") {
        const double moved = moved_while_complete(listed, [](Vec2, std::uint32_t id) -> Vec2 {
            return {std::cos(2.3 * id), std::sin(2.3 * id)};
        });
        CHECK(moved >= 0.3 * skin);  // the diagonal of the box around all directions is 2 sqrt(2) moves
        CHECK(moved <= 0.55 * skin);
    }
    SECTION("all go together: the walls are what they approach") {
        const double moved = moved_while_complete(listed, [](Vec2, std::uint32_t) -> Vec2 {
            return {0.8, 0.6};
        });
        CHECK(moved == Approx(skin).epsilon(0.06));
    }
    SECTION("a shear and a stagnation flow") {
        moved_while_complete(listed, [](Vec2 at, std::uint32_t) -> Vec2 {
            return {std::clamp(at.y(), 0.0, 1.0), 0.0};
        });
    }
    SECTION("a stagnation flow") {
        moved_while_complete(listed, [](Vec2 at, std::uint32_t) -> Vec2 {
            const Vec2 from = 0.5 * (at - Vec2(0.5, 0.5));
            return Vec2(from.x(), -from.y()) / std::max(1.0, from.norm());
        });
    }
    SECTION("a vortex with a jump at its rim") {
        moved_while_complete(listed, [](Vec2 at, std::uint32_t) -> Vec2 {
            const Vec2 from = at - Vec2(0.5, 0.4);
            return from.norm() < 0.3 ? Vec2(3 * Vec2(-from.y(), from.x())) : Vec2(0.1, 0.0);
        });
    }
    // the counting sees what a list lacks that is used for longer
    move(listed, [](Vec2, std::uint32_t id) -> Vec2 {
        return 4 * skin * Vec2(std::cos(2.3 * id), std::sin(2.3 * id));
    });
    CHECK(missing(listed, support) > 0);
}

TEST_CASE("Far from walls the list outlives any move that all particles share, up to a block",
          "[neighbours]") {
    samples::Setup setup(samples::two_phase_model(), Box{{0, 0}, {2, 2}}, spacing);
    fill_box(setup.fluid, Phase::water, {{0.5, 0.5}, {1.5, 1.5}}, spacing, 1000);
    Listed listed(setup, 1);
    CHECK(moved_while_complete(listed, [](Vec2, std::uint32_t) -> Vec2 { return {0.6, -0.8}; }) > 1.4 * skin);
}

TEST_CASE("One particle that flies at its neighbours ends the life of the list", "[neighbours]") {
    Listed listed(samples::shaken_tank(samples::two_phase_model(), 7), 1);
    const double moved = moved_while_complete(
        listed, [](Vec2, std::uint32_t id) -> Vec2 { return id == 100 ? Vec2(1, 0) : Vec2(0, 0); });
    CHECK(moved == Approx(skin).epsilon(0.06));
}

TEST_CASE("A body that comes nearer ends the life of the list", "[neighbours]") {
    samples::Setup setup(samples::two_phase_model(), Box{{0, 0}, {2, 2}}, spacing);
    fill_box(setup.fluid, Phase::water, {{0.5, 0.5}, {1.5, 1.0}}, spacing, 1000);
    setup.walls.add_body_point(0, {0, 0}, {0, -1});
    setup.walls.state[0].x = 1;
    setup.walls.state[0].y = 1.1;
    Listed listed(setup, 1);
    WallParticles& walls = listed.setup.walls;
    double moved = 0;
    while (listed.list.still_complete(0.05 * skin, listed.setup.fluid, walls, 1)) {
        walls.state[0].y -= 0.05 * skin;
        moved += 0.05 * skin;
        REQUIRE(moved < 10 * skin);
    }
    CHECK(moved == Approx(skin).epsilon(0.06));
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
        for (std::size_t phase = 0; phase < phase_count; ++phase) {
            const Neighbours listed_once = fluid_neighbours(listed.list.blocks(), c, phase);
            const std::set<std::uint32_t> near(listed_once.begin(), listed_once.end());
            repeated += listed_once.size() - near.size();
            for (const std::uint32_t j : listed_once) {
                wrong_kind += fluid.phase(j) != Phase(phase);
                double nearest = 1e300;
                for (std::uint32_t i = c.first; i < c.first + c.count; ++i)
                    nearest =
                        std::min(nearest, (fluid.state[i].position() - fluid.state[j].position()).norm());
                too_far += nearest > support + skin + 1e-12;
            }
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
    samples::Setup setup(samples::two_phase_model(), Box{{0, 0}, {1, 1}}, spacing);
    const Phase phase = GENERATE(Phase::water, Phase::air);
    for (int n = 0; n < 9; ++n) setup.fluid.add(phase, {0.5 + 0.04 * (n % 3), 0.5 + 0.04 * (n / 3)}, 1, 1000);
    const Listed listed(setup, 1);
    CHECK(listed.list.clusters().size() == 2);
    CHECK(missing(listed, support) == 0);
    CHECK(listed.list.entries() == 9 + 9);
}

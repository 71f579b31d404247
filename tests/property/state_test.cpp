// SPDX-License-Identifier: BSD-3-Clause
// A simulation put together again from its state goes on with the same bits.
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "solver/core/errors.hpp"
#include "solver/setup/body_outline.hpp"
#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {

samples::Setup setup(const Model& model) {
    return samples::dam_break(model, {0.3, 0.45}, {0.9, 0.6}, 0.03);
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

void step(Simulation& simulation, int steps) {
    for (int n = 0; n < steps; ++n) REQUIRE_FALSE(simulation.step(1));
}

}  // namespace

TEST_CASE("A simulation restored between two builds of its list goes on with the same bits, on any threads",
          "[determinism]") {
    Model model = samples::two_phase_model();
    model.dissipation_switch = GENERATE(false, true);
    if (!model.dissipation_switch) model.air_substeps = GENERATE(1, 3);
    model.wall_pressure =
        GENERATE(WallPressure::shepard_water, WallPressure::shepard, WallPressure::one_sided);
    model.wall_velocity = GENERATE(WallVelocity::mirrored, WallVelocity::normal);
    samples::Setup made = setup(model);
    if (!model.dissipation_switch)
        made.execution.precision = GENERATE(Precision::double_precision, Precision::mixed);
    Simulation whole = made.simulate();
    step(whole, 100);
    std::uint64_t builds = whole.list_builds();
    while (whole.list_builds() == builds) step(whole, 1);
    step(whole, 3);  // the particles are no longer where they were listed

    samples::Setup other = made;
    other.execution.threads = 3;
    Simulation parted = other.simulate();
    parted.restore(whole.state());
    CHECK(parted.time() == whole.time());
    CHECK(parted.neighbours().entries() == whole.neighbours().entries());
    builds = whole.list_builds();
    step(whole, 100);
    step(parted, 100);
    CHECK(whole.list_builds() > builds);
    CHECK(parted.list_builds() == whole.list_builds());
    CHECK(parted.time() == whole.time());
    CHECK(parted.steps() == whole.steps());
    CHECK(parted.particle_steps() == whole.particle_steps());
    CHECK(parted.limiting_counts() == whole.limiting_counts());
    CHECK(same_bits(parted.fluid().state, whole.fluid().state));
    CHECK(same_bits(parted.fluid().id, whole.fluid().id));
    CHECK(same_bits(parted.fluid().mass, whole.fluid().mass));
}

TEST_CASE("A simulation with a falling, turning body goes on with the same bits", "[determinism]") {
    samples::Setup made = setup(samples::two_phase_model());
    const Vec2 c(0.6, 0.3), a(0.12, 0.16), b(0.16, -0.12);
    const Outline outline = {c - a, c + b, c + a, c - b};
    clear_fluid(made.fluid, outline, made.particle_spacing);
    add_body_particles(made.walls, 0, outline, c, made.particle_spacing,
                       2 * made.model.smoothing_ratio * made.particle_spacing);
    RigidBody body;
    body.mass = 60;
    body.inertia = 0.9;
    body.position = c;
    body.angular_velocity = 3;
    made.bodies = {body};
    const auto simulate = [&](int threads) {
        made.execution.threads = threads;
        return made.simulate();
    };
    Simulation whole = simulate(1), parted = simulate(2);
    step(whole, 150);
    parted.restore(whole.state());
    CHECK(same_bits(parted.walls().state, whole.walls().state));
    step(whole, 150);
    step(parted, 150);
    CHECK(std::abs(whole.bodies()[0].angle) > 0.05);
    CHECK(same_bits(parted.fluid().state, whole.fluid().state));
    CHECK(same_bits(parted.walls().state, whole.walls().state));
    CHECK(parted.bodies()[0].angle == whole.bodies()[0].angle);
    CHECK(parted.bodies()[0].work == whole.bodies()[0].work);
    CHECK(parted.bodies()[0].impulse == whole.bodies()[0].impulse);
}

TEST_CASE("A state that does not fit is refused", "[determinism]") {
    Simulation simulation = setup(samples::two_phase_model()).simulate();
    Simulation::State state = simulation.state();
    SECTION("of another set-up") {
        state =
            samples::dam_break(samples::two_phase_model(), {0.3, 0.3}, {0.6, 0.6}, 0.03).simulate().state();
    }
    SECTION("without a number") {
        state.numbers.erase("time");
    }
    SECTION("with a particle named twice") {
        state.arrays["id"][1] = state.arrays["id"][0];
    }
    SECTION("with a particle nowhere") {
        state.arrays["listed_at"][5] = std::numeric_limits<double>::quiet_NaN();
    }
    SECTION("with a list that would never be built again") {
        state.numbers["list_slack"] = GENERATE(1e300, -1.0, std::numeric_limits<double>::quiet_NaN());
    }
    SECTION("with a skin that no run chooses") {
        state.numbers["list_skin"] = GENERATE(0.0, 1e300, std::numeric_limits<double>::quiet_NaN());
    }
    SECTION("with lists that served no number of steps") {
        state.numbers[GENERATE("list_served", "lists_steps", "lists_skins")] =
            GENERATE(-1.0, std::numeric_limits<double>::infinity());
    }
    SECTION("with a count that is none") {
        state.numbers["steps"] = -1;
    }
    CHECK_THROWS_AS(simulation.restore(state), DataError);
}

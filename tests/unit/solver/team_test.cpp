// SPDX-License-Identifier: BSD-3-Clause
// The number of threads on a busy machine.
#include "solver/core/team.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

namespace {

/// Work of one second, of which the team gets so much processor time.
int after_a_second(Team& team, double processors) {
    team.add(1, processors);
    team.adapt();
    return team.size();
}

}  // namespace

TEST_CASE("A team that has its processors keeps its size", "[parallel]") {
    const int most = GENERATE(1, 2, 16);
    Team team(most, true);
    for (int n = 0; n < 100; ++n) CHECK(after_a_second(team, 0.97 * most) == most);
}

TEST_CASE("A team that waits for one of its threads does without it, and tries again ever more seldom",
          "[parallel]") {
    Team team(2, true);
    CHECK(after_a_second(team, 0.7) == 1);
    int trials = 0;
    for (int second = 0; second < 200; ++second)
        if (after_a_second(team, team.size() == 1 ? 1 : 0.7) == 2) ++trials;
    CHECK(trials >= 3);
    CHECK(trials <= 8);  // after 1, 2, 4, ... seconds
    while (team.size() == 1) after_a_second(team, 1);
    CHECK(after_a_second(team, 1.9) == 2);  // the machine is free again
    CHECK(after_a_second(team, 1.9) == 2);
    CHECK(after_a_second(team, 0.7) == 1);
    CHECK(after_a_second(team, 1) == 2);  // the next trial comes soon
}

TEST_CASE("A large team gets smaller one by one, down to the processors that are free", "[parallel]") {
    Team team(16, true);
    const auto used = [&] { return team.size() > 10 ? 5.0 : 0.98 * team.size(); };
    for (int second = 0; second < 6; ++second) after_a_second(team, used());
    CHECK(team.size() == 10);
    CHECK(after_a_second(team, used()) == 11);
    CHECK(after_a_second(team, used()) == 10);
}

TEST_CASE("A team looks at enough work, and a fixed one not at all", "[parallel]") {
    Team team(2, true);
    team.add(0.01, 0.001);
    team.adapt();
    CHECK(team.size() == 2);
    Team fixed(2, false);
    CHECK(after_a_second(fixed, 0.1) == 2);
}

TEST_CASE("Work is timed", "[parallel]") {
    Team team(4, true);
    {
        const Team::Work work(team);
        const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(60);
        while (std::chrono::steady_clock::now() < end) {
        }
    }
    team.adapt();
    CHECK(team.size() == 3);  // one thread alone has worked
}

// SPDX-License-Identifier: BSD-3-Clause
// Verdicts of made-up comparisons whose answer is known.
#include "validation/metrics/verdict.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace wetdeck;
using Catch::Contains;

namespace {

/// Of a measured 10 Pa.
ValidationRow row_with(double error, std::optional<double> u_num, std::optional<double> u_input,
                       std::optional<double> u_data) {
    ValidationRow row;
    row.unit = "Pa";
    row.reference = 10;
    row.simulated = 10 + error;
    row.error = error;
    row.u_num = row.u_grid = u_num;
    row.u_input = u_input;
    row.u_data = u_data;
    row.u_known = std::sqrt(std::pow(u_num.value_or(0), 2) + std::pow(u_input.value_or(0), 2) +
                            std::pow(u_data.value_or(0), 2));
    if (u_num && u_input && u_data) {
        row.u_val = row.u_known;
        row.interval = {error - 1.96 * row.u_known, error + 1.96 * row.u_known};
    }
    return row;
}

std::string verdict(ValidationRow row) {
    conclude(row);
    return row.verdict;
}

std::string sentence(ValidationRow row) {
    conclude(row);
    return row.sentence;
}

ValidationRow requiring(double share, ValidationRow row) {
    row.required = share;
    return row;
}

/// All of u_num is the scatter among arrangements of the particles.
ValidationRow scattering(ValidationRow row) {
    row.u_scatter = row.u_grid;
    row.u_grid = 0;
    return row;
}

ValidationRow beside(ReferenceKind kind, ValidationRow row) {
    row.kind = kind;
    return row;
}

ValidationRow assuming(const char* name, ValidationRow row) {
    row.assumed = {name};
    return row;
}

}  // namespace

TEST_CASE("The verdict says what the error and its uncertainties allow", "[verdict]") {
    CHECK(verdict(row_with(2, 0.1, 0.1, 0.9)) == "too high");
    CHECK(verdict(row_with(-2, 0.1, 0.1, 0.9)) == "too low");
    CHECK(verdict(row_with(1.9, 0.1, 0.1, 1)) == "within the uncertainty");
    CHECK(verdict(row_with(1.9, 1.1, 0.1, 1)) == "refine first");
    CHECK(verdict(row_with(5, 0.1, 0.1, {})) == "unknown");
    CHECK(verdict(row_with(5, {}, {}, {})) == "unknown");
    CHECK(verdict(row_with(0, {}, {}, {})) == "unknown");
    // what is known is enough to make zero possible
    CHECK(verdict(row_with(0.5, 0.1, {}, 1)) == "within the uncertainty");
    CHECK(verdict(row_with(0.5, 1, {}, 0.1)) == "refine first");
    // finer particles do not make the scatter smaller
    CHECK(verdict(scattering(row_with(1.9, 1.1, 0.1, 1))) == "within the uncertainty");
}

TEST_CASE("Beside an exact solution or another code the verdict has words of its own", "[verdict]") {
    const ReferenceKind kind =
        GENERATE(ReferenceKind::analytic, ReferenceKind::peer_simulation, ReferenceKind::stated);
    CHECK(verdict(beside(kind, row_with(2, 0.1, 0, 0.9))) == "higher");
    CHECK(verdict(beside(kind, row_with(-2, 0.1, 0, 0.9))) == "lower");
    CHECK(verdict(beside(kind, row_with(1.9, 0.1, 0, 1))) == "agrees");
    CHECK(verdict(beside(kind, row_with(1.9, 1.1, 0, 0))) == "refine first");
    CHECK(verdict(beside(kind, row_with(5, 0.1, 0, {}))) == "unknown");
    CHECK_THAT(sentence(beside(kind, row_with(2, 0.1, 0, 0.9))), !Contains("measurement"));
    CHECK_THAT(sentence(beside(ReferenceKind::analytic, row_with(2, 0.1, 0, 0))),
               Contains("the exact solution 10 Pa") && Contains("the error of the solution lies between"));
    CHECK_THAT(sentence(beside(ReferenceKind::peer_simulation, row_with(0.1, 0.1, 0, 1))),
               Contains("the other computation 10 Pa") && Contains("the difference between both lies") &&
                   Contains("agree within what both can tell"));
}

TEST_CASE("The largest part of the uncertainty is named, with what would make it smaller", "[verdict]") {
    const auto largest = [](ValidationRow row) {
        row.largest_input = "body.mass";
        conclude(row);
        return row;
    };
    CHECK(largest(row_with(1, 0.9, 0.1, 0.1)).largest_part == "spacing");
    CHECK(largest(scattering(row_with(1, 0.9, 0.1, 0.1))).largest_part == "arrangement");
    CHECK_THAT(largest(scattering(row_with(1, 0.9, 0.1, 0.1))).sentence,
               Contains("mean of several replicates"));
    CHECK(largest(row_with(1, 0.1, 0.9, 0.1)).largest_part == "inputs");
    CHECK_THAT(largest(row_with(1, 0.1, 0.9, 0.1)).sentence, Contains("a better known body.mass"));
    CHECK(largest(row_with(1, 0.1, 0.1, 0.9)).largest_part == "reference");
    CHECK(largest(row_with(1, {}, {}, {})).largest_part.empty());
}

TEST_CASE("Required accuracy turns the interval into fitness for a purpose", "[verdict]") {
    const ValidationRow close = row_with(0.3, 0.1, 0.1, 0.1), off = row_with(3, 0.1, 0.1, 0.1);
    CHECK(verdict(requiring(0.1, close)) == "validated");
    CHECK_THAT(sentence(requiring(0.1, close)), Contains("Fit for an accuracy of 10 %: yes."));
    CHECK(verdict(requiring(0.05, close)) == "within the uncertainty");
    CHECK_THAT(sentence(requiring(0.05, close)), Contains("5 %: not shown."));
    CHECK(verdict(requiring(0.1, off)) == "too high");
    CHECK_THAT(sentence(requiring(0.1, off)), Contains("10 %: no."));
    CHECK_THAT(sentence(close), !Contains("Fit for"));
}

TEST_CASE("The sentence names values, interval, largest part and what is assumed", "[verdict]") {
    CHECK(sentence(row_with(2, 0.4, 0.3, 0)) ==
          "The simulation gives 12 Pa, the measurement 10 Pa: 2 Pa (20 %) higher. With 95 % confidence the "
          "error of the model lies between 1.02 and 2.98 Pa. Most of this uncertainty is that of the spacing "
          "(u_grid): finer particles would help most.");
    CHECK_THAT(sentence(row_with(-0.5, 0.3, 0.4, 0)),
               Contains("lower") && Contains("so that no error is shown"));
    ValidationRow falling = row_with(0.5, 0.3, 0.4, 0);
    falling.reference = -10;
    CHECK_THAT(sentence(falling), Contains("0.5 Pa (5 %) smaller in magnitude"));
    const auto in = [](const char* unit, ValidationRow row) {
        row.unit = unit;
        return row;
    };
    CHECK_THAT(sentence(in("s", row_with(0.5, 0.3, 0.4, 0))), Contains("0.5 s (5 %) later"));
    CHECK_THAT(sentence(in("s", row_with(-0.5, 0.3, 0.4, 0))), Contains("earlier"));
    CHECK_THAT(sentence(in("m/s", row_with(0.5, 0.3, 0.4, 0))), Contains("faster"));
    CHECK_THAT(sentence(in("m/s", falling)), Contains("slower"));
    CHECK_THAT(sentence(row_with(5, 0.1, {}, {})), Contains("u_input, u_data unknown"));
    // |E| = 1.96 sqrt(0.3^2 + 0.4^2 + u^2) for u = 0.8895
    CHECK_THAT(sentence(assuming("u_data", row_with(2, 0.3, 0.4, 0.1))),
               Contains("u_data is assumed to be 0.1 Pa (1 %): this would change above 0.89 Pa"));
    CHECK_THAT(sentence(assuming("u_data", row_with(2, 0.3, 0.4, 1))),
               Contains("would change below 0.89 Pa"));
    CHECK_THAT(sentence(assuming("u_data", row_with(0.5, 0.3, 0.4, 1))),
               Contains("no value of it would change"));
}

TEST_CASE("The interval covers the error of the model in 95 of 100 draws", "[verdict]") {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    constexpr int draws = 1000;
    int covered = 0, judged = 0, wrong = 0;
    for (int k = 0; k < draws; ++k) {
        const double model = 2 * normal(engine);
        const double u_num = std::abs(normal(engine)), u_input = std::abs(normal(engine)), u_data = 0.5;
        const double error =
            model + u_num * normal(engine) + u_input * normal(engine) + u_data * normal(engine);
        ValidationRow row = row_with(error, u_num, u_input, u_data);
        conclude(row);
        covered += (*row.interval)[0] <= model && model <= (*row.interval)[1];
        if (row.verdict != "too high" && row.verdict != "too low") continue;
        ++judged;
        wrong += (row.verdict == "too high") != (model > 0);
    }
    CHECK(covered >= 0.93 * draws);
    CHECK(covered <= 0.97 * draws);
    CHECK(judged > 100);
    CHECK(wrong <= 0.025 * draws);
}

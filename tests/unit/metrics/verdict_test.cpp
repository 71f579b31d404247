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
    row.u_num = u_num;
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
    CHECK(sentence(row_with(2, 0.3, 0.4, 0)) ==
          "The simulation gives 12 Pa, the measurement 10 Pa: 2 Pa (20 %) higher. With 95 % confidence the "
          "model's error lies between 1.02 and 2.98 Pa. Most of this uncertainty is that of the inputs "
          "(u_input): better known inputs would help most.");
    CHECK_THAT(sentence(row_with(-0.5, 0.3, 0.4, 0)), Contains("lower") && Contains("so that none is shown"));
    ValidationRow falling = row_with(0.5, 0.3, 0.4, 0);
    falling.reference = -10;
    CHECK_THAT(sentence(falling), Contains("0.5 Pa (5 %) smaller in magnitude"));
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

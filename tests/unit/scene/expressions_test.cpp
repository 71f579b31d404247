// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a scene that follow from its parameters.
#include "validation/scene/expressions.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/unit/scene/scene_samples.hpp"
#include "validation/analytic/wedge_similarity.hpp"
#include "validation/scene/identity.hpp"

using namespace wetdeck;
using Catch::Contains;

namespace {

/// The small scene with a table of parameters and what else is replaced.
std::string with_parameters(const std::string& table, const std::string& piece = "",
                            const std::string& replacement = "") {
    const std::string scene = samples::with("[scales]\n", "[parameters]\n" + table + "\n[scales]\n");
    return piece.empty() ? scene : samples::replaced(scene, piece, replacement);
}

/// What is said against an expression, or its value as a text.
std::string refusal_of(const std::string& expression) {
    Expressions expressions;
    expressions.define("speed", 3);
    try {
        return std::to_string(expressions.value(expression));
    } catch (const InputError& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("expressions follow the rules of algebra, in radians", "[expressions]") {
    Expressions expressions;
    expressions.define("a", 3);
    expressions.define("b", 0.5);
    CHECK(expressions.value("= a + 2*b") == 4);
    CHECK(expressions.value("=-a^2") == -9);
    CHECK(expressions.value("= 2^3^2") == 512);
    CHECK(expressions.value("= 12*pi*a/(2*tan(b))") ==
          Approx(12 * std::numbers::pi * 3 / (2 * std::tan(0.5))));
    CHECK(expressions.value("= max(a, b) - min(a, b)") == 2.5);
    CHECK(expressions.value("= ln(exp(2)) + log10(1000)") == Approx(5));
    CHECK(expressions.value("= a > 2 ? 1 : 0") == 1);
    CHECK(expressions.value("= wedge_force(pi/6)") ==
          wedge_similarity(std::numbers::pi / 6).force_coefficient);
    CHECK(expressions.unused().empty());
    CHECK(expressions.filled("analytic:x v={= a} w={= 2*b}!") == "analytic:x v=3 w=1!");
}

TEST_CASE("what an expression cannot mean is refused with a reason", "[expressions]") {
    CHECK(refusal_of("= 2*speed") == "6.000000");
    // a decimal comma, and the logarithm of either base, would be taken for something else
    CHECK_THAT(refusal_of("= 1,5"), Contains("comma"));
    CHECK_THAT(refusal_of("= log(100)"), Contains("log"));
    CHECK_THAT(refusal_of("= 2*sped"), Contains("unknown name 'sped'") && Contains("speed"));
    CHECK_THAT(refusal_of("= 1/0"), Contains("not finite"));
    CHECK_THAT(refusal_of("= sqrt(-1)"), Contains("not finite"));
    CHECK_THAT(refusal_of("= 2*"), Contains("is '= 2*'"));
    CHECK_THAT(refusal_of("="), Contains("is '='"));
    CHECK_THAT(refusal_of("= speed 2"), Contains("is '= speed 2'"));
    CHECK_THAT(refusal_of("= wedge_force(0.01)"), Contains("covers 2 to 70"));
    Expressions expressions;
    CHECK_THROWS_AS(expressions.define("pi", 3), InputError);
    CHECK_THROWS_AS(expressions.define("sin", 3), InputError);
    CHECK_THROWS_AS(expressions.define("2a", 3), InputError);
    CHECK_THROWS_AS(expressions.filled("{= 2"), InputError);
}

TEST_CASE("parameters have units, follow from each other in any order, and reach every number of a scene",
          "[expressions]") {
    const std::string text = with_parameters("width = \"= 2*half\"\nhalf = \"20 cm\"\nturn = \"180 deg\"\n",
                                             "[0.0, 0.0, 0.4, 0.2]", "[0.0, 0.0, \"= width*turn/pi\", 0.2]");
    const Scene scene = parse_scene(text, "small.toml");
    CHECK(scene.parameters.at("width") == Approx(0.4));
    CHECK(scene.parameters.at("turn") == Approx(std::numbers::pi));
    CHECK(scene.water_boxes[0].high.x() == Approx(0.4));
    CHECK(scene.unused_parameters.empty());
    CHECK_THAT(scene.resolved, Contains("0.4") && !Contains("width*turn"));
}

TEST_CASE("errors in parameters and expressions name file, line and key", "[expressions]") {
    CHECK_THAT(samples::refusal(with_parameters("a = \"= b\"\nb = \"= a\"\n")),
               Contains("small.toml:") && Contains("key 'parameters.a'") && Contains("'b'"));
    CHECK_THAT(samples::refusal(with_parameters("a = \"3 lemons\"\n")),
               Contains("key 'parameters.a'") && Contains("lemons"));
    CHECK_THAT(samples::refusal(with_parameters("a = 3\n", "density = 1000.0", "density = \"= 1000*c\"")),
               Contains("key 'water.density'") && Contains("unknown name 'c'"));
    CHECK_THAT(samples::refusal(samples::with("density = 1000.0", "density = \"= 1000*c\"")),
               Contains("[parameters]"));
    // a number that does not suit its key is still refused there
    CHECK_THAT(samples::refusal(with_parameters("a = 3\n", "density = 1000.0", "density = \"= -a\"")),
               Contains("key 'water.density'"));
}

TEST_CASE("a run with another value of a parameter is another run", "[expressions]") {
    const std::string text =
        with_parameters("rho = 1000.0\nidle = 1.0\n", "density = 1000.0", "density = \"= rho\"");
    const auto identity = [&text](const std::vector<std::string>& overrides) {
        return setup_identity(parse_scene(text, "small.toml", std::nullopt, overrides));
    };
    CHECK(identity({}) == identity({"parameters.rho=1000"}));
    CHECK(identity({}) != identity({"parameters.rho=1010"}));
    CHECK(identity({}) == identity({"parameters.idle=2"}));
    CHECK(parse_scene(text, "small.toml").unused_parameters == std::vector<std::string>{"idle"});
}

TEST_CASE("a given motion follows parameters, and is another one with other values", "[expressions]") {
    const std::string text = with_parameters(
        "v = 0.1\n", "[model]",
        "[body]\noutline = { diameter = 0.1, corners = 24 }\nposition = [0.6, 0.3]\nmotion.y = { formula = "
        "\"constant\", velocity = \"= v\" }\n\n[model]");
    const auto guide = [&text](const std::string& value) {
        return parse_scene(text, "small.toml", std::nullopt, {"parameters.v=" + value}).bodies[0].guide;
    };
    CHECK_THAT(guide("0.1"), Contains("0.1"));
    CHECK(guide("0.1") != guide("0.2"));
}

TEST_CASE("a circle is a polygon about its centre", "[expressions]") {
    const std::string text = samples::with(
        "[model]",
        "[body]\noutline = { diameter = 0.1 }\nposition = [0.6, 0.3]\nfree = [\"y\"]\nmass = 5.0\n\n[model]");
    const Outline outline = parse_scene(text, "small.toml").bodies[0].outline;
    REQUIRE(outline.size() == 96);
    for (const Vec2& corner : outline) CHECK((corner - Vec2(0.6, 0.3)).norm() == Approx(0.05));
    CHECK(outline[0].y() == Approx(0.25));
    CHECK_THAT(samples::refusal(samples::replaced(text, "diameter = 0.1", "diameter = 0.1, corners = 7")),
               Contains("corners"));
    CHECK_THAT(samples::refusal(samples::replaced(text, "diameter = 0.1", "diameter = 0.1, corner = 9")),
               Contains("corner"));
}

// SPDX-License-Identifier: BSD-3-Clause
// What tells runs apart: set-up and scheme, never labels; and the table of the model's keys.
#include "validation/scene/identity.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/core/errors.hpp"
#include "tests/unit/scene/scene_samples.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/schemes.hpp"

using namespace wetdeck;
using samples::small_scene;

namespace {

Scene read(const std::string& text, const std::vector<std::string>& overrides = {},
           const std::string& variant = "two-phase") {
    return parse_scene(text, "small.toml", variant, overrides);
}

/// The small scene with one text replaced by another.
std::string with(const std::string& original, const std::string& other) {
    std::string text = small_scene;
    const std::size_t at = text.find(original);
    REQUIRE(at != std::string::npos);
    return text.replace(at, original.size(), other);
}

std::string identity(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return setup_identity(read(text, overrides));
}

}  // namespace

TEST_CASE("labels, tolerances, tiers and other variants do not change the identity of a run", "[identity]") {
    const std::string before = identity(small_scene);
    CHECK(identity("# a remark\n" + small_scene) == before);
    CHECK(identity(with("title = ", "title = \"Another title\" #")) == before);
    CHECK(identity(with("two-phase = [0.02]", "two-phase = [0.02, 0.01]")) == before);
    CHECK(identity(with("[variants.single-phase]", "[variants.single-phase]\nmodel.skin = 0.3")) == before);
    CHECK(identity(with("[[quantities]]",
                        "[[quantities]]\nname = \"extra\"\nmetric = \"mean\"\nseries = \"front\"\n\n"
                        "[[quantities]]")) == before);
}

TEST_CASE("everything that decides the results changes the identity of a run", "[identity]") {
    std::set<std::string> seen = {identity(small_scene)};
    for (const std::string assignment :
         {"run.end_time=0.1", "run.sample_interval=0.003", "run.frames=[0.07]", "model.dissipation_slope=9",
          "model.wall_slip=no", "model.air_substeps=5", "execution.skin=0.3", "execution.precision=double",
          "water.sound_speed=15", "air.viscosity=2e-5", "gravity=[0.0, -9.8]", "initial.surface=0.21",
          "scheme=without-dissipation"}) {
        INFO(assignment);
        CHECK(seen.insert(identity(small_scene, {assignment})).second);
    }
    CHECK(seen.insert(identity(with("[[0.0, 0.0, 0.4, 0.2]]", "[[0.0, 0.0, 0.4, 0.1]]"))).second);
}

TEST_CASE("a default that is written out is the same set-up; another default would be another one",
          "[identity]") {
    const std::string before = identity(small_scene);
    CHECK(identity(small_scene, {"model.dissipation_slope=10"}) == before);
    CHECK(identity(small_scene, {"execution.precision=mixed"}) == before);
    const nlohmann::json parameters = parameters_json(read(small_scene));
    for (const ModelKey& row : model_keys()) {
        INFO(row.dotted());
        CHECK(parameters.contains(row.dotted()));
    }
    CHECK(parameters.at("model.wall_pressure") == "shepard-water");
    CHECK(parameters.at("model.dissipation_switch") == false);
    CHECK(parameters.at("model.dissipation_slope") == 10);
}

TEST_CASE("every key of the model is set, read back and told apart", "[model_keys]") {
    const Scene plain = read(small_scene);
    std::set<std::string> names;
    for (const ModelKey& row : model_keys()) {
        INFO(row.dotted());
        CHECK(names.insert(row.dotted()).second);
        CHECK_FALSE(row.meaning.empty());
        CHECK(row.expected().size() > 3);
        Scene changed = plain;
        KeyValue other = row.get(plain);
        if (bool* flag = std::get_if<bool>(&other)) {
            *flag = !*flag;
        } else if (double* number = std::get_if<double>(&other)) {
            *number = row.odd ? 3 : 0.5 * (*number + std::min(row.high, 2 * *number + 1));
        } else {
            other = row.names.front() == std::get<std::string>(other) ? row.names.back() : row.names.front();
        }
        row.set(changed, other);
        CHECK(row.get(changed) == other);
        CHECK(parameters_of(changed) != parameters_of(plain));
        row.set(changed, row.get(plain));
        CHECK(parameters_of(changed) == parameters_of(plain));
    }
}

TEST_CASE("old names of keys are read, with a note; a mixture in one table is refused", "[model_keys]") {
    const Scene old_names = read(with("[model]", "[model]\nfull_cover = 0.5\nskin = 0.3"));
    CHECK(old_names.model.full_kernel_sum == 0.5);
    CHECK(old_names.execution.skin == 0.3);
    REQUIRE(old_names.notes.size() == 2);
    CHECK_THAT(old_names.notes.front(),
               Catch::StartsWith("small.toml:") && Catch::Contains("'model.full_cover' is called "
                                                                   "'model.full_kernel_sum' now"));
    CHECK(read(small_scene, {"model.tension=false"}).model.negative_pressure == false);
    CHECK(read(small_scene).notes.empty());
    CHECK_THROWS_WITH(read(with("[model]", "[model]\nfull_cover = 0.5\nfull_kernel_sum = 0.5")),
                      Catch::Contains("both are given"));
}

TEST_CASE("a scheme lies under the variant that names it; the variant and --set come on top", "[schemes]") {
    const std::string text =
        with("[variants.single-phase]",
             "[variants.single-phase]\nscheme = \"without-dissipation\"\nmodel.wall_dissipation = 2");
    const Scene scene = read(text, {"model.air_dissipation=0.5"}, "single-phase");
    CHECK(scene.model.dissipation == Dissipation::none);
    CHECK(scene.model.wall_dissipation == 2);
    CHECK(scene.model.air_dissipation == 0.5);
    // the stored text is complete: it names the scheme and holds it
    CHECK(parameters_of(parse_scene(scene.text, "elsewhere.toml", "single-phase", {})) ==
          parameters_of(read(text, {}, "single-phase")));
    CHECK_THAT(scene.text, Catch::Contains("[schemes.without-dissipation"));
    CHECK_THROWS_WITH(
        read(with("[variants.single-phase]", "[variants.single-phase]\nscheme = \"kraken\"")),
        Catch::StartsWith("small.toml:") &&
            Catch::Contains("key 'variants.single-phase.scheme': is 'kraken', expected one of "));
    const std::string own = small_scene + "\n[schemes.mine]\nmodel.dissipation_slope = 4.0\n";
    CHECK(read(own, {"scheme=mine"}).model.dissipation_slope == 4);
}

TEST_CASE("A scene computes in mixed precision where its model has it", "[scene][mixed]") {
    const auto precision = [](const std::vector<std::string>& overrides) {
        return read(small_scene, overrides).execution.precision;
    };
    CHECK(precision({}) == Precision::mixed);
    CHECK(precision({"execution.precision=double"}) == Precision::double_precision);
    CHECK(precision({"execution.skin=0.3"}) == Precision::mixed);
    CHECK(precision({"model.velocity_mean=harmonic"}) == Precision::double_precision);
    CHECK(precision({"model.dissipation_switch=true"}) == Precision::double_precision);
}

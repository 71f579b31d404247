// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/reference_kind.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

TEST_CASE("Each kind of reference is found by its name and described by its own row", "[reference]") {
    for (const ReferenceKindInfo& info : reference_kinds()) {
        CHECK(describe(info.kind).name == info.name);
        CHECK(reference_kind_named(info.name) == info.kind);
        CHECK(name_of(info.kind) == info.name);
    }
    CHECK(reference_kind_names() ==
          std::vector<std::string>{"experiment", "peer-simulation", "analytic", "stated"});
}

TEST_CASE("An unknown kind has neither a value nor a name", "[reference]") {
    CHECK_FALSE(reference_kind_named("rumour"));
    CHECK(name_of(std::nullopt).empty());
}

TEST_CASE("Only measurements validate; every other kind says why it does not", "[reference]") {
    for (const ReferenceKindInfo& info : reference_kinds()) {
        CHECK(info.validates == (info.kind == ReferenceKind::experiment));
        CHECK(std::string(info.not_counted).empty() == (info.validates || info.exact));
    }
}

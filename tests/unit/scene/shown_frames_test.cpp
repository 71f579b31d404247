// SPDX-License-Identifier: BSD-3-Clause
// Which fields the report shows, and so which `--fields key` keeps.
#include "validation/scene/shown_frames.hpp"

#include <catch2/catch.hpp>

using namespace wetdeck;

namespace {

Scene scene(const std::string& variant) {
    Scene made;
    made.variant = variant;
    made.analysis.default_variant = "a";
    made.end_time = 12;
    made.picture_times = {2.2, 7};
    for (int k = 0; k <= 120; ++k) made.frame_times.push_back(0.1 * k);
    return made;
}

}  // namespace

TEST_CASE("Of the default variant a dozen fields are shown, of others those that the scene names",
          "[frames]") {
    const std::vector<double> own = shown_frames(scene("b"));
    REQUIRE(own.size() == 2);
    CHECK(own[0] == Approx(2.2));
    CHECK(own[1] == Approx(7));
    const std::vector<double> shown = shown_frames(scene("a"));
    CHECK(shown.size() == 11);  // 7 s is wanted twice
    CHECK(shown.front() == Approx(1));
    CHECK(wanted_pictures(scene("a"), "b").size() == 2);
    Scene none = scene("a");
    none.frame_times.clear();
    CHECK(shown_frames(none).empty());
}

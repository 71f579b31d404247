// SPDX-License-Identifier: BSD-3-Clause
// Interpolation, cutting and comparison of any curves.
#include <algorithm>
#include <cmath>

#include "tests/property/generated.hpp"
#include "validation/metrics/resample.hpp"

using namespace wetdeck;

namespace {

/// Two to forty samples.
Curve draw_curve(const char* name) {
    const auto steps =
        *rc::gen::suchThat(rc::gen::container<std::vector<std::pair<double, double>>>(
                               rc::gen::pair(generated::number(1e-3, 2), generated::number(-5, 5))),
                           [](const auto& drawn) { return drawn.size() >= 2; })
             .as(std::string("steps and values of ") + name);
    Curve curve;
    double x = *generated::number(-10, 10).as(std::string("start of ") + name);
    for (const auto& [step, y] : steps) {
        curve.x.push_back(x += step);
        curve.y.push_back(y);
    }
    return curve;
}

double draw_in(const char* name, const Window& window) {
    return *generated::number(window.begin, window.end).as(name);
}

/// A window about the curve that may lie beyond it on either side, or inside it.
Window draw_window(const Curve& curve) {
    const Window all = extent(curve);
    const double room = all.end - all.begin;
    const double a = draw_in("one end", {all.begin - 0.2 * room, all.end + 0.2 * room});
    const double b = draw_in("other end", {all.begin - 0.2 * room, all.end + 0.2 * room});
    return {std::min(a, b), std::max(a, b)};
}

RunRecord record_of(const Curve& curve) {
    RunRecord record;
    record.series["s"].time = curve.x;
    record.series["s"].value = curve.y;
    return record;
}

}  // namespace

TEST_CASE("A curve interpolates to its samples, and between them to values between theirs",
          "[generated][curves]") {
    generated::check(200, [] {
        const Curve curve = draw_curve("the curve");
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            RC_ASSERT(interpolate(curve, curve.x[i]) == curve.y[i]);
        const double x = draw_in("x", extent(curve));
        const auto right =
            std::clamp<std::ptrdiff_t>(std::upper_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin(),
                                       1, static_cast<std::ptrdiff_t>(curve.x.size()) - 1);
        const auto [low, high] = std::minmax(curve.y[static_cast<std::size_t>(right - 1)],
                                             curve.y[static_cast<std::size_t>(right)]);
        RC_ASSERT(interpolate(curve, x) >= low);
        RC_ASSERT(interpolate(curve, x) <= high);
        RC_ASSERT(interpolate(curve, curve.x.front() - 1) == curve.y.front());
        RC_ASSERT(interpolate(curve, curve.x.back() + 1) == curve.y.back());
    });
}

TEST_CASE("A straight line is interpolated exactly, whatever its samples", "[generated][curves]") {
    generated::check(200, [] {
        Curve curve = draw_curve("the line");
        const double slope = *generated::number(-3, 3).as("slope");
        for (std::size_t i = 0; i < curve.x.size(); ++i) curve.y[i] = slope * curve.x[i] + 1;
        const double x = draw_in("x", extent(curve));
        RC_ASSERT(std::abs(interpolate(curve, x) - (slope * x + 1)) <
                  1e-12 * (1 + std::abs(slope * x)) * 100);
    });
}

TEST_CASE("A curve that is cut spans its part of the window and has the same values there",
          "[generated][curves]") {
    generated::check(300, [] {
        const Curve curve = draw_curve("the curve");
        const Window window = draw_window(curve);
        const Curve part = clip(curve, window);
        const auto common = overlap(curve, window);
        RC_ASSERT(common.has_value() == !part.x.empty());
        if (!common) return;
        RC_ASSERT(part.x.front() == common->begin);
        RC_ASSERT(part.x.back() == common->end);
        RC_ASSERT(common->begin == std::max(window.begin, curve.x.front()));
        RC_ASSERT(common->end == std::min(window.end, curve.x.back()));
        RC_ASSERT(part.x.size() == part.y.size());
        RC_ASSERT(std::adjacent_find(part.x.begin(), part.x.end(), std::greater_equal<>()) == part.x.end());
        const double x = draw_in("x", *common);
        RC_ASSERT(std::abs(interpolate(part, x) - interpolate(curve, x)) < 1e-9);
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (curve.x[i] > common->begin && curve.x[i] < common->end)
                RC_ASSERT(std::find(part.x.begin(), part.x.end(), curve.x[i]) != part.x.end());
        }
        const Curve again = clip(part, window);
        RC_ASSERT(again.x == part.x);
        RC_ASSERT(again.y == part.y);
    });
}

TEST_CASE("A curve covers the windows that it spans and no window that it does not reach",
          "[generated][curves]") {
    generated::check(200, [] {
        const Curve curve = draw_curve("the curve");
        const Window window = draw_window(curve);
        RC_PRE(window.end > window.begin);
        const bool spans = curve.x.front() <= window.begin && curve.x.back() >= window.end;
        if (spans) RC_ASSERT(covers(curve, window));
        const double end = curve.x.back(), room = window.end - window.begin;
        RC_ASSERT_FALSE(covers(curve, {end, end + room}));
        const double part = end - draw_in("x", extent(curve));
        RC_ASSERT_FALSE(covers(curve, {end - part, end + std::max(room, part)}));
    });
}

TEST_CASE("The difference of two curves is a distance", "[generated][curves]") {
    generated::check(80, [] {
        const Curve a = draw_curve("a"), b = draw_curve("b"), c = draw_curve("c");
        const Window window = draw_window(a);
        RC_ASSERT(rms_difference(a, a, window) == 0);
        RC_ASSERT(rms_difference(a, b, window) == rms_difference(b, a, window));
        RC_ASSERT(rms_difference(a, c, window) <=
                  rms_difference(a, b, window) + rms_difference(b, c, window) + 1e-12);
        Curve raised = a;
        const double by = *generated::number(-4, 4).as("by");
        for (double& y : raised.y) y += by;
        RC_ASSERT(std::abs(rms_difference(a, raised, window) - std::abs(by)) < 1e-12);
    });
}

TEST_CASE("The index of the maximum is that of the first largest value", "[generated][curves]") {
    generated::check(200, [] {
        Curve curve = draw_curve("the curve");
        for (double& y : curve.y) y = std::round(y);  // several of the same
        const std::size_t found = index_of_maximum(curve);
        for (std::size_t i = 0; i < curve.y.size(); ++i) {
            if (i < found) RC_ASSERT(curve.y[i] < curve.y[found]);
            RC_ASSERT(curve.y[i] <= curve.y[found]);
        }
    });
}

TEST_CASE("A scaled series times its scales is the series again", "[generated][curves]") {
    generated::check(200, [] {
        const Curve raw = draw_curve("the series");
        SeriesScaling scaling;
        scaling.x_offset = *generated::number(-5, 5).as("x offset");
        scaling.x_scale = *generated::number(0.01, 100).as("x scale");
        scaling.y_offset = *generated::number(-5, 5).as("y offset");
        scaling.y_scale = *generated::number(0.01, 100).as("y scale");
        const SeriesCurve scaled = series_curve(record_of(raw), "s", scaling);
        RC_ASSERT(scaled.problem.empty());
        RC_ASSERT(scaled.curve.x.size() == raw.x.size());
        for (std::size_t i = 0; i < raw.x.size(); ++i) {
            const double x = scaled.curve.x[i] * scaling.x_scale + scaling.x_offset;
            const double y = (scaled.curve.y[i] + scaling.y_offset) * scaling.y_scale;
            RC_ASSERT(std::abs(x - raw.x[i]) < 1e-11);
            RC_ASSERT(std::abs(y - raw.y[i]) < 1e-11);
        }
    });
}

TEST_CASE("A series that is spoilt at one sample is told, and kept up to there", "[generated][curves]") {
    generated::check(200, [] {
        Curve curve = draw_curve("the series");
        const auto last = static_cast<int>(curve.x.size()) - 1;
        const auto place = static_cast<std::size_t>(*generated::whole(1, last).as("spoilt"));
        switch (*generated::whole(0, 2).as("how")) {
            case 0:
                curve.y[place] = std::nan("");
                break;
            case 1:
                curve.x[place] = INFINITY;
                break;
            default:
                curve.x[place] = curve.x[place - 1];
        }
        const SeriesCurve found = series_curve(record_of(curve), "s");
        RC_ASSERT_FALSE(found.problem.empty());
        RC_ASSERT(found.curve.x.size() == place);
    });
}

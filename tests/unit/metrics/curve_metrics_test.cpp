// SPDX-License-Identifier: BSD-3-Clause
// Features of curves, and amplitude, timing and shape apart, for curves that differ in a known way.
#include "validation/metrics/curve_metrics.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "validation/metrics/curve_convergence.hpp"
#include "validation/metrics/resample.hpp"

using namespace wetdeck;

namespace {

constexpr Window window{0, 1};

Curve curve(const std::function<double(double)>& f) {
    Curve c;
    for (int i = 0; i <= 4000; ++i) {
        c.x.push_back(-0.5 + 2.0 * i / 4000);
        c.y.push_back(f(c.x.back()));
    }
    return c;
}

double pulse(double x) {
    return std::exp(-(x - 0.5) * (x - 0.5) / 0.005);
}

double feature(const std::vector<CurveFeature>& features, const std::string& name, bool simulated) {
    for (const CurveFeature& f : features)
        if (f.name == name) return (simulated ? f.simulated : f.reference).value();
    throw std::runtime_error("no such feature");
}

/// A curve that is its limit plus a multiple of h^2 of another shape.
Curve at_spacing(double h, double order = 2) {
    return curve([=](double x) { return x + 3 * std::pow(h, order) * (2 + std::cos(5 * x)); });
}

}  // namespace

TEST_CASE("A curve that is only higher differs in magnitude alone", "[curve_metrics]") {
    const CurveAgreement a =
        curve_agreement(curve([](double x) { return 1.25 * pulse(x); }), curve(pulse), window);
    CHECK(a.magnitude.value() == Approx(0.25));
    CHECK(a.phase.value() == Approx(0).margin(1e-7));
    CHECK(a.combined.value() == Approx(0.25));
    CHECK(a.amplitude_factor.value() == Approx(0.8));
    CHECK(a.time_shift.value() == Approx(0).margin(1e-12));
    CHECK(a.shape_error.value() == Approx(0).margin(1e-7));
}

TEST_CASE("A curve that is only late differs in phase alone, by its delay", "[curve_metrics]") {
    const double delay = GENERATE(0.05, -0.05);
    const CurveAgreement a =
        curve_agreement(curve([=](double x) { return pulse(x - delay); }), curve(pulse), window);
    CHECK(a.magnitude.value() == Approx(0).margin(1e-6));
    // the product of two Gaussians of width^2 0.005 / 2 a delay d apart falls as exp(-d^2 / 0.01)
    CHECK(a.phase.value() ==
          Approx(std::acos(std::exp(-delay * delay / 0.01)) / std::numbers::pi).epsilon(1e-4));
    CHECK(a.time_shift.value() == Approx(delay).margin(3e-4));
    CHECK(a.amplitude_factor.value() == Approx(1).epsilon(1e-4));
    CHECK(a.shape_error.value() < 2e-3);
}

TEST_CASE("A curve of another shape keeps a difference after shift and factor", "[curve_metrics]") {
    const CurveAgreement a =
        curve_agreement(curve([](double x) { return x > 0.4 && x < 0.6 ? 1.0 : 0.0; }), curve(pulse), window);
    CHECK(a.shape_error.value() > 0.1);
}

TEST_CASE("A sine against a cosine is half of pi out of phase", "[curve_metrics]") {
    const auto wave = [](double phase) {
        return curve([=](double x) { return std::sin(2 * std::numbers::pi * x + phase); });
    };
    const CurveAgreement a = curve_agreement(wave(0), wave(std::numbers::pi / 2), window);
    CHECK(a.phase.value() == Approx(0.5).margin(1e-3));
}

TEST_CASE("A curve that is zero has no agreement", "[curve_metrics]") {
    CHECK_FALSE(curve_agreement(curve([](double) { return 0.0; }), curve(pulse), window).phase.has_value());
}

TEST_CASE("Peak, its time, rise, impulse and mean of a triangle", "[curve_metrics]") {
    // from 0 at x = 0.2 to 2 at 0.6, back to 0 at 1.0
    const Curve triangle{{-0.5, 0.2, 0.6, 1.0, 1.5}, {0, 0, 2, 0, 0}};
    const auto features = curve_features(triangle, curve(pulse), window);
    CHECK(feature(features, "peak", true) == 2);
    CHECK(feature(features, "time of peak", true) == 0.6);
    CHECK(feature(features, "rise time", true) == Approx(0.8 * 0.4));
    CHECK(feature(features, "impulse", true) == Approx(0.8));
    CHECK(feature(features, "mean", true) == Approx(0.8));
    CHECK(feature(features, "impulse", false) == Approx(std::sqrt(std::numbers::pi * 0.005)));
}

TEST_CASE("A curve that is highest at an end of the window has no peak", "[curve_metrics]") {
    const auto features = curve_features(curve([](double x) { return x; }), curve(pulse), window);
    CHECK_FALSE(features[0].simulated.has_value());
    CHECK(features[0].reference.has_value());
    CHECK_FALSE(features[2].simulated.has_value());
}

TEST_CASE("The last ripple of a falling curve is no peak to judge by", "[curve_metrics]") {
    const auto judged = [](const std::function<double(double)>& f) {
        ComparisonResult c;
        c.window = window;
        c.simulated = c.measured = curve(f);
        c.features = curve_features(clip(c.simulated, window), clip(c.measured, window), window);
        return std::string(judged_feature(c));
    };
    CHECK(judged(pulse) == "peak");
    CHECK(judged([](double x) { return x; }) == "mean");
    // a body that slows down: the largest value is the last ripple
    const auto slowing = [](double x) { return -5 + 3 * x + 0.02 * std::sin(40 * x); };
    CHECK(judged(slowing) == "mean");
    // a peak above a plateau that is nearly as high
    CHECK(judged([](double x) { return x < 0.4 ? 2 * x : 0.8 + 0.05 * pulse(x); }) == "mean");
    CHECK(judged([](double x) { return x < 0.4 ? 2 * x : 0.8 + 0.3 * pulse(x); }) == "peak");
}

TEST_CASE("A curve of second order gives order 2.00 and its exact index", "[curve_convergence]") {
    const auto spacings =
        GENERATE(std::vector<double>{0.04, 0.02, 0.01}, std::vector<double>{0.05, 0.02, 0.015});
    std::vector<std::pair<double, Curve>> curves;
    for (const double h : spacings) curves.emplace_back(h, at_spacing(h));
    const CurveConvergenceRow row = curve_convergence(curves, window);
    CHECK(row.order.value() == Approx(2).epsilon(1e-6));
    CHECK(row.verdict == "monotonic");
    CHECK(row.monotone_share == 1);
    // rms over [0, 1] of 3 h^2 (2 + cos 5 x): mean of (2 + cos 5x)^2 = 4 + 4 sin 5 / 5 + 1/2 + sin 10 / 20
    const double shape = std::sqrt(4.5 + 0.8 * std::sin(5.0) + std::sin(10.0) / 20);
    const double error = 3 * spacings[2] * spacings[2] * shape;
    CHECK(row.gci_fine.value() == Approx(1.25 * error).epsilon(1e-3));
}

TEST_CASE("Curves that part, swing or are too few are called so", "[curve_convergence]") {
    CHECK(curve_convergence({{0.02, at_spacing(0.02)}, {0.01, at_spacing(0.01)}}, window).verdict ==
          "too few spacings");
    CHECK(curve_convergence({{0.04, at_spacing(0.01)}, {0.02, at_spacing(0.02)}, {0.01, at_spacing(0.04)}},
                            window)
              .verdict == "divergent");
    const auto raised = [](double by) { return curve([=](double x) { return x + by; }); };
    const CurveConvergenceRow swing =
        curve_convergence({{0.04, raised(0)}, {0.02, raised(0.4)}, {0.01, raised(0.3)}}, window);
    CHECK(swing.verdict == "oscillatory");
    CHECK(swing.monotone_share == 0);
    CHECK_FALSE(swing.gci_fine.has_value());
}

TEST_CASE("A curve that ends before the window does not count as a spacing", "[curve_convergence]") {
    Curve cut = at_spacing(0.01);
    cut.x.resize(2000);
    cut.y.resize(2000);
    const CurveConvergenceRow row =
        curve_convergence({{0.04, at_spacing(0.04)}, {0.02, at_spacing(0.02)}, {0.01, cut}}, window);
    CHECK(row.dx == std::vector<double>{0.04, 0.02});
    CHECK(row.verdict == "too few spacings");
}

TEST_CASE("Differences of curves relate to the range of the finest one", "[curve_convergence]") {
    CurveConvergenceRow row;
    row.difference = {0.4, 0.1};
    row.gci_fine = 0.05;
    CHECK(relative_differences(row).empty());  // a constant curve has no range
    CHECK_FALSE(relative_gci(row).has_value());
    row.range = 2;
    CHECK(relative_differences(row) == std::vector<double>{0.2, 0.05});
    CHECK(relative_gci(row) == 0.025);
}

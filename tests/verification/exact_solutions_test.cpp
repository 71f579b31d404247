// SPDX-License-Identifier: BSD-3-Clause
// What the problems are measured by, against what is known of it in closed form.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "validation/verification/boundary_elements.hpp"
#include "validation/verification/rotating_patch.hpp"

using namespace wetdeck;
using namespace wetdeck::verification;

TEST_CASE("Boundary elements reproduce a harmonic function", "[exact]") {
    const auto value = [](Vec2 at) { return at.x() * at.x() - at.y() * at.y() + 3 * at.x() * at.y(); };
    const auto gradient = [](Vec2 at) { return Vec2(2 * at.x() + 3 * at.y(), -2 * at.y() + 3 * at.x()); };
    const auto worst = [&](int n) {
        std::vector<Panel> panels;
        append_panels(panels, {2, 1}, {0, 1}, 2 * n);  // values here, slopes elsewhere
        append_panels(panels, {0, 1}, {0, 0}, n);
        append_panels(panels, {0, 0}, {2, 0}, 2 * n);
        append_panels(panels, {2, 0}, {2, 1}, n);
        const Eigen::Index valued = 2 * n, size = static_cast<Eigen::Index>(panels.size());
        Eigen::VectorXd given(size), expected(size);
        for (Eigen::Index k = 0; k < size; ++k) {
            const Panel& panel = panels[static_cast<std::size_t>(k)];
            const double slope = gradient(panel.middle()).dot(panel.normal());
            given[k] = k < valued ? value(panel.middle()) : slope;
            expected[k] = k < valued ? slope : value(panel.middle());
        }
        const Eigen::VectorXd found = mixed_solution(panels, valued) * given;
        return (found - expected).tail(size - valued).cwiseAbs().maxCoeff();
    };
    CHECK(worst(40) < 0.01 * 4);
    CHECK(worst(40) < 0.6 * worst(20));  // first order: values are even along the panels at the corners
}

TEST_CASE("The added mass of a half-submerged circle in fast heave is that of half a circle in open water",
          "[exact]") {
    constexpr double radius = 1, far = 40;
    std::vector<Panel> panels;
    const auto arc = [](double angle) { return Vec2(radius * std::cos(angle), radius * std::sin(angle)); };
    for (int k = 400; k > 0; --k) {  // finer towards the circle
        const auto place = [&](int n) { return radius + (far - radius) * std::pow(n / 400.0, 3); };
        panels.push_back({{place(k), 0}, {place(k - 1), 0}});
    }
    for (int k = 0; k < 400; ++k) {
        const auto place = [&](int n) { return radius + (far - radius) * std::pow(n / 400.0, 3); };
        panels.push_back({{-place(k), 0}, {-place(k + 1), 0}});
    }
    const auto surface = static_cast<Eigen::Index>(panels.size());
    constexpr int wet = 120;
    for (int k = 0; k < wet; ++k)
        panels.push_back({arc(-std::numbers::pi * k / wet), arc(-std::numbers::pi * (k + 1) / wet)});
    append_panels(panels, {-far, 0}, {-far, -far}, 40);
    append_panels(panels, {-far, -far}, {far, -far}, 80);
    append_panels(panels, {far, -far}, {far, 0}, 40);
    Eigen::VectorXd given = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(panels.size()));
    for (Eigen::Index k = surface; k < surface + wet; ++k)
        given[k] = panels[static_cast<std::size_t>(k)].normal().y();
    const Eigen::MatrixXd solution = mixed_solution(panels, surface);
    const Eigen::VectorXd found = solution * given;
    double added_mass = 0;
    for (Eigen::Index k = surface; k < surface + wet; ++k)
        added_mass += panels[static_cast<std::size_t>(k)].length() * given[k] * found[k];
    CHECK(added_mass == Approx(0.5 * std::numbers::pi * radius * radius).epsilon(0.01));

    // what heave moves through the surface, and the force of a potential on the surface, are one by Green's
    // second identity: without that, heave and waves would not exchange equal energies
    Eigen::VectorXd potential = Eigen::VectorXd::Zero(given.size());
    double flux = 0, work = 0, force = 0;
    for (Eigen::Index k = 0; k < surface; ++k) {
        const Panel& panel = panels[static_cast<std::size_t>(k)];
        potential[k] = std::exp(-std::pow(panel.middle().x() - 2, 2));
        flux += panel.length() * found[k];
        work += panel.length() * found[k] * potential[k];
    }
    const Eigen::VectorXd waves = solution * potential;
    for (Eigen::Index k = surface; k < surface + wet; ++k)
        force += panels[static_cast<std::size_t>(k)].length() * given[k] * waves[k];
    CHECK(flux == Approx(-2 * radius).epsilon(0.01));
    CHECK(force == Approx(-work).epsilon(0.01));
}

TEST_CASE("The tips of a rotating square of fluid fly straight on, its cells keep their areas", "[exact]") {
    const auto error = [](int cells) {
        RotatingPatch patch(1, 1, cells);
        patch.advance(2, 40);
        CHECK(patch.largest_area_error() < 1e-5);
        const Vec2 corner = patch.place_of({0.5, 0.5}), opposite = patch.place_of({-0.5, -0.5});
        CHECK((corner + opposite).norm() < 1e-9);
        return (corner - Vec2(-0.5, 1.5)).norm();
    };
    const double coarse = error(16), fine = error(32);
    CHECK(fine < 0.6 * coarse);  // first order
    CHECK(fine < 0.15);
}

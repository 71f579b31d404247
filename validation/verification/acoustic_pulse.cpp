// SPDX-License-Identifier: BSD-3-Clause
// A sound pulse meets the interface of two materials, from either side.
#include <cmath>
#include <numbers>

#include "solver/setup/initial_pressure.hpp"
#include "validation/verification/numerics.hpp"
#include "validation/verification/problems.hpp"
#include "validation/verification/setups.hpp"

namespace wetdeck::verification {
namespace {

using std::numbers::pi;

constexpr double amplitude = 1e-4;       // of rho c^2: squares do not matter
constexpr double channel_height = 0.12;  // [m]
constexpr double pulse_share = 0.1;      // half width of the pulse over the length of its layer
constexpr double start_share = 0.5,
                 end_share = 0.85;  // layers' lengths travelled: both waves are then clear of the interface

struct Case {
    std::string name, words;
    double light_density, light_sound_speed;  // of the light side; the heavy side is water with 30 m/s
    bool from_heavy;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> list = {
        {"water_to_air", "water to air, impedances 333 to 1", 1, 90, true},
        {"air_to_water", "air to water, impedances 1 to 333", 1, 90, false},
        {"heavy_to_light", "impedances 3 to 1", 250, 40, true},
        {"light_to_heavy", "impedances 1 to 3", 250, 40, false}};
    return list;
}

/// A channel with water in the left layer and the light fluid in the right, each as long as sound goes in one
/// time.
class Channel {
  public:
    Channel(const Case& c, double spacing)
        : model_(two_phase_model(30, c.light_sound_speed, 0)), dx_(spacing) {
        model_.air.eos.reference_density = c.light_density;
        heavy_length_ = 1;
        // a whole number of spacings
        light_length_ = spacing * std::round(c.light_sound_speed / 30 / spacing);
        from_heavy_ = c.from_heavy;
    }
    const TaitEquationOfState& incident() const { return from_heavy_ ? model_.water.eos : model_.air.eos; }
    const TaitEquationOfState& other() const { return from_heavy_ ? model_.air.eos : model_.water.eos; }
    double duration() const { return 1 / 30.0; }  ///< of sound through a layer
    double pulse_width() const { return pulse_share * duration() * incident().sound_speed; }
    double height() const { return channel_height; }

    /// Distance from the interface into the incident layer.
    double depth(double x) const { return from_heavy_ ? heavy_length_ - x : x - heavy_length_; }
    double pulse(double distance) const { return std::exp(-std::pow(distance / pulse_width(), 2)); }
    double scale() const { return amplitude * incident().coefficient() * incident().exponent; }

    Simulation simulate() {
        Setup setup(model_, {{0, 0}, {heavy_length_ + light_length_, height()}}, dx_, true);
        setup.fill(Phase::water, {{0, 0}, {heavy_length_, height()}});
        setup.fill(Phase::air, {{heavy_length_, 0}, {heavy_length_ + light_length_, height()}});
        const double start = start_share * duration() * incident().sound_speed;
        set_initial_pressure(setup.fluid, model_,
                             [&](Phase, Vec2 at) { return scale() * pulse(depth(at.x()) - start); });
        const double direction = from_heavy_ ? 1 : -1;
        const double impedance = incident().reference_density * incident().sound_speed;
        for (std::size_t i = 0; i < setup.fluid.size(); ++i) {
            FluidState& p = setup.fluid.state[i];
            p.vx = direction * p.pressure / impedance;
        }
        return setup.simulate();
    }

  private:
    Model model_;
    double dx_, heavy_length_ = 0, light_length_ = 0;
    bool from_heavy_ = true;
};

/// Diffusivity of a sound wave over c h, by the pressure jump in the intermediate velocity: half of
/// 1/2 INT |dW/dr| x^2 dA, because only density, one of the wave's two parts, diffuses.
double wave_diffusivity(double smoothing_ratio) {
    const WendlandC2 kernel{smoothing_ratio};
    const double moment =
        integral([&](double r) { return pi * r * r * r * r * kernel.slope_over_distance(r); }, 0,
                 kernel.support_radius());
    return 0.25 * moment;
}

void run(Findings& findings) {
    for (const Case& c : cases()) {
        VerificationFigure figure{"Sound pulse, " + c.words,
                                  "distance from the interface, into the second layer",
                                  "m",
                                  "pressure over the incident amplitude",
                                  "-",
                                  {},
                                  {}};
        for (const double dx : findings.levels({1.0 / 100, 1.0 / 200, 1.0 / 400})) {
            Channel channel(c, dx);
            Simulation simulation = channel.simulate();
            advance(simulation, end_share * channel.duration());

            const TaitEquationOfState &in = channel.incident(), &out = channel.other();
            const double z_in = in.reference_density * in.sound_speed,
                         z_out = out.reference_density * out.sound_speed;
            const double reflection = (z_out - z_in) / (z_out + z_in),
                         transmission = 2 * z_out / (z_out + z_in);
            const double travelled = (end_share - start_share) * channel.duration();
            // areas under the pulses: spreading leaves them alone
            double reflected = 0, transmitted = 0, moment = 0, reflected_moment = 0, peak = 0;
            const FluidParticles& fluid = simulation.fluid();
            std::vector<std::pair<double, double>> row;
            for (std::size_t i = 0; i < fluid.size(); ++i) {
                const FluidState& p = fluid.state[i];
                const double depth = channel.depth(p.x), share = p.pressure * p.volume / channel.height();
                (depth > 0 ? reflected : transmitted) += share;
                if (depth < 0) moment += share * -depth;
                if (depth > 0) reflected_moment += share * depth;
                if (depth > 0) peak = std::max(peak, std::abs(p.pressure));
                if (std::abs(p.y - 0.5 * channel.height()) < 0.9 * dx && p.y > 0.5 * channel.height())
                    row.emplace_back(-depth, p.pressure / channel.scale());
            }
            const double area = channel.scale() * channel.pulse_width() * std::sqrt(pi);
            const double resolution = dx / channel.pulse_width();
            const double stretch = out.sound_speed / in.sound_speed;
            findings.record("transmission_" + c.name, resolution,
                            std::abs(transmitted / area / stretch / transmission - 1));
            findings.record("reflection_" + c.name, resolution, std::abs(reflected / area / reflection - 1));
            const double arrival =
                (travelled - moment / transmitted / out.sound_speed) / (end_share * channel.duration());
            findings.record("arrival_" + c.name, resolution, std::abs(arrival));
            const double back = (travelled - reflected_moment / reflected / in.sound_speed) /
                                (end_share * channel.duration());
            findings.record("return_" + c.name, resolution, std::abs(back));
            findings.record("peak_" + c.name, resolution,
                            std::abs(peak / (channel.scale() * std::abs(reflection)) - 1));
            const Curve curve = sorted_curve(row);
            figure.computed.push_back({"dx = " + std::to_string(dx).substr(0, 5) + " m", curve});
            figure.exact = {};
            for (const double x : curve.x) {
                const double d = in.sound_speed * travelled;
                figure.exact.x.push_back(x);
                figure.exact.y.push_back(x < 0 ? reflection * channel.pulse(-x - d)
                                               : transmission * channel.pulse((x / stretch - d)));
            }
        }
        findings.figure(std::move(figure));
    }
    findings.note(
        "The pressure jump in the intermediate velocity diffuses sound: the peak of a pulse falls as that of "
        "heat "
        "with a diffusivity of " +
        std::to_string(wave_diffusivity(Model{}.smoothing_ratio)) +
        " c dx, to first order in dx. Areas and arrival are not touched by it.");
}

}  // namespace

Problem acoustic_pulse() {
    Problem problem;
    problem.name = "acoustic_pulse";
    problem.title = "Sound pulse through an interface";
    problem.exact =
        "Acoustics: R = (Z2 - Z1)/(Z2 + Z1), T = 2 Z2/(Z2 + Z1), each wave at its own speed of sound.";
    const std::string resolution = "dx / half width of the incident pulse";
    constexpr double coarsest_spacing = 0.01;
    // along a free-slip wall a strip of one smoothing length loses up to half the divergence: 2 h / height /
    // 2, half of which is lost by the sound speed
    const double wall_share = 0.5 * Model{}.smoothing_ratio * coarsest_spacing / channel_height;
    // the peak of a Gaussian that diffuses: 1 - 1/sqrt(1 + 4 D t / width^2)
    const double spread = 4 * wave_diffusivity(Model{}.smoothing_ratio) * coarsest_spacing * end_share /
                          (pulse_share * pulse_share);
    for (const Case& c : cases()) {
        const double heavy = 1000 * 30, light = c.light_density * c.light_sound_speed;
        const double r = (heavy - light) / (heavy + light);
        const std::string why =
            "walls take up to half the divergence in a strip of one smoothing length: 6 % of the sound "
            "speed at 12 spacings across, first order";
        problem.claims.push_back({"transmission_" + c.name,
                                  "relative error of the transmitted area, " + c.words, resolution,
                                  wall_share, Window{0.6, 1.6}, why});
        problem.claims.push_back({"arrival_" + c.name,
                                  "relative error of the transmitted pulse's time of arrival, " + c.words,
                                  resolution, wall_share, Window{0.6, 1.6}, why});
        Claim back{"return_" + c.name, "relative error of the reflected pulse's time of return, " + c.words,
                   resolution,         wall_share,
                   Window{0.6, 1.6},   why};
        if (c.from_heavy) {
            back.bound = 0.5 * coarsest_spacing / end_share;
            back.order = {};
            back.reason =
                "half a spacing of the interface's place: water moves along the walls and loses no "
                "divergence there. No "
                "order expected of so little";
        }
        problem.claims.push_back(back);
        problem.claims.push_back(
            {"reflection_" + c.name,
             "relative error of the reflected area, " + c.words,
             resolution,
             0.5 * (1 - r * r) * wall_share / r + 0.002,
             {},
             "the change of R with the impedances, themselves wrong by that of the sound speeds, and 0.2 % "
             "for the tail of the pulse in the interface"});
        const double stretched = spread * (c.from_heavy ? 1 : 30 / c.light_sound_speed);
        problem.claims.push_back(
            {"peak_" + c.name, "relative error of the reflected peak, " + c.words, resolution,
             1.2 * (1 - 1 / std::sqrt(1 + stretched)), Window{0.5, 1.2},
             "diffusion of sound by the pressure jump in u*, in closed form, and 20 % for the interface: "
             "first order, less while the spreading is large"});
    }
    problem.run = run;
    return problem;
}

}  // namespace wetdeck::verification

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/stress/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/probes/energy.hpp"
#include "validation/run/field_frame.hpp"
#include "validation/run/last_good_frame.hpp"
#include "validation/store/raster.hpp"

namespace wetdeck::stress {
namespace {

constexpr std::uint64_t steps_between_frames = 16, steps_between_checks = 64;

/// Of the fluid, and what bodies have taken of it: grows by errors alone.
double energy(const Simulation& simulation, const Balance& b) {
    double sum = b.kinetic + b.potential + b.compression;
    for (const RigidBody& body : simulation.bodies()) sum += body.work;
    return sum;
}

/// The energy that gains are divided by: all energy at the start.
double energy_scale(const Simulation& simulation, const Balance& b) {
    double sum = b.kinetic + b.potential;
    for (const RigidBody& body : simulation.bodies()) sum += body.kinetic_energy();
    return sum;
}

/// Index of the particle that became unstable, if it is one.
std::optional<std::size_t> index_of(const FieldFrame& frame, const Instability& instability) {
    if (!instability.particle) return std::nullopt;
    for (std::size_t i = 0; i < frame.id.size(); ++i)
        if (frame.phase[i] < 2 && frame.id[i] == static_cast<std::int64_t>(*instability.particle)) return i;
    return std::nullopt;
}

std::string surroundings(const FieldFrame& frame, std::size_t self, const Simulation& simulation) {
    const double reach = simulation.kernel().support_radius(), dx = simulation.particle_spacing();
    int water = 0, air = 0, wall = 0, body = 0;
    double nearest = reach;
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        const double distance = std::hypot(frame.x[i] - frame.x[self], frame.y[i] - frame.y[self]);
        if (i == self || distance > reach) continue;
        nearest = std::min(nearest, distance);
        ++(frame.phase[i] == 0 ? water : frame.phase[i] == 1 ? air : frame.phase[i] == 2 ? wall : body);
    }
    const bool is_water = frame.phase[self] == 0;
    const TaitEquationOfState& eos = is_water ? simulation.model().water.eos : simulation.model().air.eos;
    return fmt::format(
        "{} particle among {} of water, {} of air, {} of the tank, {} of a body, the nearest at {:.2f} dx; "
        "density {:.3g} of the reference, gauge pressure {:.3g} Pa, Mach {:.2g}",
        is_water ? "water" : "air", water, air, wall, body, nearest / dx,
        frame.density[self] / eos.reference_density, frame.pressure[self],
        std::hypot(frame.vx[self], frame.vy[self]) / eos.sound_speed);
}

Failure failure_of(const Simulation& simulation, const Instability& instability, FieldFrame frame) {
    Failure failure;
    failure.instability = instability;
    failure.position = instability.position;
    failure.particle_spacing = simulation.particle_spacing();
    if (const auto self = index_of(frame, instability)) {
        failure.position = {frame.x[*self], frame.y[*self]};
        failure.surroundings = surroundings(frame, *self, simulation);
    }
    failure.frame = std::move(frame);
    return failure;
}

}  // namespace

std::string Outcome::note() const {
    std::string text;
    if (failure) {
        text = "became unstable " + failure->instability.describe();
        if (!failure->surroundings.empty()) text += "; before that " + failure->surroundings;
        text += "; ";
    }
    return text + fmt::format("{} steps, density error {:.2g}, energy gained {:.2g}", steps, density_error,
                              energy_gain);
}

Outcome run_trial(Trial trial) {
    Simulation& s = trial.simulation;
    Outcome outcome;
    const Balance start = balance(s);
    const double energy_before = energy(s, start), scale = energy_scale(s, start);
    std::optional<Instability> instability;
    LastGoodFrame last_good(inspection_interval(s, steps_between_frames));
    last_good.set(frame_of(s, ""));
    const std::uint64_t between_checks = inspection_interval(s, steps_between_checks);
    while (!instability && s.time() < trial.end && s.steps() < trial.most_steps) {
        instability = s.step(trial.end - s.time());
        const bool last = s.time() >= trial.end;
        const bool check = s.steps() % between_checks == 0 || last;
        if (!instability && check && trial.watch) instability = trial.watch(s);
        if (instability) break;
        last_good.update(s, "");
        if (!check) continue;
        const Balance b = balance(s);
        outcome.density_error = std::max(outcome.density_error, b.water_density_error);
        if (scale > 0)
            outcome.energy_gain = std::max(outcome.energy_gain, (energy(s, b) - energy_before) / scale);
    }
    outcome.steps = s.steps();
    if (instability) outcome.failure = failure_of(s, *instability, last_good.frame());
    return outcome;
}

std::vector<unsigned char> picture_of(const Failure& failure) {
    constexpr double half_width = 20;  // [spacings]
    RasterOptions options;
    options.width = 800;
    const double reach = half_width * failure.particle_spacing;
    options.x_min = failure.position.x() - reach;
    options.x_max = failure.position.x() + reach;
    options.y_min = failure.position.y() - reach;
    options.y_max = failure.position.y() + reach;
    options.particle_radius = 0.4 * failure.particle_spacing;  // gaps and clumps are to be seen
    const FieldFrame& f = failure.frame;
    double low = 0, high = 1, fastest = 1e-9;
    for (std::size_t i = 0; i < f.x.size(); ++i) {
        if ((Vec2(f.x[i], f.y[i]) - failure.position).cwiseAbs().maxCoeff() > reach) continue;
        if (f.phase[i] == 0)
            low = std::min<double>(low, f.pressure[i]), high = std::max<double>(high, f.pressure[i]);
        if (f.phase[i] == 1) fastest = std::max<double>(fastest, std::hypot(f.vx[i], f.vy[i]));
    }
    options.water_min = low;
    options.water_max = high;
    options.air_speed_max = fastest;
    return render_png(f, options);
}

}  // namespace wetdeck::stress

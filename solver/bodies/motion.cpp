// SPDX-License-Identifier: BSD-3-Clause
#include "solver/bodies/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

void check_samples(const Curve& curve, std::size_t least) {
    if (curve.x.size() < least || curve.x.size() != curve.y.size())
        throw InputError("a motion needs at least " + std::to_string(least) + " samples");
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        if (!std::isfinite(curve.x[k]) || !std::isfinite(curve.y[k]))
            throw InputError("a motion needs finite samples");
        if (k > 0 && !(curve.x[k] > curve.x[k - 1])) throw InputError("the times of a motion must increase");
    }
}

/// The number of the interval that holds a time: 0 before the first sample, the last one after the last.
std::size_t interval_of(const std::vector<double>& times, double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    const auto k = static_cast<std::size_t>(after - times.begin());
    return std::clamp<std::size_t>(k, 1, times.size() - 1) - 1;
}

/// Slopes at the samples: the weighted harmonic mean of the slopes on both sides, 0 at an extreme; at the
/// ends that of the parabola through three samples, limited.
std::vector<double> monotone_slopes(const Curve& c) {
    const std::size_t n = c.x.size();
    std::vector<double> step(n - 1), secant(n - 1), slope(n);
    for (std::size_t k = 0; k + 1 < n; ++k) {
        step[k] = c.x[k + 1] - c.x[k];
        secant[k] = (c.y[k + 1] - c.y[k]) / step[k];
    }
    if (n == 2) return {secant[0], secant[0]};
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double before = secant[k - 1], after = secant[k];
        if (!(before * after > 0)) continue;
        const double w1 = 2 * step[k] + step[k - 1], w2 = step[k] + 2 * step[k - 1];
        slope[k] = (w1 + w2) / (w1 / before + w2 / after);
    }
    const auto end = [](double h0, double h1, double s0, double s1) {
        const double parabola = ((2 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
        if (!(parabola * s0 > 0)) return 0.0;
        return s0 * s1 < 0 && std::abs(parabola) > 3 * std::abs(s0) ? 3 * s0 : parabola;
    };
    slope[0] = end(step[0], step[1], secant[0], secant[1]);
    slope[n - 1] = end(step[n - 2], step[n - 3], secant[n - 2], secant[n - 3]);
    return slope;
}

}  // namespace

Motion sampled_motion(const Curve& displacement) {
    check_samples(displacement, 2);
    return [c = displacement, slopes = monotone_slopes(displacement)](double time) -> MotionState {
        const std::size_t last = c.x.size() - 1;
        if (time < c.x[0]) return {c.y[0] + slopes[0] * (time - c.x[0]), slopes[0], 0};
        if (time > c.x[last]) return {c.y[last] + slopes[last] * (time - c.x[last]), slopes[last], 0};
        const std::size_t k = interval_of(c.x, time);
        const double h = c.x[k + 1] - c.x[k], s = time - c.x[k];
        const double secant = (c.y[k + 1] - c.y[k]) / h;
        const double c2 = (3 * secant - 2 * slopes[k] - slopes[k + 1]) / h;
        const double c3 = (slopes[k] + slopes[k + 1] - 2 * secant) / (h * h);
        if (time == c.x[k + 1]) return {c.y[k + 1], slopes[k + 1], 2 * c2 + 6 * c3 * h};
        return {c.y[k] + s * (slopes[k] + s * (c2 + s * c3)), slopes[k] + s * (2 * c2 + 3 * s * c3),
                2 * c2 + 6 * s * c3};
    };
}

Motion from_start(const Motion& motion) {
    return [motion, at_start = motion(0).displacement](double time) {
        MotionState state = motion(time);
        state.displacement -= at_start;
        return state;
    };
}

Motion piecewise_linear_velocity(const Curve& velocity) {
    check_samples(velocity, 1);
    std::vector<double> moved(velocity.x.size(), 0.0);  // since the first sample
    for (std::size_t k = 1; k < moved.size(); ++k)
        moved[k] =
            moved[k - 1] + 0.5 * (velocity.y[k] + velocity.y[k - 1]) * (velocity.x[k] - velocity.x[k - 1]);
    const Motion since_first = [c = velocity, moved](double time) -> MotionState {
        const std::size_t last = c.x.size() - 1;
        if (time <= c.x[0]) return {c.y[0] * (time - c.x[0]), c.y[0], 0};
        if (time >= c.x[last]) return {moved[last] + c.y[last] * (time - c.x[last]), c.y[last], 0};
        const std::size_t k = interval_of(c.x, time);
        const double s = time - c.x[k], a = (c.y[k + 1] - c.y[k]) / (c.x[k + 1] - c.x[k]);
        return {moved[k] + s * (c.y[k] + 0.5 * a * s), c.y[k] + a * s, a};
    };
    return from_start(since_first);
}

Motion harmonic_motion(const Harmonic& harmonic) {
    if (!(harmonic.period > 0)) throw InputError("a harmonic motion needs a positive period");
    if (!(harmonic.ramp >= 0)) throw InputError("the ramp of a harmonic motion must not be negative");
    return [harmonic](double time) -> MotionState {
        const double w = 2 * std::numbers::pi / harmonic.period, angle = w * time + harmonic.phase;
        const double q = harmonic.amplitude * std::sin(angle), v = harmonic.amplitude * w * std::cos(angle);
        const double a = -w * w * q;
        if (!(time < harmonic.ramp)) return {q, v, a};
        const double s = std::max(0.0, time / harmonic.ramp), per = 1 / harmonic.ramp;
        const double g = s * s * s * (10 - 15 * s + 6 * s * s);
        const double g1 = 30 * s * s * (1 - s) * (1 - s) * per;
        const double g2 = 60 * s * (1 - s) * (1 - 2 * s) * per * per;
        return {g * q, g1 * q + g * v, g2 * q + 2 * g1 * v + g * a};
    };
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/run_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

const std::string solver_prefix = "solver.", override_prefix = "override.", frame_prefix = "last_good.";

/// Visits the columns of a frame by name.
template <class Frame, class Visit>
void for_each_column(Frame& frame, const Visit& visit) {
    visit("x", frame.x);
    visit("y", frame.y);
    visit("vx", frame.vx);
    visit("vy", frame.vy);
    visit("pressure", frame.pressure);
    visit("density", frame.density);
    if (!frame.spacing.empty()) visit("spacing", frame.spacing);
    visit("phase", frame.phase);
    visit("id", frame.id);
}

/// The entries behind a prefix, without it.
template <class Map>
Map behind(const std::string& prefix, const Map& entries) {
    Map result;
    for (const auto& [name, value] : entries) {
        if (name.starts_with(prefix)) result.emplace(name.substr(prefix.size()), value);
    }
    return result;
}

}  // namespace

void save_request(Checkpoint& checkpoint, const Scene& scene, const RunOptions& options) {
    checkpoint.texts["scene_text"] = scene.text;
    checkpoint.texts["scene_path"] = scene.path;
    checkpoint.texts["variant"] = scene.variant;
    for (std::size_t n = 0; n < scene.overrides.size(); ++n)
        checkpoint.texts[fmt::format("{}{:06}", override_prefix, n)] = scene.overrides[n];
    checkpoint.numbers["particle_spacing"] = options.particle_spacing;
    checkpoint.numbers["fields"] = static_cast<double>(options.fields);
    if (options.until) checkpoint.numbers["until"] = *options.until;
}

Scene scene_in(const Checkpoint& checkpoint) {
    std::vector<std::string> overrides;
    for (const auto& [number, assignment] : behind(override_prefix, checkpoint.texts))
        overrides.push_back(assignment);
    return parse_scene(checkpoint.text("scene_text"), checkpoint.text("scene_path"),
                       checkpoint.text("variant"), overrides);
}

RunOptions options_in(const Checkpoint& checkpoint) {
    RunOptions options;
    options.particle_spacing = checkpoint.number("particle_spacing");
    if (checkpoint.numbers.count("fields") > 0)  // checkpoints of earlier revisions have all
        options.fields = static_cast<Fields>(checkpoint.number("fields"));
    if (checkpoint.numbers.count("until") > 0) options.until = checkpoint.number("until");
    return options;
}

void save_simulation(Checkpoint& checkpoint, const Simulation& simulation) {
    Simulation::State state = simulation.state();
    for (auto& [name, values] : state.arrays) checkpoint.arrays[solver_prefix + name] = std::move(values);
    for (const auto& [name, number] : state.numbers) checkpoint.numbers[solver_prefix + name] = number;
}

void restore_simulation(const Checkpoint& checkpoint, Simulation& simulation) {
    simulation.restore({behind(solver_prefix, checkpoint.arrays), behind(solver_prefix, checkpoint.numbers)});
}

void save_frame(Checkpoint& checkpoint, const FieldFrame& frame) {
    checkpoint.numbers[frame_prefix + "time"] = frame.time;
    for_each_column(frame, [&](const char* name, const auto& values) {
        checkpoint.arrays[frame_prefix + name].assign(values.begin(), values.end());
    });
}

FieldFrame frame_in(const Checkpoint& checkpoint) {
    FieldFrame frame;
    frame.time = checkpoint.number(frame_prefix + "time");
    if (checkpoint.arrays.count(frame_prefix + "spacing") > 0) frame.spacing.resize(1);  // to be read
    for_each_column(frame, [&](const char* name, auto& values) {
        values.clear();
        for (const double stored : checkpoint.array(frame_prefix + name))
            values.push_back(static_cast<typename std::decay_t<decltype(values)>::value_type>(stored));
    });
    return frame;
}

void CheckpointClock::restart(double cost) {
    constexpr double share = 0.01;
    const std::chrono::duration<double> pause(interval_ > 0 ? std::max(interval_, cost / share) : 0);
    next_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(pause);
}

}  // namespace wetdeck

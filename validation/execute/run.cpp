// SPDX-License-Identifier: BSD-3-Clause
#include "validation/execute/run.hpp"

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <ctime>

#include "solver/core/errors.hpp"
#include "validation/execute/assemble.hpp"
#include "validation/store/fields.hpp"
#include "validation/store/live_series.hpp"
#include "validation/store/provenance.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

double processor_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

FieldFrame frame_of(const Simulation& simulation) {
    constexpr int wall = 2;
    FieldFrame frame;
    frame.time = simulation.time();
    const auto add = [&frame](double x, double y, double vx, double vy, double p, double rho, int phase,
                              std::int64_t id) {
        frame.x.push_back(x);
        frame.y.push_back(y);
        frame.vx.push_back(vx);
        frame.vy.push_back(vy);
        frame.pressure.push_back(p);
        frame.density.push_back(rho);
        frame.phase.push_back(phase);
        frame.id.push_back(id);
    };
    const FluidParticles& fluid = simulation.fluid();
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        const FluidState& p = fluid.state[i];
        const double background = simulation.model().water.eos.background_pressure;
        add(p.x, p.y, p.vx, p.vy, p.pressure - background, p.density, static_cast<int>(fluid.phase(i)),
            fluid.id[i]);
    }
    const WallParticles& walls = simulation.walls();
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const WallState& w = walls.state[i];
        const double rho0 = simulation.model().water.eos.reference_density;
        const bool fixed = i < walls.fixed;
        const int phase = fixed ? wall : wall + 1 + static_cast<int>(walls.body_point[i - walls.fixed].body);
        add(w.x, w.y, w.vx, w.vy, 0, rho0, phase, static_cast<std::int64_t>(fluid.size() + walls.id[i]));
    }
    return frame;
}

/// Samples the recorders at their interval, keeps the series, and mirrors them in the live file.
class SeriesKeeper {
  public:
    SeriesKeeper(const Scene& scene, const RunOptions& options)
        : recorders_(scene, options.particle_spacing),
          interval_(scene.sample_interval),
          live_(options.directory, columns(recorders_)) {
        for (const SeriesInfo& r : recorders_.list()) kept_.push_back({r.unit, r.description, {}, {}, {}});
    }

    void observe(const Simulation& simulation, bool last) {
        if (simulation.time() < next_ && !last) return;
        if (!times_.empty() && simulation.time() <= times_.back()) return;
        while (next_ <= simulation.time()) next_ += interval_;
        recorders_.sample(simulation, values_);
        live_.append(simulation.time(), values_);
        times_.push_back(simulation.time());
        for (std::size_t k = 0; k < values_.size(); ++k) kept_[k].value.push_back(values_[k]);
    }

    std::map<std::string, Series> series() const {
        std::map<std::string, Series> result;
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            Series& series = result[recorders_.list()[k].name] = kept_[k];
            series.time = times_;
        }
        return result;
    }

  private:
    static std::vector<LiveColumn> columns(const Recorders& recorders) {
        std::vector<LiveColumn> result;
        for (const SeriesInfo& r : recorders.list()) result.push_back({r.name, r.unit, r.description});
        return result;
    }

    Recorders recorders_;
    double interval_;
    double next_ = 0;
    LiveSeries live_;
    std::vector<double> times_, values_;
    std::vector<Series> kept_;
};

void record_parameters(RunRecord& record, const Scene& scene, const Simulation& simulation) {
    const Model& m = simulation.model();
    auto& p = record.parameters;
    p["particle_spacing"] = record.particle_spacing;
    p["smoothing_length"] = simulation.kernel().smoothing_length;
    p["gravity_x"] = m.gravity.x();
    p["gravity_y"] = m.gravity.y();
    p["water.density"] = m.water.eos.reference_density;
    p["water.sound_speed"] = m.water.eos.sound_speed;
    p["water.exponent"] = m.water.eos.exponent;
    p["water.viscosity"] = m.water.viscosity;
    if (scene.air) {
        p["air.density"] = m.air.eos.reference_density;
        p["air.sound_speed"] = m.air.eos.sound_speed;
        p["air.exponent"] = m.air.eos.exponent;
        p["air.viscosity"] = m.air.viscosity;
    }
    p["model.background_pressure"] = m.water.eos.background_pressure;
    p["model.pressure_diffusion"] = m.pressure_diffusion;
    p["model.dissipation_slope"] = m.dissipation_slope;
    p["model.air_dissipation"] = m.air_dissipation;
    p["model.wall_dissipation"] = m.wall_dissipation;
    p["model.smoothing_ratio"] = m.smoothing_ratio;
    p["model.courant_number"] = m.courant_number;
    p["model.skin"] = m.skin;
    p["run.end_time"] = scene.end_time;
    record.choices["resolved_scene"] = scene.resolved;
    record.choices["air"] = scene.air ? "yes" : "no";
}

void record_cost(RunRecord& record, const Simulation& simulation) {
    RunCost& cost = record.cost;
    cost.steps = simulation.steps();
    cost.particle_steps =
        static_cast<double>(simulation.steps()) * static_cast<double>(simulation.fluid().size());
    cost.peak_rss_mb = peak_rss_mb();
    const StageTimes& s = simulation.stage_times();
    cost.stage_seconds = {{"neighbours", s.neighbours},   {"density", s.density},
                          {"momentum", s.momentum},       {"walls", s.walls},
                          {"integration", s.integration}, {"probes and files", s.probes}};
    for (std::size_t k = 0; k < limiting_criterion_names.size(); ++k) {
        cost.limiting_criterion[limiting_criterion_names[k]] = simulation.limiting_counts()[k];
    }
    record.parameters["neighbour_list_builds"] = static_cast<double>(simulation.list_builds());
    record.parameters["bytes_per_particle"] = simulation.bytes_per_particle();
}

}  // namespace

std::string identity_of(const Scene& scene, const RunOptions& options) {
    return run_identity(
        scene.name(), scene.variant, options.particle_spacing,
        fmt::format("{}\nuntil = {}", scene.resolved, options.until.value_or(scene.end_time)));
}

RunRecord run_scene(const Scene& scene, const RunOptions& options, Progress& progress) {
    check_spacing(scene, options.particle_spacing);
    const double end = options.until.value_or(scene.end_time);
    if (!(end > 0)) throw InputError(fmt::format("--until is {}, expected a positive time [s]", end));
    const RunDirectory directory(options.directory, identity_of(scene, options),
                                 options.replace ? OnConflict::replace : OnConflict::refuse);

    const auto start = std::chrono::steady_clock::now();
    const double processor_start = processor_seconds();
    Simulation simulation = assemble(scene, options.particle_spacing, options.threads);
    RunRecord record;
    record.scene = scene.name();
    record.variant = scene.variant;
    record.particle_spacing = options.particle_spacing;
    record.fluid_particles = simulation.fluid().size();
    record.particles = simulation.fluid().size() + simulation.walls().size();
    record.scene_text = scene.text;
    record.scene_path = scene.path;
    collect_provenance(simulation.instruction_set(), static_cast<unsigned>(simulation.threads()))
        .add_to(record.choices);
    record_parameters(record, scene, simulation);

    SeriesKeeper keeper(scene, options);
    FieldWriter fields(options.directory);
    std::size_t next_frame = 0;
    FieldFrame last_good;  // what an unstable run leaves behind; more often while the run is young
    const auto observe = [&](const Simulation& s) {
        keeper.observe(s, s.time() >= end);
        if (next_frame < scene.frame_times.size() && s.time() >= scene.frame_times[next_frame]) {
            while (next_frame < scene.frame_times.size() && s.time() >= scene.frame_times[next_frame])
                ++next_frame;
            fields.write(frame_of(s));
        }
        constexpr std::uint64_t steps_between = 256;
        if (s.steps() % steps_between == 0 || (s.steps() < steps_between && std::has_single_bit(s.steps())))
            last_good = frame_of(s);
        if (s.steps() % 64 == 0)
            progress.update(s.time() / end,
                            fmt::format("t = {:.4g} of {:.4g} s, step {}", s.time(), end, s.steps()));
    };
    if (const std::optional<Instability> trouble = simulation.run(end, observe)) {
        record.status = RunStatus::unstable;
        record.stop_reason = trouble->describe();
        if (fields.frames().empty() || last_good.time > fields.frames().back().time) fields.write(last_good);
    }
    record.series = keeper.series();
    record.cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    record.cost.core_s = processor_seconds() - processor_start;
    record_cost(record, simulation);
    write_run(options.directory, record);
    std::error_code ignored;
    std::filesystem::remove(live_file(options.directory), ignored);
    return record;
}

}  // namespace wetdeck

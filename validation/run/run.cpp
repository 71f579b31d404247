// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "solver/core/processor_seconds.hpp"
#include "solver/scheme_revision.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/metrics/time_origin.hpp"
#include "validation/run/assemble.hpp"
#include "validation/run/contact_monitor.hpp"
#include "validation/run/field_frame.hpp"
#include "validation/run/field_time_series.hpp"
#include "validation/run/last_good_frame.hpp"
#include "validation/run/penetration_monitor.hpp"
#include "validation/run/release_at_contact.hpp"
#include "validation/run/run_state.hpp"
#include "validation/run/stop_signal.hpp"
#include "validation/run/time_series.hpp"
#include "validation/scene/identity.hpp"
#include "validation/scene/model_keys.hpp"
#include "validation/scene/shown_frames.hpp"
#include "validation/store/provenance.hpp"
#include "validation/store/run_directory.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck {
namespace {

/// Every model ingredient and number, as the simulation took them.
void record_parameters(RunRecord& record, Scene scene, const Simulation& simulation) {
    record.provenance["setup_identity"] = setup_identity(scene);
    scene.model = simulation.model();
    scene.execution = simulation.execution();
    auto& numbers = record.parameters;
    for (const auto& [key, value] : parameters_of(scene)) {
        if (const double* number = std::get_if<double>(&value)) {
            numbers[key] = *number;
        } else {
            record.provenance[key] = toml_text(value);
        }
    }
    numbers["gravity_x"] = scene.model.gravity.x();
    numbers["gravity_y"] = scene.model.gravity.y();
    numbers["particle_spacing"] = record.particle_spacing;
    if (scene.resolution) {
        numbers["resolution.growth"] = scene.resolution->growth;
        numbers["resolution.coarsest"] = scene.resolution->coarsest;
    }
    numbers["smoothing_length"] = simulation.kernel().smoothing_length;
    numbers["run.end_time"] = scene.end_time;
    numbers["scheme_revision"] = scheme_revision;
    record.provenance["parameters"] = parameters_json(scene).dump();
    record.provenance["resolved_scene"] = scene.resolved;
    record.provenance["air"] = scene.air ? "yes" : "no";
}

void record_cost(RunRecord& record, const Simulation& simulation) {
    RunCost& cost = record.cost;
    cost.steps = simulation.steps();
    cost.particle_steps = static_cast<double>(simulation.particle_steps());
    cost.peak_rss_mb = peak_rss_mb();
    const StageTimes& s = simulation.stage_times();
    cost.stage_seconds = {{"neighbours", s.neighbours},  {"density", s.density},
                          {"momentum", s.momentum},      {"walls", s.walls},
                          {"bodies", s.bodies},          {"integration", s.integration},
                          {"probes and files", s.probes}};
    for (std::size_t k = 0; k < limiting_criterion_names.size(); ++k) {
        cost.limiting_criterion[limiting_criterion_names[k]] = simulation.limiting_counts()[k];
    }
    record.parameters["neighbour_list_builds"] = static_cast<double>(simulation.list_builds());
    record.parameters["bytes_per_particle"] = simulation.bytes_per_particle();
}

/// The program and instruction set that compute: with others the last digits may differ.
std::string computed_by(const Provenance& p) {
    return fmt::format("wetdeck {} {}, {}, {}", p.program_version, p.commit, p.compiler, p.simd);
}

/// The frames written up to the checkpoint must still be there: they would be missing in the end.
void check_frames(const std::filesystem::path& run_dir, const Checkpoint& from, double time) {
    double found = 0;
    for (const FrameEntry& frame : list_frames(run_dir))
        if (frame.time <= time && std::filesystem::exists(frame.path)) ++found;
    if (found != from.number("frames"))
        throw DataError(fmt::format("{} of {} field files written before the checkpoint are there", found,
                                    from.number("frames")));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Adds to an error of a checkpoint that the run has to be started again, and how.
DataError with_way_out(const DataError& error, const std::filesystem::path& run_dir) {
    return DataError(fmt::format("{}; start the run again: wetdeck run ... --replace --out {}", error.what(),
                                 run_dir.string()));
}

/// One run in a directory that is claimed, from its start or from a checkpoint.
class Run {
  public:
    Run(const Scene& scene, const RunOptions& options, double end, const Checkpoint* from)
        : scene_(scene),
          options_(options),
          end_(end),
          simulation_(assemble(scene, options.particle_spacing, options.threads)),
          provenance_(collect_provenance(simulation_.instruction_set(),
                                         static_cast<unsigned>(simulation_.threads()))),
          clock_(options.checkpoint_interval),
          series_(scene, options.particle_spacing, options.directory, from),
          field_series_(scene, from) {
        if (from) {
            go_on(*from);
        } else {
            fields_.emplace(options.directory);
        }
    }

    RunRecord run(Progress& progress) {
        RunRecord record = describe();
        const auto observe = [&](const Simulation&) { this->observe(progress); };
        if (const std::optional<Instability> instability =
                simulation_.run(end_, observe, penetration_monitor(scene_), contact_monitor(scene_))) {
            record.status = RunStatus::unstable;
            record.stop_reason = instability->describe();
            const FieldFrame& last = last_good_.frame();
            if (fields_->frames().empty() || last.time > fields_->frames().back().time) fields_->write(last);
        }
        record.series = series_.all();
        record.series.merge(field_series_.all());
        record.cost.wall_s = wall_before_ + seconds_since(start_);
        record.cost.core_s = core_before_ + processor_seconds() - processor_start_;
        record_cost(record, simulation_);
        return record;
    }

  private:
    void go_on(const Checkpoint& from) {
        restore_simulation(from, simulation_);
        check_frames(options_.directory, from, simulation_.time());
        fields_.emplace(options_.directory, simulation_.time());
        next_frame_ = static_cast<std::size_t>(from.number("next_frame"));
        FieldFrame last = frame_in(from);
        if (last.x.empty()) last = frame_of(simulation_, line());
        last.provenance = line();
        last_good_.set(std::move(last));
        wall_before_ = from.number("wall_s");
        core_before_ = from.number("core_s");
        if (from.text("computed_by") != computed_by(provenance_))
            fmt::print(stderr, "wetdeck: the run was started by {}; the last digits may differ\n",
                       from.text("computed_by"));
        provenance_.start_time = from.text("start_time");
        fmt::print("continuing from t = {:.4g} s, step {}\n", simulation_.time(), simulation_.steps());
        clock_.restart(0);
    }

    RunRecord describe() const {
        RunRecord record;
        record.scene = scene_.name();
        record.variant = scene_.variant;
        record.particle_spacing = options_.particle_spacing;
        record.fluid_particles = simulation_.fluid().size();
        record.particles = simulation_.fluid().size() + simulation_.walls().size();
        record.scene_text = scene_.text;
        record.scene_path = scene_.path;
        provenance_.add_to(record.provenance);
        record_parameters(record, scene_, simulation_);
        if (end_ != scene_.end_time) record.parameters["run.until"] = end_;
        record.provenance["time_origins"] = origins_text(scene_.analysis.origins);
        record.provenance["reference_hashes"] =
            reference_hashes(scene_.analysis, reference_directory() / scene_.name());
        if (!scene_.overrides.empty()) {
            const Scene base = parse_scene(scene_.text, scene_.path, scene_.variant);
            record.provenance["base_setup_identity"] = setup_identity(base);
            record.provenance["overrides"] = fmt::format("{}", fmt::join(scene_.overrides, "; "));
        }
        return record;
    }

    /// For the field files, which hold no more.
    std::string line() const {
        return fmt::format("{} {} dx {}: {}", scene_.name(), scene_.variant, options_.particle_spacing,
                           provenance_.line());
    }

    void observe(Progress& progress) {
        release_touching_(simulation_);
        const Simulation& s = simulation_;
        series_.sample(s, s.time() >= end_);
        if (next_frame_ < scene_.frame_times.size() && s.time() >= scene_.frame_times[next_frame_]) {
            bool shown = false;
            for (; next_frame_ < scene_.frame_times.size() && s.time() >= scene_.frame_times[next_frame_];
                 ++next_frame_)
                shown = shown ||
                        std::binary_search(shown_.begin(), shown_.end(), scene_.frame_times[next_frame_]);
            if (options_.fields == Fields::all || (options_.fields == Fields::key && shown))
                fields_->write(frame_of(s, line()));
            field_series_.sample(s);
        }
        const bool kept = last_good_.update(s, line());
        if (s.steps() % (steps_between_ / 4) == 0)
            progress.update(s.time() / end_,
                            fmt::format("t = {:.4g} of {:.4g} s, step {}", s.time(), end_, s.steps()));
        const int signal = s.time() < end_ ? stop_signal() : 0;
        // the last step is shortened to the end: a longer run goes on from the state before it
        const bool ends_next = s.time() < end_ && s.time() + s.next_step().size >= end_;
        if (signal != 0 || ends_next || (kept && clock_.due())) write_state();
        if (signal != 0)
            throw Interrupted(
                signal, fmt::format(" at t = {:.4g} of {:.4g} s; continue with: wetdeck resume {}", s.time(),
                                    end_, options_.directory.string()));
    }

    void write_state() {
        const auto start = std::chrono::steady_clock::now();
        Checkpoint checkpoint;
        checkpoint.step = simulation_.steps();
        save_request(checkpoint, scene_, options_);
        save_simulation(checkpoint, simulation_);
        series_.save(checkpoint);
        field_series_.save(checkpoint);
        const FieldFrame& last = last_good_.frame();
        save_frame(checkpoint, last.time < simulation_.time() ? last : FieldFrame{});
        checkpoint.numbers["frames"] = static_cast<double>(fields_->frames().size());
        checkpoint.numbers["next_frame"] = static_cast<double>(next_frame_);
        checkpoint.numbers["wall_s"] = wall_before_ + seconds_since(start_);
        checkpoint.numbers["core_s"] = core_before_ + processor_seconds() - processor_start_;
        checkpoint.texts["computed_by"] = computed_by(provenance_);
        checkpoint.texts["start_time"] = provenance_.start_time;
        write_checkpoint(options_.directory, checkpoint);
        clock_.restart(seconds_since(start));
    }

    const Scene& scene_;
    const RunOptions& options_;
    double end_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double processor_start_ = processor_seconds();
    double wall_before_ = 0, core_before_ = 0;  ///< of the processes that ran up to the checkpoint
    Simulation simulation_;
    Provenance provenance_;
    CheckpointClock clock_;
    TimeSeries series_;
    FieldTimeSeries field_series_;
    std::optional<FieldWriter> fields_;
    std::size_t next_frame_ = 0;
    const std::vector<double> shown_ = shown_frames(scene_);  ///< by the report [s]
    const ReleaseAtContact release_touching_{scene_};
    std::uint64_t steps_between_ = inspection_interval(simulation_, 256, 4);
    LastGoodFrame last_good_{steps_between_};
};

/// Makes a directory that of a run to another end: its identity, then its checkpoint, then no result.
/// Whatever is interrupted in between can be asked for again.
void ask_for_end(Checkpoint& checkpoint, const Scene& scene, const RunOptions& options) {
    const RunDirectory directory(options.directory, identity_of(scene, options), OnConflict::extend);
    save_request(checkpoint, scene, options);
    write_checkpoint(options.directory, checkpoint);
    std::error_code error;
    std::filesystem::remove(run_file(options.directory), error);
    if (error)
        throw EnvironmentError(
            fmt::format("{}: cannot be removed: {}", run_file(options.directory).string(), error.message()));
}

}  // namespace

std::string identity_of(const Scene& scene, const RunOptions& options) {
    return run_identity(
        scene.name(), scene.variant, options.particle_spacing,
        fmt::format("{}\nuntil = {}", setup_json(scene).dump(), options.until.value_or(scene.end_time)));
}

RunRecord run_scene(const Scene& scene, const RunOptions& options, Progress& progress) {
    check_spacing(scene, options.particle_spacing);
    const double end = options.until.value_or(scene.end_time);
    if (!(end > 0)) throw InputError(fmt::format("--until is {}, expected a positive time [s]", end));
    const std::filesystem::path& folder = options.directory;
    constexpr std::chrono::seconds patience(
        5);  // with a run that a signal has just stopped: it stores itself
    const RunDirectory directory(folder, identity_of(scene, options),
                                 options.replace ? OnConflict::replace : OnConflict::refuse, patience);
    RunRecord record;
    try {
        const std::optional<Checkpoint> from = newest_checkpoint(folder);
        if (from) remove_checkpoints_after(folder, from->step);
        record = Run(scene, options, end, from ? &*from : nullptr).run(progress);
        write_run(folder, record);
    } catch (const DataError& error) {
        throw with_way_out(error, folder);
    } catch (const EnvironmentError& error) {
        if (list_checkpoints(folder).empty()) throw;
        throw EnvironmentError(fmt::format("{}; once this is resolved, continue with: wetdeck resume {}",
                                           error.what(), folder.string()));
    }
    std::error_code ignored;
    std::filesystem::remove(live_file(folder), ignored);
    if (record.status == RunStatus::ok && options.fields == Fields::all) {
        keep_newest_checkpoint(folder);
    } else {
        remove_checkpoints(folder);
    }
    return record;
}

std::pair<Scene, RunOptions> interrupted_run(const std::filesystem::path& directory,
                                             std::optional<double> until) {
    std::pair<Scene, RunOptions> run;
    auto& [scene, options] = run;
    try {
        std::optional<Checkpoint> checkpoint = newest_checkpoint(directory);
        if (!checkpoint)
            throw DataError(
                fmt::format("{}: holds no checkpoint to continue from (a run with --fields none or "
                            "key keeps none once it has ended)",
                            directory.string()));
        run = {scene_in(*checkpoint), options_in(*checkpoint)};
        options.directory = directory;
        const std::string before = identity_of(scene, options);
        const double time = checkpoint->number("solver.time");
        if (until) options.until = until;
        const std::optional<std::string> found = identity_in(directory);
        if (found != before && found != identity_of(scene, options))
            throw DataError(fmt::format("{}: the checkpoint belongs to another run than the directory ({})",
                                        directory.string(), found.value_or("no identity")));
        if (until && !(*until > time))
            throw InputError(fmt::format("--until is {} s, expected a time after the checkpoint at {:.6g} s",
                                         *until, time));
        if (until) ask_for_end(*checkpoint, scene, options);
    } catch (const DataError& error) {
        throw with_way_out(error, directory);
    }
    return run;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// RunRecord to HDF5 and back.
#include "validation/store/run_store.hpp"

#include <new>
#include <set>
#include <stdexcept>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/hdf5_values.hpp"
#include "validation/store/seal.hpp"

namespace wetdeck {
namespace {

using hdf5::Node;

constexpr std::uint64_t schema = 1;
const std::string parameter_prefix = "parameter:";
const std::string provenance_prefix = "choice:";  // the name in files of all versions
const std::set<std::string> fixed_names = {"schema",          "scene",     "variant", "particle_spacing",
                                           "fluid_particles", "particles", "status",  "stop_reason",
                                           "scene_text",      "scene_path"};

/// The attribute of /meta that holds a key: the key itself, prefixed where that would be ambiguous.
std::string attribute_for(const std::string& key, const std::string& prefix,
                          const std::set<std::string>& taken) {
    const bool ambiguous = key.empty() || taken.contains(key) || key.starts_with(parameter_prefix) ||
                           key.starts_with(provenance_prefix);
    return ambiguous ? prefix + key : key;
}

std::string key_of(const std::string& attribute, const std::string& prefix) {
    return attribute.starts_with(prefix) ? attribute.substr(prefix.size()) : attribute;
}

void write_meta(const Node& file, const RunRecord& record) {
    const Node meta = create_group(file, "meta");
    write_attribute(meta, "schema", schema);
    write_attribute(meta, "scene", record.scene);
    write_attribute(meta, "variant", record.variant);
    write_attribute(meta, "particle_spacing", record.particle_spacing);
    write_attribute(meta, "fluid_particles", record.fluid_particles);
    write_attribute(meta, "particles", record.particles);
    write_attribute(meta, "status", to_string(record.status));
    write_attribute(meta, "stop_reason", record.stop_reason);
    write_attribute(meta, "scene_text", record.scene_text);
    write_attribute(meta, "scene_path", record.scene_path);
    std::set<std::string> taken = fixed_names;
    for (const auto& [key, value] : record.parameters) {
        const std::string name = attribute_for(key, parameter_prefix, taken);
        write_attribute(meta, name, value);
        taken.insert(name);
    }
    for (const auto& [key, value] : record.provenance) {
        write_attribute(meta, attribute_for(key, provenance_prefix, taken), value);
    }
}

void write_series(const Node& parent, const std::string& name, const Series& series) {
    const Node group = create_group(parent, name);
    if (series.value.size() != series.time.size() * series.columns()) {
        throw DataError(group.place() + ": " + std::to_string(series.value.size()) + " values for " +
                        std::to_string(series.time.size()) + " times and " +
                        std::to_string(series.columns()) + " columns");
    }
    write_attribute(group, "unit", series.unit);
    write_attribute(group, "description", series.description);
    const Node time = write_array(group, "time", series.time);
    const Node value = write_array(group, "value", series.value, series.abscissa.size());
    write_attribute(time, "unit", std::string("s"));
    write_attribute(value, "unit", series.unit);
    attach_scale(value, 0, time, "time");
    if (!series.abscissa.empty())
        attach_scale(value, 1, write_array(group, "abscissa", series.abscissa), "abscissa");
}

void write_cost(const Node& file, const RunCost& cost) {
    const Node group = create_group(file, "cost");
    write_attribute(group, "wall_seconds", cost.wall_s);
    write_attribute(group, "core_seconds", cost.core_s);
    write_attribute(group, "steps", cost.steps);
    write_attribute(group, "particle_steps", cost.particle_steps);
    write_attribute(group, "peak_memory_mb", cost.peak_rss_mb);
    const Node stages = create_group(group, "stage_seconds");
    for (const auto& [stage, seconds] : cost.stage_seconds) write_attribute(stages, stage, seconds);
    const Node criteria = create_group(group, "limiting_criterion");
    for (const auto& [criterion, steps] : cost.limiting_criterion)
        write_attribute(criteria, criterion, steps);
}

RunStatus read_status(const Node& meta) {
    const std::string text = read_text(meta, "status");
    try {
        return run_status_from(text);
    } catch (const DataError& error) {
        throw DataError(meta.place() + ": " + error.what());
    }
}

void read_meta(const Node& file, RunRecord& record) {
    const Node meta = open_group(file, "meta");
    if (const std::uint64_t found = read_unsigned(meta, "schema"); found != schema) {
        throw DataError(meta.place() + ": schema " + std::to_string(found) + ", this program reads " +
                        std::to_string(schema));
    }
    record.scene = read_text(meta, "scene");
    record.variant = read_text(meta, "variant");
    record.particle_spacing = read_double(meta, "particle_spacing");
    record.fluid_particles = read_unsigned(meta, "fluid_particles");
    record.particles = read_unsigned(meta, "particles");
    record.status = read_status(meta);
    record.stop_reason = read_text(meta, "stop_reason");
    record.scene_text = read_text(meta, "scene_text");
    record.scene_path = read_text(meta, "scene_path");
    for (const std::string& name : attribute_names(meta)) {
        if (fixed_names.contains(name)) continue;
        if (is_text(meta, name)) {
            record.provenance[key_of(name, provenance_prefix)] = read_text(meta, name);
        } else {
            record.parameters[key_of(name, parameter_prefix)] = read_double(meta, name);
        }
    }
}

Series read_series(const Node& parent, const std::string& name) {
    const Node group = open_group(parent, name);
    Series series;
    series.unit = read_text(group, "unit");
    series.description = read_text(group, "description");
    series.time = read_array(group, "time").values;
    if (has_link(group, "abscissa")) series.abscissa = read_array(group, "abscissa").values;
    hdf5::Array value = read_array(group, "value");
    std::vector<hsize_t> expected{series.time.size()};
    if (!series.abscissa.empty()) expected.push_back(series.abscissa.size());
    if (value.shape != expected) throw DataError(group.place() + ": value does not match time and abscissa");
    series.value = std::move(value.values);
    return series;
}

void read_cost(const Node& file, RunCost& cost) {
    const Node group = open_group(file, "cost");
    cost.wall_s = read_double(group, "wall_seconds");
    cost.core_s = read_double(group, "core_seconds");
    cost.steps = read_unsigned(group, "steps");
    cost.particle_steps = read_double(group, "particle_steps");
    cost.peak_rss_mb = read_double(group, "peak_memory_mb");
    const Node stages = open_group(group, "stage_seconds");
    for (const std::string& stage : attribute_names(stages)) {
        cost.stage_seconds[stage] = read_double(stages, stage);
    }
    const Node criteria = open_group(group, "limiting_criterion");
    for (const std::string& criterion : attribute_names(criteria)) {
        cost.limiting_criterion[criterion] = read_unsigned(criteria, criterion);
    }
}

}  // namespace

std::filesystem::path run_file(const std::filesystem::path& run_dir) {
    return run_dir / "run.h5";
}

void write_run(const std::filesystem::path& run_dir, const RunRecord& record) {
    const std::filesystem::path path = run_file(run_dir);
    const Node file = hdf5::create_in_memory(path.string());
    write_meta(file, record);
    const Node all_series = create_group(file, "series");
    for (const auto& [name, series] : record.series) write_series(all_series, name, series);
    write_cost(file, record.cost);
    std::string bytes = file_image(file);
    bytes += seal_of(bytes);
    atomic_write(path, bytes);
}

namespace {

RunRecord read_record(const std::filesystem::path& path) {
    const Node file = hdf5::open_file(path, hdf5::Access::read);
    RunRecord record;
    try {
        read_meta(file, record);
        const Node all_series = open_group(file, "series");
        for (const std::string& name : link_names(all_series)) {
            record.series[name] = read_series(all_series, name);
        }
        read_cost(file, record.cost);
    } catch (const std::bad_alloc&) {  // a damaged length
        throw DataError(path.string() + ": damaged, an array claims more than the memory");
    } catch (const std::length_error&) {
        throw DataError(path.string() + ": damaged, an array claims more than the memory");
    }
    return record;
}

}  // namespace

RunRecord read_run(const std::filesystem::path& path) {
    const Seal seal = seal_in(path);
    if (seal == Seal::broken) throw DataError(path.string() + ": damaged, the checksum does not match");
    if (seal == Seal::absent)
        try_in_child_process(
            path, [&] { read_record(path); }, reading_time(path));
    return read_record(path);
}

}  // namespace wetdeck

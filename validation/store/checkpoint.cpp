// SPDX-License-Identifier: BSD-3-Clause
// Checkpoint to HDF5 and back, and which files are kept.
#include "validation/store/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/hdf5_values.hpp"
#include "validation/store/seal.hpp"

namespace wetdeck {
namespace {

using hdf5::Node;

constexpr std::uint64_t schema = 1;
constexpr std::size_t kept = 2;  // a crash of the machine may have damaged the newest

std::filesystem::path path_of(const std::filesystem::path& run_dir, std::uint64_t step) {
    return run_dir / fmt::format("checkpoint_{:012}.h5", step);  // by name is by step
}

void remove_file(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) throw environment_error(path, "remove", error.value());
}

template <class Map>
const typename Map::mapped_type& entry(const Map& map, const std::string& name) {
    const auto found = map.find(name);
    if (found == map.end()) throw DataError("the checkpoint lacks '" + name + "'");
    return found->second;
}

Checkpoint read_values(const Node& file) {
    if (const std::uint64_t found = read_unsigned(file, "schema"); found != schema) {
        throw DataError(fmt::format("{}: schema {}, this program reads {}", file.place(), found, schema));
    }
    Checkpoint checkpoint;
    checkpoint.step = read_unsigned(file, "step");
    const Node texts = open_group(file, "texts");
    for (const std::string& name : attribute_names(texts)) checkpoint.texts[name] = read_text(texts, name);
    const Node numbers = open_group(file, "numbers");
    for (const std::string& name : attribute_names(numbers))
        checkpoint.numbers[name] = read_double(numbers, name);
    const Node arrays = open_group(file, "arrays");
    for (const std::string& name : link_names(arrays))
        checkpoint.arrays[name] = read_array(arrays, name).values;
    return checkpoint;
}

}  // namespace

const std::string& Checkpoint::text(const std::string& name) const {
    return entry(texts, name);
}

double Checkpoint::number(const std::string& name) const {
    return entry(numbers, name);
}

const std::vector<double>& Checkpoint::array(const std::string& name) const {
    return entry(arrays, name);
}

std::vector<std::filesystem::path> list_checkpoints(const std::filesystem::path& run_dir) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& item : std::filesystem::directory_iterator(run_dir, error)) {
        const std::string name = item.path().filename().string();
        if (name.starts_with("checkpoint_") && name.ends_with(".h5")) files.push_back(item.path());
    }
    std::sort(files.rbegin(), files.rend());
    return files;
}

void write_checkpoint(const std::filesystem::path& run_dir, const Checkpoint& checkpoint) {
    const std::filesystem::path path = path_of(run_dir, checkpoint.step);
    {
        const Node file = hdf5::create_in_memory(path.string());
        write_attribute(file, "schema", schema);
        write_attribute(file, "step", checkpoint.step);
        const Node texts = create_group(file, "texts");
        for (const auto& [name, text] : checkpoint.texts) write_attribute(texts, name, text);
        const Node numbers = create_group(file, "numbers");
        for (const auto& [name, number] : checkpoint.numbers) write_attribute(numbers, name, number);
        const Node arrays = create_group(file, "arrays");
        for (const auto& [name, values] : checkpoint.arrays)
            write_array(arrays, name, values, 0, hdf5::Packing::plain);
        std::string bytes = file_image(file);
        bytes += seal_of(bytes);
        atomic_write(path, bytes);
    }
    const std::vector<std::filesystem::path> files = list_checkpoints(run_dir);
    for (std::size_t n = kept; n < files.size(); ++n) remove_file(files[n]);
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
    if (seal_in(file) != Seal::whole)
        throw DataError(file.string() + ": truncated or damaged, the checksum does not match");
    return read_values(hdf5::open_file(file, hdf5::Access::read));
}

std::optional<Checkpoint> newest_checkpoint(const std::filesystem::path& run_dir) {
    std::string damage;
    for (const std::filesystem::path& file : list_checkpoints(run_dir)) {
        try {
            return read_checkpoint(file);
        } catch (const DataError& error) {
            if (damage.empty()) damage = error.what();
        }
    }
    if (damage.empty()) return std::nullopt;
    throw DataError(run_dir.string() + ": no checkpoint can be read (" + damage + ")");
}

void remove_checkpoints_after(const std::filesystem::path& run_dir, std::uint64_t step) {
    for (const std::filesystem::path& file : list_checkpoints(run_dir)) {
        if (file > path_of(run_dir, step)) remove_file(file);
    }
}

void keep_newest_checkpoint(const std::filesystem::path& run_dir) {
    const std::vector<std::filesystem::path> files = list_checkpoints(run_dir);
    for (std::size_t k = 1; k < files.size(); ++k) remove_file(files[k]);
}

void remove_checkpoints(const std::filesystem::path& run_dir) {
    for (const std::filesystem::path& file : list_checkpoints(run_dir)) remove_file(file);
}

}  // namespace wetdeck

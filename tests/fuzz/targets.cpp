// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/targets.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "solver/core/errors.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck::fuzz {
namespace {

/// The bytes as a file, which HDF5 wants to find by its name.
class CaseFile {
  public:
    explicit CaseFile(const std::string& bytes)
        : path_(std::filesystem::temp_directory_path() / ("wetdeck-case-" + std::to_string(::getpid()))) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~CaseFile() { std::filesystem::remove(path_); }
    CaseFile(const CaseFile&) = delete;
    CaseFile& operator=(const CaseFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

template <class Read>
bool read_or_refuse(const Read& read) {
    try {
        read();
        return true;
    } catch (const InputError&) {        // DataError is one
    } catch (const EnvironmentError&) {  // a damaged offset that the system will not seek to
    }
    return false;
}

bool scene(const std::string& bytes) {
    return read_or_refuse([&] { parse_scene(bytes, "scene.toml"); });
}

bool reference(const std::string& bytes) {
    const CaseFile file(bytes);
    return read_or_refuse([&] { load_reference(file.path()); });
}

bool checkpoint(const std::string& bytes) {
    const CaseFile file(bytes);
    return read_or_refuse([&] { read_checkpoint(file.path()); });
}

bool run(const std::string& bytes) {
    const CaseFile file(bytes);
    return read_or_refuse([&] { read_run(file.path()); });
}

}  // namespace

const std::map<std::string, Target>& targets() {
    static const std::map<std::string, Target> all = {
        {"scene", scene}, {"reference", reference}, {"checkpoint", checkpoint}, {"run", run}};
    return all;
}

}  // namespace wetdeck::fuzz

// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/targets.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

#include "solver/core/errors.hpp"
#include "validation/metrics/reference.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/checkpoint.hpp"
#include "validation/store/run_store.hpp"

namespace wetdeck::fuzz {
namespace {

/// The bytes as a file, in memory only.
class MemoryFile {
  public:
    explicit MemoryFile(const std::string& bytes) : descriptor_(::memfd_create("case", MFD_CLOEXEC)) {
        const auto written = ::write(descriptor_, bytes.data(), bytes.size());
        if (descriptor_ < 0 || written != static_cast<ssize_t>(bytes.size()))
            throw std::runtime_error("no file in memory");
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

  private:
    int descriptor_;
};

template <class Read>
void read_or_refuse(const Read& read) {
    try {
        read();
    } catch (const InputError&) {        // DataError is one
    } catch (const EnvironmentError&) {  // a damaged offset that the system will not seek to
    }
}

void scene(const std::string& bytes) {
    read_or_refuse([&] { parse_scene(bytes, "scene.toml"); });
}

void reference(const std::string& bytes) {
    const MemoryFile file(bytes);
    read_or_refuse([&] { load_reference(file.path()); });
}

void checkpoint(const std::string& bytes) {
    const MemoryFile file(bytes);
    read_or_refuse([&] { read_checkpoint(file.path()); });
}

void run(const std::string& bytes) {
    const MemoryFile file(bytes);
    read_or_refuse([&] { read_run(file.path()); });
}

}  // namespace

const std::map<std::string, Target>& targets() {
    static const std::map<std::string, Target> all = {
        {"scene", scene}, {"reference", reference}, {"checkpoint", checkpoint}, {"run", run}};
    return all;
}

}  // namespace wetdeck::fuzz

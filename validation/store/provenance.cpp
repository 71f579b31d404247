// SPDX-License-Identifier: BSD-3-Clause
// Facts of the build (generated headers) and of the machine (Linux).
#include "validation/store/provenance.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "wetdeck_build/build_info.hpp"
#include "wetdeck_build/git_revision.hpp"

namespace wetdeck {
namespace {

/// The rest of the first line of `file` that starts with `key`, without quotes and the separator before it.
std::string value_in(const char* file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(key)) continue;
        const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
        if (begin == std::string::npos) break;
        return line.substr(begin, line.find_last_not_of(" \t\"") - begin + 1);
    }
    return "unknown";
}

std::string host_kind() {
    utsname names{};
    ::uname(&names);
    return fmt::format("{}, {} {}", value_in("/etc/os-release", "PRETTY_NAME"), names.sysname, names.machine);
}

}  // namespace

std::string Provenance::line() const {
    return fmt::format("wetdeck {}, commit {}, {} {}, {}, {}", program_version, commit, compiler,
                       compiler_flags, simd, cpu);
}

void Provenance::add_to(std::map<std::string, std::string>& entries) const {
    entries["program_version"] = program_version;
    entries["commit"] = commit;
    entries["compiler"] = compiler;
    entries["compiler_flags"] = compiler_flags;
    entries["build_type"] = build_type;
    entries["libraries"] = libraries;
    entries["simd"] = simd;
    entries["cpu"] = cpu;
    entries["host"] = host;
    entries["cores"] = std::to_string(cores);
    entries["threads"] = std::to_string(threads);
    entries["start_time"] = start_time;
}

Provenance collect_provenance(const std::string& simd, unsigned threads,
                              std::chrono::system_clock::time_point start) {
    Provenance result;
    result.program_version = build::version;
    result.commit = build::revision;
    result.compiler = build::compiler;
    result.compiler_flags = build::flags;
    result.build_type = build::type;
    result.libraries = build::libraries;
    result.simd = simd;
    result.cpu = value_in("/proc/cpuinfo", "model name");
    result.host = host_kind();
    result.cores = std::thread::hardware_concurrency();
    result.threads = threads;
    result.start_time = utc_text(start);
    return result;
}

std::string utc_text(std::chrono::system_clock::time_point time) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
    std::tm utc{};
    ::gmtime_r(&seconds, &utc);
    char text[sizeof "2024-05-31T12:00:00Z" + 8];  // room for years beyond 9999
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &utc);
    const auto since = time - std::chrono::system_clock::from_time_t(seconds);
    return fmt::format("{}.{:03}Z", std::string_view(text, length),
                       std::chrono::duration_cast<std::chrono::milliseconds>(since).count());
}

double peak_rss_mb() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;  // Linux counts in KiB
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Provenance of a result: revision and build of the program, and the machine.
// Holds no user name, host name or path of the build machine.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace wetdeck {

struct Provenance {
    std::string program_version;
    std::string commit;    ///< abbreviated hash, "-dirty" behind it if tracked files differed; "unknown"
    std::string compiler;  ///< name and version
    std::string compiler_flags;
    std::string build_type;
    std::string libraries;  ///< "HDF5 1.10.8, ..."
    std::string simd;       ///< instruction set of the kernels that ran
    std::string cpu;        ///< model name
    std::string host;       ///< operating system and machine type
    unsigned cores = 0;     ///< processors this process may use
    unsigned threads = 0;
    std::string start_time;  ///< UTC, ISO 8601

    /// One line for the field files: version, commit, compiler and flags, processor. Without
    /// start and threads, so that the same run gives the same bytes, on any number of threads.
    std::string line() const;
    /// As texts, by the names of the members, for RunRecord::provenance.
    void add_to(std::map<std::string, std::string>& entries) const;
};

Provenance collect_provenance(const std::string& simd, unsigned threads,
                              std::chrono::system_clock::time_point start = std::chrono::system_clock::now());

/// "2024-05-31T12:00:00Z".
std::string utc_text(std::chrono::system_clock::time_point time);

/// Largest resident memory of this process so far [MB = 1e6 bytes].
double peak_rss_mb();

}  // namespace wetdeck

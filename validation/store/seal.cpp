// SPDX-License-Identifier: BSD-3-Clause
#include "validation/store/seal.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/hash.hpp"

namespace wetdeck {
namespace {

constexpr std::string_view mark = "\nwetdeck";
constexpr std::size_t seal_size = sizeof(std::uint64_t) + mark.size();

void set_timer(decltype(ITIMER_REAL) timer, double seconds) {
    const auto whole = static_cast<time_t>(seconds);
    const auto rest = static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(whole)));
    const itimerval time{{0, 0}, {whole, rest}};
    ::setitimer(timer, &time, nullptr);
}

/// A signal ends the child once it exceeds its time, or if it crashes.
void limit_child(const ReadingTime& limit) {
    for (const int signal : {SIGPROF, SIGALRM, SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        ::signal(signal, SIG_DFL);
    set_timer(ITIMER_PROF, limit.processor_s);
    set_timer(ITIMER_REAL, limit.wall_s);
    const rlimit core{0, 0};
    ::setrlimit(RLIMIT_CORE, &core);
    const int nowhere = ::open("/dev/null", O_WRONLY);  // hides what a crash prints
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

}  // namespace

std::string seal_of(std::string_view bytes) {
    const std::uint64_t sum = fnv1a_of_words(bytes);
    std::string seal(sizeof sum, '\0');
    std::memcpy(seal.data(), &sum, sizeof sum);
    return seal.append(mark);
}

Seal seal_in(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!file.is_open() && errno != ENOENT) throw environment_error(path, "read", errno);
    if (bytes.size() < seal_size || !bytes.ends_with(mark)) return Seal::absent;
    const std::string_view body(bytes.data(), bytes.size() - seal_size);
    return seal_of(body) == std::string_view(bytes).substr(body.size()) ? Seal::whole : Seal::broken;
}

ReadingTime reading_time(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    constexpr double least_s = 0.5, bytes_per_s = 1 << 23;
    constexpr double least_wall_s = 60, wall_over_processor = 10;
    const double processor_s = least_s + (ignored ? 0 : static_cast<double>(size) / bytes_per_s);
    return {processor_s, least_wall_s + wall_over_processor * processor_s};
}

void try_in_child_process(const std::filesystem::path& file, const std::function<void()>& read,
                          const ReadingTime& limit) {
    const pid_t child = ::fork();
    if (child < 0) throw environment_error(file, "start a process to read", errno);
    if (child == 0) {
        limit_child(limit);
        try {
            read();
        } catch (...) {  // the parent reads the file again and reports it
        }
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status == 0) return;
    const bool timed_out =
        WIFSIGNALED(status) && (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM);
    throw DataError(file.string() + ": damaged, HDF5 " + (timed_out ? "does not finish" : "crashes while") +
                    " reading it");
}

}  // namespace wetdeck

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

/// Ends the child by a signal if it takes more processor time than any sound file does.
void limit_child(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(file, ignored);
    constexpr double least_s = 0.5, bytes_per_s = 1 << 23;  // sound files take a tenth of that at most
    const double seconds = least_s + (ignored ? 0 : static_cast<double>(size) / bytes_per_s);
    const auto whole = static_cast<time_t>(seconds);
    const auto rest = static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(whole)));
    const itimerval time{{0, 0}, {whole, rest}};
    const rlimit core{0, 0};
    ::setitimer(ITIMER_PROF, &time, nullptr);
    ::setrlimit(RLIMIT_CORE, &core);
    for (const int signal : {SIGPROF, SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        ::signal(signal, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY);  // for the last words of a crash
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

void rehearse(const std::filesystem::path& file, const std::function<void()>& read) {
    const pid_t child = ::fork();
    if (child < 0) throw environment_error(file, "start a process to read", errno);
    if (child == 0) {
        limit_child(file);
        try {
            read();
        } catch (...) {  // it comes again where it can be told
        }
        ::_exit(0);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status == 0) return;
    const bool endless = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
    throw DataError(file.string() + ": damaged, HDF5 " + (endless ? "does not come to an end" : "crashes") +
                    " on it");
}

}  // namespace wetdeck

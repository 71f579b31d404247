// SPDX-License-Identifier: BSD-3-Clause
// Runs the built program as a user would, in a process group of its own.
#pragma once

#include <fcntl.h>
#include <sys/prctl.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/faults/fault_support.hpp"
#include "tests/unit/scene/scene_samples.hpp"

namespace wetdeck::samples {

/// The program at work. It, and every process it started, ends with this scope.
class Program {
  public:
    Program(std::vector<std::string> arguments, const std::filesystem::path& log_folder)
        : out_(log_folder / "stdout"), err_(log_folder / "stderr") {
        ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans of the program become children of this test
        arguments.insert(arguments.begin(), WETDECK_PROGRAM);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        process_ = ::fork();
        if (process_ < 0) throw std::runtime_error("no child process");
        if (process_ > 0) {
            ::setpgid(process_, process_);  // in both processes: whichever comes first
            return;
        }
        ::setpgid(0, 0);
        redirect("/dev/null", O_RDONLY, STDIN_FILENO);
        redirect(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        redirect(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
        ::execv(WETDECK_PROGRAM, argv.data());
        ::_exit(127);
    }
    ~Program() { kill_all(); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Exit code, or 1000 plus the signal that ended it.
    int wait() {
        int status = 0;
        ::waitpid(process_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    }
    /// To the program alone.
    void send(int signal) const { ::kill(process_, signal); }
    /// kill -9 of the program alone.
    void kill_parent() {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    /// kill -9 of the program and all that it started.
    void kill_all() {
        ::kill(-process_, SIGKILL);
        while (::waitpid(-process_, nullptr, 0) > 0) {
        }
    }
    /// True as soon as no process of the group is left; false if one is still there in the end.
    bool all_gone_within(std::chrono::seconds patience) const {
        return true_within(patience, [&] {
            while (::waitpid(-process_, nullptr, WNOHANG) > 0) {
            }
            return ::kill(-process_, 0) != 0;
        });
    }
    template <class Condition>
    static bool true_within(std::chrono::seconds patience, const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return true;
    }
    /// Of the program as it runs, one NUL-terminated NAME=VALUE after the other.
    std::string environment() const { return bytes_of("/proc/" + std::to_string(process_) + "/environ"); }
    std::string out() const { return bytes_of(out_); }
    std::string err() const { return bytes_of(err_); }

  private:
    static void redirect(const char* path, int flags, int descriptor) {
        const int file = ::open(path, flags, 0644);
        if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
        ::close(file);
    }

    std::filesystem::path out_, err_;
    pid_t process_ = -1;
};

struct Outcome {
    int code = 0;
    std::string out, err;

    /// stderr is one whole line, from the program.
    bool one_line() const {
        return err.rfind("wetdeck: ", 0) == 0 && err.back() == '\n' &&
               std::count(err.begin(), err.end(), '\n') == 1;
    }
};

/// Runs the program to its end.
inline Outcome run_program(const std::vector<std::string>& arguments) {
    const ScratchFolder logs;
    Program program(arguments, logs);
    const int code = program.wait();
    return {code, program.out(), program.err()};
}

/// Writes the small scene, or a changed one, into a folder.
inline std::string put_scene(const ScratchFolder& folder, const std::string& text = small_scene) {
    put_bytes(folder / "small.toml", text);
    return folder / "small.toml";
}

}  // namespace wetdeck::samples

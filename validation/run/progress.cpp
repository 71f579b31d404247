// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace wetdeck {

std::string duration_text(double seconds) {
    const long total = static_cast<long>(seconds + 0.5);
    if (total < 60) return fmt::format("{} s", total);
    if (total < 3600) return fmt::format("{} min {} s", total / 60, total % 60);
    return fmt::format("{} h {} min", total / 3600, total % 3600 / 60);
}

namespace {

/// A terminal that cannot go back in a line.
bool is_dumb() {
    const char* name = std::getenv("TERM");
    return name != nullptr && std::string_view(name) == "dumb";
}

}  // namespace

std::optional<double> TimeLeft::estimate(double elapsed, double share) {
    constexpr double least_share = 0.01, largest_rise = 4.0 / 3;
    if (share < least_share) return std::nullopt;
    const double left = elapsed * (1 - share) / share;
    last_ = last_ ? std::min(left, largest_rise * *last_) : left;
    return last_;
}

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0 && !is_dumb()),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
    if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::update(double share, const std::string& detail) {
    if (quiet_) return;
    const Clock::time_point now = Clock::now();
    const auto seconds = [](Clock::duration d) { return std::chrono::duration<double>(d).count(); };
    if (seconds(now - last_) < (terminal_ ? 0.2 : 10)) return;
    last_ = now;
    shown_ = true;
    const double elapsed = seconds(now - start_);
    const std::optional<double> estimate = time_left_.estimate(elapsed, share);
    const std::string left = estimate ? duration_text(*estimate) + " left" : "time left not known yet";
    if (terminal_) {
        constexpr int width = 24;
        const int filled = static_cast<int>(share * width);
        fmt::print(stderr, "\r\033[K{} [{}{}] {:3.0f} %  {}  {}", label_,
                   std::string(static_cast<std::size_t>(filled), '#'),
                   std::string(static_cast<std::size_t>(width - filled), '.'), 100 * share, detail, left);
    } else {
        fmt::print(stderr, "{}: {:.0f} %, {}, {}\n", label_, 100 * share, detail, left);
    }
    std::fflush(stderr);
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Progress on stderr: a bar with the time left on a terminal, at most one plain line per ten seconds
// elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace wetdeck {

class Progress {
  public:
    /// @param label  name of the work, in front of each line
    explicit Progress(std::string label, bool quiet = false);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// @param share   done, 0 to 1
    /// @param detail  a few words behind the bar
    void update(double share, const std::string& detail);

  private:
    using Clock = std::chrono::steady_clock;
    std::string label_;
    bool quiet_, terminal_;
    Clock::time_point start_, last_;
    bool shown_ = false;
};

/// "42 s", "3 min 20 s", "1 h 5 min".
std::string duration_text(double seconds);

}  // namespace wetdeck

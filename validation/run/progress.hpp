// SPDX-License-Identifier: BSD-3-Clause
// Progress on stderr: a bar with the time left on a terminal, at most one plain line per ten seconds
// elsewhere.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace wetdeck {

/// Estimates of the time that is left. One estimate exceeds the last by at most a third: a sudden change of
/// the speed of the machine or of the steps shows over several of them.
class TimeLeft {
  public:
    /// @param elapsed  [s]
    /// @param share    done, 0 to 1
    /// @return [s]; nothing while too little is done to tell
    std::optional<double> estimate(double elapsed, double share);

  private:
    std::optional<double> last_;
};

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
    TimeLeft time_left_;
    bool shown_ = false;
};

/// "42 s", "3 min 20 s", "1 h 5 min".
std::string duration_text(double seconds);

}  // namespace wetdeck

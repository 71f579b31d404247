// SPDX-License-Identifier: BSD-3-Clause
// How many threads work on a simulation.
//
// All threads meet at the end of each piece of work. Where other programs use the processors, too, they wait
// there for one whose processor does something else, and fewer threads are faster: a team of n is one too
// many where it gets less processor time than n - 1 threads with processors of their own would.
#pragma once

#include <chrono>

namespace wetdeck {

/// Up to so many threads as are of use.
class Team {
  public:
    /// @param most    number of threads to begin with, at least 1
    /// @param adapts  whether it gets smaller on a busy machine
    Team(int most, bool adapts) : most_(most), size_(most), adapts_(adapts && most > 1) {}

    /// Number of threads now.
    int size() const { return size_; }
    /// Adds what a piece of work of all threads took [s].
    void add(double wall, double processors) {
        wall_ += wall;
        processors_ += processors;
    }
    /// Takes another size if what was added since the last call asks for it. Not in the middle of work that
    /// is shared by the present size.
    void adapt();

    /// Adds the time of a scope in which all threads work.
    class Work {
      public:
        /// Starts now; the team outlives it.
        explicit Work(Team& team);
        ~Work();
        Work(const Work&) = delete;
        Work& operator=(const Work&) = delete;

      private:
        Team& team_;
        std::chrono::steady_clock::time_point start_;
        double processors_ = 0;
    };

  private:
    int most_, size_;
    bool adapts_;
    bool on_trial_ = false;                 ///< whether it has just become larger
    double wall_ = 0, processors_ = 0;      ///< of the work since the last look [s]
    double patience_ = 1, pause_left_ = 0;  ///< until the next trial of a larger team [s of work]
};

}  // namespace wetdeck

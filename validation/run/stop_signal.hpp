// SPDX-License-Identifier: BSD-3-Clause
// SIGINT (Ctrl-C) and SIGTERM: the program stops cleanly at the next good moment.
#pragma once

#include <stdexcept>
#include <string>

namespace wetdeck {

/// From now on the first of these signals is only noted; a second one ends the process at once. A signal that
/// the process was started to ignore stays ignored.
void catch_stop_signals();

/// The signal that has come, or 0.
int stop_signal();

/// A signal stopped the work after its state had been stored. The message says how to continue.
class Interrupted : public std::runtime_error {
  public:
    Interrupted(int signal_number, const std::string& how_to_go_on);
    /// 128 + signal, as shells have it: 130 for SIGINT, 143 for SIGTERM.
    int exit_code() const { return 128 + signal_; }

  private:
    int signal_;
};

}  // namespace wetdeck

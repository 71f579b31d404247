// SPDX-License-Identifier: BSD-3-Clause
// What the program tells the shell when it ends. A process that a signal stopped ends with 128 plus its
// number (stop_signal.hpp).
#pragma once

namespace wetdeck {

inline constexpr int exit_done = 0;         ///< and within tolerance
inline constexpr int exit_outside = 1;      ///< a comparison or check fell outside its stated tolerance
inline constexpr int exit_usage = 2;        ///< bad usage or bad input
inline constexpr int exit_unstable = 3;     ///< a run became unstable
inline constexpr int exit_environment = 4;  ///< the environment failed: disk full, no permission

}  // namespace wetdeck

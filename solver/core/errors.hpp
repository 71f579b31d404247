// SPDX-License-Identifier: BSD-3-Clause
// The errors the library throws. The program turns them into one line on stderr and an exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace wetdeck {

/// The user asked for something that cannot be done: a bad scene file, key, value or option (exit code 2).
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A data file (reference curve, run store) does not hold what it must (exit code 2).
class DataError : public InputError {
  public:
    using InputError::InputError;
};

/// The machine refused: disk full, no permission, a file that another process holds (exit code 4).
class EnvironmentError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace wetdeck

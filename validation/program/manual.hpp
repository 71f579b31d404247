// SPDX-License-Identifier: BSD-3-Clause
// The manual page wetdeck.1, made from the commands and options of the command line.
#pragma once

#include <string>

namespace wetdeck {

/// In roff, for man(1).
std::string manual_page();

}  // namespace wetdeck

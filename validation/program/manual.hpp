// SPDX-License-Identifier: BSD-3-Clause
// The manual page wetdeck.1, made of the commands and options that the program has.
#pragma once

#include <string>

namespace wetdeck {

/// In roff, for man(1).
std::string manual_page(const std::string& version);

}  // namespace wetdeck

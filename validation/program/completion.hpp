// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck --complete WORDS...`: what could stand in place of the last word. completion.bash asks it.
#pragma once

#include <string>
#include <vector>

namespace wetdeck {

/// @param words  of the command line behind the program's name; the last one is being written and may be
/// empty
/// @return those that begin as it does; none where a file or a value that cannot be listed is due
std::vector<std::string> completions(const std::vector<std::string>& words);

}  // namespace wetdeck

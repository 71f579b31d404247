// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck --complete WORDS...`: completions of the last word, for completion.bash.
#pragma once

#include <string>
#include <vector>

namespace wetdeck {

/// @param words  of the command line behind the program's name; the last one is being typed and may be empty
/// @return the possible words that begin with it; none where a file or a free value is expected
std::vector<std::string> completions(const std::vector<std::string>& words);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// Texts taken apart and put together.
#pragma once

#include <string>
#include <string_view>

namespace wetdeck::report {

/// Puts `to` in the place of every `from`.
void replace_all(std::string& text, std::string_view from, std::string_view to);

/// A field of a CSV file: on one line, in quotes where it holds a comma, a quote or a '#'.
std::string csv_field(std::string text);

}  // namespace wetdeck::report

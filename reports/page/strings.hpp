// SPDX-License-Identifier: BSD-3-Clause
// Texts taken apart and put together.
#pragma once

#include <string>
#include <string_view>

namespace wetdeck::report {

/// Puts `to` in the place of every `from`.
void replace_all(std::string& text, std::string_view from, std::string_view to);

/// A field of a CSV file: on one line, with semicolons for commas and single quotes for double ones, since
/// readers such as Octave's csvread know no quoted fields; in quotes where it holds a '#', which begins a
/// comment.
std::string csv_field(std::string text);

}  // namespace wetdeck::report

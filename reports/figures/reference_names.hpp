// SPDX-License-Identifier: BSD-3-Clause
// Short names of references, for legends and column headers.
#pragma once

#include <string>

namespace wetdeck::report {

/// The part of a comparison's title that names the reference: "Author (year), first digitisation", what
/// follows its first comma, or what follows "against" in a long title; the stem of its file where that part
/// is too long for a legend.
std::string reference_name(const std::string& title, const std::string& stem);

}  // namespace wetdeck::report

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wetdeck {

/// Revision of the numerical scheme. It grows with every change of the solver that changes results beyond
/// rounding; runs of different revisions are not compared with each other.
inline constexpr int scheme_revision = 3;

}  // namespace wetdeck

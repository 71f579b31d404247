// SPDX-License-Identifier: BSD-3-Clause
// What is beyond the left and the right end of a domain.
#pragma once

namespace wetdeck {

/// Walls at both ends; the other end, of a domain that is periodic along x; or a wall at the right end and
/// the mirror image behind a plane of symmetry at the left.
enum class DomainEnds { walls, periodic, mirror_left };

}  // namespace wetdeck

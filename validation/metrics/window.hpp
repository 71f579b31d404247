// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wetdeck {

/// Closed interval on the scaled abscissa.
struct Window {
    double begin = 0;
    double end = 0;
};

}  // namespace wetdeck

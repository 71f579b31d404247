// SPDX-License-Identifier: BSD-3-Clause
#include "validation/import/formats.hpp"

#include <array>

namespace wetdeck {

std::span<const ImportFormat> import_formats() {
    static constexpr std::array formats{
        ImportFormat{"openfoam", "function objects forces and probes: a case, postProcessing/NAME, or files",
                     read_openfoam},
        ImportFormat{"dualsphysics", "gauges and FloatingInfo, .csv", read_dualsphysics},
        ImportFormat{"sphinxsys", "recordings of observed and reduced quantities, .dat", read_sphinxsys},
        ImportFormat{"trixiparticles", "values of a PostprocessCallback, .csv or .json", read_trixiparticles},
        ImportFormat{"plain", "columns of numbers, the first one the time", read_plain},
    };
    return formats;
}

}  // namespace wetdeck

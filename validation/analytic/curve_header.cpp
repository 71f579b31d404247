// SPDX-License-Identifier: BSD-3-Clause
// Header of an analytic curve as the text of a reference file.
#include "validation/analytic/curve_header.hpp"

#include <fmt/core.h>

namespace wetdeck {

std::string curve_header_text(const CurveHeader& header, const char* columns) {
    return fmt::format(
        "# kind: analytic\n# citation: {}\n# doi: {}\n# figure: none\n# obtained: computed\n# obtained_from: "
        "{}\n"
        "# date: 2026-11-22\n# digitisation_error: none (computed when the comparison is made)\n# u_data: "
        "{}\n"
        "# u_data_source: {}\n# sensor: none\n# filter: none\n# sign: {}\n# time_origin: {}\n# note: "
        "{}\n{}\n",
        header.citation, header.doi, header.method, header.u_data, header.u_data_source, header.sign,
        header.time_origin, header.note, columns);
}

}  // namespace wetdeck

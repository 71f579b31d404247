// SPDX-License-Identifier: BSD-3-Clause
#include "validation/openfoam/foam_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace wetdeck {

std::string foam_head(const std::string& kind, const std::string& name) {
    return fmt::format(
        "FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {};\n    object {};\n}}\n", kind, name);
}

std::string foam_vector(Vec2 v, double z) {
    return fmt::format("({:.15g} {:.15g} {:.15g})", v.x(), v.y(), z);
}

std::string foam_scalars(const std::vector<double>& values) {
    const bool same =
        std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
    if (same && !values.empty()) return fmt::format("uniform {:.15g}", values.front());
    std::string text = fmt::format("nonuniform List<scalar>\n{}\n(\n", values.size());
    for (const double value : values) text += fmt::format("{:.12g}\n", value);
    return text + ")";
}

}  // namespace wetdeck

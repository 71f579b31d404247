// SPDX-License-Identifier: BSD-3-Clause
// Tables repeated for each variant.
#pragma once

#include <string>
#include <vector>

#include "reports/page/html.hpp"

namespace wetdeck::report {

/// `content(variant)` for each variant, in a box where there are several; the first box is open.
template <typename Content>
std::string by_variant(const std::vector<std::string>& variants, Content&& content) {
    if (variants.size() == 1) return content(variants.front());
    std::string out;
    for (const std::string& variant : variants) {
        const std::string html = content(variant);
        if (!html.empty()) out += details("Variant " + variant, html, variant == variants.front());
    }
    return out;
}

}  // namespace wetdeck::report

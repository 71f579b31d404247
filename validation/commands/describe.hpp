// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck list` and `wetdeck describe`.
#pragma once

#include <string>

namespace wetdeck {

void print_list(bool as_json);
void print_description(const std::string& scene, bool as_json);

}  // namespace wetdeck

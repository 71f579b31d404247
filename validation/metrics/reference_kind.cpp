// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/reference_kind.hpp"

#include <array>

namespace wetdeck {
namespace {

constexpr std::array<ReferenceKindInfo, 4> table{{
    {ReferenceKind::experiment, "experiment", "measurements", true, false, ""},
    {ReferenceKind::peer_simulation, "peer-simulation", "other simulations (peer simulations, no validation)",
     false, false, "another simulation, no measurement"},
    {ReferenceKind::analytic, "analytic", "exact or analytic solutions", false, true, ""},
    {ReferenceKind::stated, "stated", "values stated in the source", false, false,
     "stated in a publication, no measurement"},
}};

}  // namespace

std::span<const ReferenceKindInfo> reference_kinds() {
    return table;
}

std::vector<std::string> reference_kind_names() {
    std::vector<std::string> names;
    for (const ReferenceKindInfo& info : table) names.emplace_back(info.name);
    return names;
}

const ReferenceKindInfo& describe(ReferenceKind kind) {
    return table[static_cast<std::size_t>(kind)];
}

std::optional<ReferenceKind> reference_kind_named(std::string_view name) {
    for (const ReferenceKindInfo& info : table) {
        if (name == info.name) return info.kind;
    }
    return std::nullopt;
}

std::string name_of(std::optional<ReferenceKind> kind) {
    return kind ? describe(*kind).name : "";
}

}  // namespace wetdeck

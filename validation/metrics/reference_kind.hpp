// SPDX-License-Identifier: BSD-3-Clause
// Kinds of references: who says what a value or a curve should be, and what agreement with it is worth. One
// table; everything that depends on the kind reads it there.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wetdeck {

enum class ReferenceKind { experiment, peer_simulation, analytic, stated };

struct ReferenceKindInfo {
    ReferenceKind kind;
    const char* name;         ///< in scene files, reference files and summary.json
    const char* heading;      ///< for readers of the report
    bool validates;           ///< agreement counts as validation, in E +- u_val
    bool exact;               ///< the reference has no uncertainty of its own
    const char* not_counted;  ///< why it does not enter bias and scatter; empty if it does
};

/// All kinds, in the order in which messages list them.
std::span<const ReferenceKindInfo> reference_kinds();
std::vector<std::string> reference_kind_names();

const ReferenceKindInfo& describe(ReferenceKind kind);

/// The kind of that name; none if there is no such kind.
std::optional<ReferenceKind> reference_kind_named(std::string_view name);

/// The name of the kind; empty where nobody has said what kind it is.
std::string name_of(std::optional<ReferenceKind> kind);

}  // namespace wetdeck

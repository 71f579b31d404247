// SPDX-License-Identifier: BSD-3-Clause
// Lists of fields: each array of a set of particles is declared once, with its name and what happens to it.
// Sorting, checkpoints and the account of memory follow from the declaration.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace wetdeck {

/// Whether a field follows its particle when particles are sorted, or is computed anew before it is read
/// (a sort may write to it).
enum class Sorted : bool { no, yes };
/// Whether a checkpoint holds a field.
enum class Stored : bool { no, yes };

/// One array of a set of particles.
template <class Particles, class Value>
struct Field {
    const char* name;                       ///< in a checkpoint
    std::vector<Value> Particles::*values;  ///< one entry a particle
    Sorted sorted;                          ///< whether it follows its particle
    Stored stored;                          ///< whether a checkpoint holds it

    /// A declaration; clang 14 deduces no template arguments of an aggregate.
    constexpr Field(const char* its_name, std::vector<Value> Particles::*array, Sorted follows, Stored kept)
        : name(its_name), values(array), sorted(follows), stored(kept) {}
};

/// Calls visit(field, array) for each field of `particles`, in the order of their declaration.
template <class Particles, class Visit>
void for_each_field(Particles& particles, const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field, particles.*field.values), ...); },
               fields_of(particles));
}

/// Appends one entry, zero, to every field.
template <class Particles>
void append_particle(Particles& particles) {
    for_each_field(particles, [](const auto&, auto& values) { values.emplace_back(); });
}

/// Memory of one particle in all fields [bytes].
template <class Particles>
std::size_t bytes_of_fields(const Particles& particles) {
    std::size_t sum = 0;
    for_each_field(particles, [&sum](const auto&, const auto& values) { sum += sizeof(values[0]); });
    return sum;
}

}  // namespace wetdeck

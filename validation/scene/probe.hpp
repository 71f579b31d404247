// SPDX-License-Identifier: BSD-3-Clause
// Probes: records of a scene besides the series of every run and of every body. One table of types drives
// the reading of scene files, the recording and the documentation: a new type is a row and a function in
// probe_types.cpp.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/simulation.hpp"
#include "validation/scene/series.hpp"

namespace wetdeck {

struct Scene;
class TomlTable;

/// Where a probe reads when the run starts [m], for drawings: a point, or a line from begin to end.
struct ProbePlace {
    Vec2 begin, end;
    bool through_fluid = false;  ///< else it lies on a wall or on a body
};

/// One probe of a scene, ready to be read.
struct Probe {
    SeriesInfo series;
    std::string note;
    std::vector<std::string> notes;   ///< on what was taken for what, with file, line and key
    std::vector<std::string> doubts;  ///< why it may read nothing of use, with file, line and key
    std::optional<ProbePlace> place;  ///< empty for a probe of the whole fluid
    /// Throws InputError where the probe is too small for the particle spacing; may be empty.
    std::function<void(double particle_spacing)> check;
    /// Appends the value, or the values of a profile [SI].
    std::function<void(const Simulation&, std::vector<double>&)> sample;
};

/// The sampling of a probe with one value.
template <class Read>
auto scalar_reading(Read read) {
    return [read](const Simulation& s, std::vector<double>& out) { out.push_back(read(s)); };
}

struct ProbeType {
    const char* name;
    const char* unit;
    const char* records;            ///< the description of the series, unless `read` gives one
    std::vector<const char*> keys;  ///< that `read` needs, besides name, type and note
    /// Everything but name, unit and note. Throws InputError for a place where the probe could never read.
    Probe (*read)(const TomlTable& table, const Scene& scene);
    std::vector<const char*> optional_keys = {};  ///< that `read` asks for and can do without
};

/// All types, in the order in which messages list them.
std::span<const ProbeType> probe_types();

/// One table of [[probes]]. Throws InputError for an unknown type and for unknown, missing or wrong keys.
Probe read_probe(const TomlTable& table, const Scene& scene);

}  // namespace wetdeck

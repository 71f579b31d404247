// SPDX-License-Identifier: BSD-3-Clause
// [[probes]]: each is read by its type (probe_types.cpp).
#include <algorithm>
#include <set>

#include "validation/scene/sections.hpp"

namespace wetdeck {

Probe read_probe(const TomlTable& table, const Scene& scene) {
    const std::string name = table.text("name");
    std::vector<std::string> names;
    for (const ProbeType& type : probe_types()) names.emplace_back(type.name);
    const std::string chosen = table.choice("type", names);
    const auto found = std::find(names.begin(), names.end(), chosen);
    const ProbeType& type = probe_types()[static_cast<std::size_t>(found - names.begin())];
    Probe probe = type.read(table, scene);
    probe.series.name = name;
    probe.series.unit = type.unit;
    if (probe.series.description.empty()) probe.series.description = type.records;
    probe.note = table.text_or("note", "");
    table.finish();
    return probe;
}

void read_probes(const TomlTable& root, Scene& scene) {
    std::set<std::string> names;
    for (const TomlTable& table : root.tables("probes")) {
        scene.probes.push_back(read_probe(table, scene));
        for (const std::string& note : scene.probes.back().notes) scene.notes.push_back(note);
        if (!names.insert(scene.probes.back().series.name).second) table.fail("name", "is used twice");
    }
}

}  // namespace wetdeck

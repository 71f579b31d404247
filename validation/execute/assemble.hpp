// SPDX-License-Identifier: BSD-3-Clause
// From a scene and a spacing to particles, walls and probes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"

namespace wetdeck {

/// The simulation of a scene, ready to run. Throws InputError for a spacing that does not fit.
Simulation assemble(const Scene& scene, double particle_spacing, int threads);

/// All scalar series of a scene: its probes, then what every run records. One pass over the particles serves
/// the latter.
class Recorders {
  public:
    /// Throws InputError where a probe is too small for the spacing.
    Recorders(const Scene& scene, double particle_spacing);

    const std::vector<SeriesInfo>& list() const { return list_; }
    /// One value per recorder, in SI units.
    void sample(const Simulation& simulation, std::vector<double>& values) const;

  private:
    std::vector<SeriesInfo> list_;
    std::vector<std::function<double(const Simulation&)>> probes_;
};

/// Throws InputError if the spacing does not fit the scene or its probes; nothing is run.
void check_spacing(const Scene& scene, double particle_spacing);

}  // namespace wetdeck

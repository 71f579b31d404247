// SPDX-License-Identifier: BSD-3-Clause
// From a scene and a spacing to particles, walls and probes.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "solver/simulation.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// The simulation of a scene, ready to run. Throws InputError for a spacing that does not fit.
Simulation assemble(const Scene& scene, double particle_spacing, int threads);

/// All series of a scene: its probes, what every run records, and its bodies.
class Recorders {
  public:
    /// Throws InputError where a probe is too small for the spacing.
    Recorders(const Scene& scene, double particle_spacing);

    const std::vector<SeriesInfo>& list() const { return list_; }
    /// The values of one sample in the order of list(), a profile with all its columns [SI].
    /// @param audit  whether to take the momentum error anew, which costs a pass, or to keep that of the last
    /// sample
    void sample(const Simulation& simulation, bool audit, std::vector<double>& values) const;

  private:
    void add_probe(const Scene& scene, const ProbeSpec& spec, double particle_spacing);

    std::vector<SeriesInfo> list_;
    std::vector<std::function<void(const Simulation&, std::vector<double>&)>> probes_;
};

/// Adds what follows from the impulses and velocities of the bodies: forces and accelerations as means over
/// the two intervals about each sample, and filtered by a centred moving mean of the scene's width. No sample
/// falls between them: the integral of the force is the impulse that the body received.
void add_body_means(const Scene& scene, std::map<std::string, Series>& series);

/// Throws InputError if the spacing does not fit the scene or its probes; nothing is run.
void check_spacing(const Scene& scene, double particle_spacing);

/// The same for a spacing of one of the scene's tiers; the error names file, variant and tier.
void check_row(const Scene& scene, const std::string& tier, double particle_spacing);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The series that a run records, and the means that are taken of them.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "solver/core/curve.hpp"
#include "validation/scene/scene.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// All series of a scene: of its probes, of its bodies and of every run.
class Recorders {
  public:
    /// Throws InputError where a probe is too small for the spacing.
    Recorders(const Scene& scene, double particle_spacing);

    const std::vector<SeriesInfo>& list() const { return list_; }
    /// The values of one sample in the order of list(), a profile with all its columns [SI].
    /// @param number  number of the sample since the start of the run: costly values are taken at some only
    /// @param values  in: values of the sample before, which are repeated where none is taken
    void sample(const Simulation& simulation, std::size_t number, std::vector<double>& values) const;

  private:
    std::vector<SeriesInfo> list_;
    std::vector<Probe> probes_;
    std::vector<Outline> outlines_;  ///< of the bodies, each in the frame of its body
    std::vector<Box> water_;         ///< at the start
    double surface_;                 ///< of the water at the start [m]
};

/// The mean slope of the curve over the interval of the given width about each of its abscissae; where the
/// curve ends, over the part of it that is there. A width of zero takes the two neighbouring samples.
std::vector<double> mean_slopes(const Curve& curve, double width);

/// Adds the forces and accelerations of the bodies, from their impulses and velocities, as means over the two
/// intervals about each sample, and filtered by a centred moving mean of the scene's width. No sample
/// falls between them: the integral of the force is the impulse that the body received.
void add_body_means(const Scene& scene, std::map<std::string, Series>& series);

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// The series that a run records beside its probes: of the whole fluid and of each body. A new one is a row of
// a table in series.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "solver/probes/energy.hpp"
#include "solver/setup/body_outline.hpp"
#include "solver/simulation.hpp"

namespace wetdeck {

/// A series that a run records.
struct SeriesInfo {
    std::string name;
    std::string unit;
    std::string description;
    std::vector<double> abscissa = {};  ///< of the columns of a profile, empty for a scalar
};

/// A series of every run, whatever its scene. Between the samples at which it is taken the last value is
/// repeated.
struct FluidSeries {
    SeriesInfo info;
    double (*value)(const Simulation&, const Balance&);
    std::size_t samples_between = 1;
};
const std::vector<FluidSeries>& every_run_series();

/// A series of the whole fluid that is taken when a field file is written: too costly for every sample.
struct FieldSeries {
    SeriesInfo info;
    enum class Needs { air, bodies, bodies_and_resolution } needs;  ///< what a scene must have
    /// @param outlines  of the bodies, in their frames about the mass centre [m]
    double (*value)(const Simulation&, std::span<const Outline> outlines);
};
const std::vector<FieldSeries>& all_field_series();

/// A body at one time of a run.
struct BodyNow {
    const Simulation& simulation;
    const RigidBody& body;
    std::span<const Vec2> outline;  ///< corners, in the frame of the body [m]
    std::span<const Box> water;     ///< boxes of the water at the start
    double surface;                 ///< of the scene's water, where no box is [m]
};

/// A series of each body.
struct BodySeries {
    SeriesInfo info;
    double (*value)(const BodyNow&);
};
const std::vector<BodySeries>& recorded_body_series();

/// The rate of change of a recorded series of a body, taken when the run has ended.
struct DerivedSeries {
    SeriesInfo info;
    const char* recorded;
    bool filtered = false;  ///< as a moving mean of the scene's width
};
const std::vector<DerivedSeries>& derived_body_series();

/// A series that the analysis makes of recorded ones of every run; run.h5 does not hold it.
struct AnalysedSeries {
    SeriesInfo info;
};
const std::vector<AnalysedSeries>& analysed_series();

/// "body_force_y" for the first body, "body_force_y_2" for the second.
std::string body_series_name(const std::string& name, std::size_t body);

}  // namespace wetdeck

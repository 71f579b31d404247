// SPDX-License-Identifier: BSD-3-Clause
// A scene: everything a scene file says, for one variant, as plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "solver/bodies/moving_frame.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/core/execution.hpp"
#include "solver/core/vec2.hpp"
#include "solver/physics/model.hpp"
#include "solver/setup/body_outline.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/scene/probe.hpp"

namespace wetdeck {

/// A rigid body of a scene, or a solid that is fixed in the tank: its outline as placed at the start, and its
/// state then.
struct BodySpec {
    std::string name;                  ///< of its table: body, body_2, ..., or of the solid
    Outline outline;                   ///< corners in the scene at the start [m]
    Outline drawn;                     ///< the same before the body is turned by its angle [m]
    Vec2 origin = Vec2::Zero();        ///< of the frame in which the file gives the outline [m]
    Vec2 drawn_centre = Vec2::Zero();  ///< mass centre before the body is turned [m]
    RigidBody body;
    double even_inertia = 0;  ///< about the mass centre, with the mass spread evenly over the outline [kg m]
    bool solid = false;       ///< fixed in the tank, whose faces it may touch
    bool release_at_contact = false;  ///< its free motions are held until water touches it
    std::string guide;  ///< its motion, hinge, springs and release as the file gives them; empty: none

    /// A point of the outline's frame in the frame of the mass centre [m].
    Vec2 in_body_frame(Vec2 point) const { return point + origin - drawn_centre; }
    /// A point of the outline's frame in the scene, before the body is turned [m].
    Vec2 as_drawn(Vec2 point) const { return point + origin; }
    /// A point of the outline's frame in the scene at the start [m].
    Vec2 at_start(Vec2 point) const { return body.placed(in_body_frame(point)); }
    /// The outline in the frame of the mass centre [m].
    Outline local_outline() const;
};

struct InitialPressure {
    enum class Law { hydrostatic, greco };
    Law law = Law::hydrostatic;
    double surface = 0;        ///< height of the water's highest surface, as the file says [m]
    double released_face = 0;  ///< greco: x of the face that was held by the gate [m]
};

/// Particles that are finest around a place and grow away from it.
struct Resolution {
    Box box;                       ///< that holds the finest [m]
    double growth = 0.05;          ///< of the spacing from one particle to the next [-]
    double coarsest = 8;           ///< largest spacing over the finest [-]
    std::optional<double> finest;  ///< of a run that is given no spacing [m]
};

/// Reasons why a scene lives with a doubt that `check` would raise; empty: it does not.
struct AcceptedDoubts {
    std::string sound_speed;  ///< of the water, too low for slamming
    std::string echo;         ///< of the tank, inside a window
};

struct VariantInfo {
    std::string name;
    std::string description;
    std::string scheme;  ///< that it names, or empty
};

/// Spacings [m] by variant.
using Tier = std::map<std::string, std::vector<double>>;

struct Scene {
    AnalysisSpec analysis;
    std::string variant;
    std::vector<VariantInfo> variants;
    std::map<std::string, Tier> tiers;
    Model model;
    Execution execution;
    bool air = true;
    std::string air_law;        ///< of the air's sound speed, or empty
    std::string source_scheme;  ///< the scheme of the scene's source, or empty
    Box tank;
    MovingFrame tank_motion;
    std::optional<Resolution> resolution;  ///< none: all spacings are equal
    std::optional<double> symmetry;        ///< x of the plane: the half to the right of it is computed [m]
    std::string tank_guide;  ///< the motion of the tank as the file gives it; empty: it is at rest
    AcceptedDoubts accepted;
    std::vector<Box> water_boxes, air_boxes;
    std::vector<Vec2> water_velocities;  ///< of the water boxes at the start [m/s]; empty: at rest
    std::vector<BodySpec> bodies;
    InitialPressure initial;
    std::uint64_t arrangement = 0;  ///< seed of settled_arrangement; 0: the lattice
    std::vector<Probe> probes;
    double end_time = 0;                       ///< [s]
    double sample_interval = 0;                ///< of the probes [s]
    double force_filter = 0;                   ///< width of the moving mean of filtered forces [s]
    std::vector<double> frame_times;           ///< of the field files [s], sorted
    std::map<std::string, double> parameters;  ///< of its expressions [SI, rad]
    std::vector<std::string> unused_parameters;
    std::vector<double> picture_times;   ///< of the frames that the report shows [s]
    std::string text;                    ///< the file as read, with the outlines that it takes from others
    std::string path;                    ///< where it was read
    std::vector<std::string> overrides;  ///< KEY=VALUE, as given
    std::vector<std::string> notes;      ///< on old names of keys, for the user
    std::string resolved;                ///< the document after scheme, variant and --set
    std::string probe_text;              ///< the tables of the probes without their notes

    const std::string& name() const { return analysis.scene; }
};

/// Whether coarse water may take longer steps than fine water: spacings differ, and there is no air, which
/// takes the short steps where there is.
inline bool takes_coarse_substeps(const Scene& scene) {
    return scene.resolution && !scene.air;
}

/// Reads and checks a scene file for one variant (the default one if not named), with KEY=VALUE overrides on
/// top. Throws InputError "file:line: key 'a.b': what was expected".
Scene read_scene(const std::filesystem::path& path, const std::optional<std::string>& variant = std::nullopt,
                 const std::vector<std::string>& overrides = {});

/// The same from a text that was stored with a run.
Scene parse_scene(const std::string& text, const std::string& path,
                  const std::optional<std::string>& variant = std::nullopt,
                  const std::vector<std::string>& overrides = {});

/// Names of the scenes that come with the program, and where a name or path leads.
std::vector<std::string> scene_names();
std::filesystem::path find_scene(const std::string& name_or_path);

/// Where installed or source data lie: scenes/, schemes/ and reference_data/. The environment variable
/// WETDECK_DATA names another root.
std::filesystem::path scene_directory();
std::filesystem::path scheme_directory();
std::filesystem::path reference_directory();

/// The series at the field files that a run of the scene holds.
std::vector<FieldSeries> field_series(const Scene& scene);
/// The outlines that move with a body at the start: its own and those joined to it [m].
std::vector<Outline> outlines_carried_by(const Scene& scene, const BodySpec& body);
/// Outlines of the bodies in their frames about the mass centre [m].
std::vector<Outline> local_outlines(const Scene& scene);

/// Particles, steps and particle-steps that a run at this spacing will take, from the scene alone.
struct CostEstimate {
    double fluid_particles = 0;
    double steps = 0;
    double particle_steps = 0;
    double core_seconds = 0;  ///< at the throughput this program reaches per core on AVX-512
};
CostEstimate estimate_cost(const Scene& scene, double particle_spacing);

}  // namespace wetdeck

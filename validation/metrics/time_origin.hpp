// SPDX-License-Identifier: BSD-3-Clause
// Time origins: instants of a run from which quantities and comparisons count their time.
//
// An origin is a number that the scene states, or an event that each run finds in its own series: the first
// instant at which a series falls or rises through a level, interpolated linearly between two samples. Two
// events of a body have names of their own:
//   geometric_contact  the lowest point of the outline meets the initial level: body_clearance falls through
//   0 first_contact      water touches the body: body_water_gap, from the outline to the nearest water, falls
//                      through a quarter of the spacing; the start of the run where the body starts wet
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/metrics/specification.hpp"
#include "validation/store/run_record.hpp"

namespace wetdeck {

/// The gap between a body and the nearest water at which the water touches it [spacings].
inline constexpr double contact_gap = 0.25;

OriginEvent geometric_contact(const std::string& body, const std::string& clearance_series);
OriginEvent first_contact(const std::string& body, const std::string& gap_series);

/// The event or the number in a run's own record.
struct FoundOrigin {
    double time = 0;      ///< on the clock of the run [s]
    double interval = 0;  ///< between the two samples about it [s], zero for a stated number
    std::string problem;  ///< why there is none; empty if there is
};

/// The first instant at which the event happens in the run.
FoundOrigin find_event(const RunRecord& record, const OriginEvent& event);

/// Where the scaling has its time zero: as the record has kept it, else as the scaling says.
FoundOrigin find_origin(const RunRecord& record, const SeriesScaling& scaling);

/// The origins as text for the record of a run.
std::string origins_text(const std::map<std::string, TimeOrigin>& origins);

/// One sentence for each stated number of a contact that differs from the contact which the run found by more
/// than the sample interval.
std::vector<std::string> doubtful_origins(const AnalysisSpec& spec, const RunRecord& record);

}  // namespace wetdeck

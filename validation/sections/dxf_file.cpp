// SPDX-License-Identifier: BSD-3-Clause
// From a DXF drawing to the outlines of its layers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"
#include "validation/sections/closed_outlines.hpp"
#include "validation/sections/dxf_curves.hpp"
#include "validation/sections/section_file.hpp"

namespace wetdeck {
namespace {

constexpr double joined_within = 1e-5;  // of the larger side of what the layer shows

/// Units of $INSUNITS (DXF Reference, "Header").
const std::map<int, const char*> unit_names = {{1, "inch"}, {2, "ft"}, {3, "mile"}, {4, "mm"},  {5, "cm"},
                                               {6, "m"},    {7, "km"}, {10, "yd"},  {14, "dm"}, {15, "dam"}};

struct DrawingUnit {
    double metres = 1;
    std::string words;
};

DrawingUnit unit_of(const dxf::Drawing& drawing, const std::string& name, const SectionOptions& options) {
    const auto stated = drawing.unit ? unit_names.find(*drawing.unit) : unit_names.end();
    if (options.unit) {
        if (!is_length(*options.unit))
            throw InputError(fmt::format(
                "{}: the unit '{}' is none of length, expected one such as mm, m, ft", name, *options.unit));
        const bool other = stated != unit_names.end() &&
                           unit_named(stated->second).factor != unit_named(*options.unit).factor;
        return {unit_named(*options.unit).factor,
                *options.unit + ", as asked for" +
                    (other ? fmt::format(" ($INSUNITS of the drawing says {})", stated->second) : "")};
    }
    if (stated == unit_names.end())
        throw DataError(fmt::format(
            "{}: the drawing {}: expected it from you, --unit mm for a command, #unit=mm behind the name "
            "of the file in a scene",
            name,
            drawing.unit && *drawing.unit != 0
                ? fmt::format("has $INSUNITS {}, which is no unit that is read here", *drawing.unit)
                : "does not state its unit ($INSUNITS)"));
    return {unit_named(stated->second).factor, fmt::format("{}, as $INSUNITS says", stated->second)};
}

/// The larger side of what each layer shows [m].
std::map<std::string, double> extents_of(const dxf::DrawnCurves& drawn) {
    std::map<std::string, Box> boxes;
    for (const dxf::DrawnCurve& each : drawn.curves)
        for (const Vec2& point : each.curve.points) {
            Box& box = boxes.try_emplace(each.layer, Box{point, point}).first->second;
            box.low = box.low.cwiseMin(point);
            box.high = box.high.cwiseMax(point);
        }
    std::map<std::string, double> extents;
    for (const auto& [layer, box] : boxes) extents[layer] = (box.high - box.low).maxCoeff();
    return extents;
}

void add_closed(const PlaneCurve& curve, Station& station) {
    if (const auto at = self_crossing(curve.points)) {
        station.notes.push_back(fmt::format(
            "a closed curve crosses itself near ({:.4g}, {:.4g}) m and is left out", at->x(), at->y()));
        return;
    }
    for (Outline& outline : closed_outlines({curve.points}).outlines)
        station.outlines.push_back({std::move(outline), true});
}

/// From the lower end up.
void add_open(PlaneCurve curve, Station& station) {
    if (curve.points.size() < 3) {
        station.notes.push_back("a single straight line is left out");
        return;
    }
    if (curve.points.back().y() < curve.points.front().y())
        std::reverse(curve.points.begin(), curve.points.end());
    station.outlines.push_back({std::move(curve.points), false});
}

Station station_of(const std::string& layer, const dxf::DrawnCurves& drawn, double extent) {
    Station station;
    station.name = layer;
    std::vector<PlaneCurve> pieces;
    for (const dxf::DrawnCurve& each : drawn.curves) {
        if (each.layer != layer) continue;
        pieces.push_back(each.curve);
        if (!station.source.empty()) station.source += '\n';
        station.source += each.source;
    }
    const JoinedCurves all = joined(pieces, joined_within * extent);
    for (const PlaneCurve& curve : all.curves)
        if (curve.closed)
            add_closed(curve, station);
        else
            add_open(curve, station);
    std::stable_sort(station.outlines.begin(), station.outlines.end(),
                     [](const SectionOutline& a, const SectionOutline& b) {
                         const auto low = [](const SectionOutline& o) {
                             double least = std::numeric_limits<double>::infinity();
                             for (const Vec2& corner : o.corners) least = std::min(least, corner.y());
                             return least;
                         };
                         return low(a) < low(b);
                     });
    if (all.curves.size() < pieces.size())
        station.notes.push_back(fmt::format(
            "{} lines and arcs are joined to {} curve{}; the widest gap between two ends is {:.2g} m",
            pieces.size(), all.curves.size(), all.curves.size() == 1 ? "" : "s", all.widest_gap));
    return station;
}

std::string counted(const std::map<std::string, int>& left_out) {
    std::vector<std::string> words;
    for (const auto& [kind, count] : left_out) words.push_back(fmt::format("{} {}", count, kind));
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

SectionFile parse_dxf(const std::string& name, std::string_view text, const SectionOptions& options) {
    const dxf::Drawing drawing = dxf::parse(name, text);
    const DrawingUnit unit = unit_of(drawing, name, options);
    SectionFile file;
    file.format = "DXF drawing";
    file.unit = unit.words;
    file.key = "layer";
    file.drawn_as_body_plan = true;
    dxf::DrawnCurves drawn;
    std::map<std::string, double> extents;
    try {
        extents = extents_of(dxf::drawn_curves(drawing, unit.metres, options.axis, [](const std::string&) {
            return std::numeric_limits<double>::max() / 4;
        }));
        drawn = dxf::drawn_curves(drawing, unit.metres, options.axis, [&](const std::string& layer) {
            const auto extent = extents.find(layer);
            return options.tolerance.value_or(chord_tolerance *
                                              (extent == extents.end() ? 1 : extent->second));
        });
    } catch (const dxf::EntityError& error) {
        throw DataError(fmt::format("{}:{}", name, error.what()));
    }
    for (const auto& [layer, extent] : extents) {
        Station station = station_of(layer, drawn, extent);
        if (station.outlines.empty()) {
            for (const std::string& note : station.notes)
                file.notes.push_back(fmt::format("Layer {}: {}.", layer, note));
            continue;
        }
        file.stations.push_back(std::move(station));
    }
    const std::string left_out = drawn.left_out.empty() ? "" : "Left out: " + counted(drawn.left_out) + ".";
    if (!left_out.empty()) file.notes.push_back(left_out);
    if (file.stations.empty())
        throw DataError(
            fmt::format("{}: no outline found, expected LWPOLYLINE, POLYLINE, LINE, ARC, CIRCLE or "
                        "SPLINE on a layer that is shown{}",
                        name, left_out.empty() ? "" : ". " + left_out));
    return file;
}

}  // namespace wetdeck

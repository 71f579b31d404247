// SPDX-License-Identifier: BSD-3-Clause
// From the shapes, components and parts of a GHS geometry file to the outlines of its stations in metres.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/sections/closed_outlines.hpp"
#include "validation/sections/ghs_model.hpp"
#include "validation/sections/plane_curves.hpp"
#include "validation/sections/section_file.hpp"

namespace wetdeck {
namespace {

using ghs::foot;

constexpr double same_station = 0.005 * foot;  // half of the closest that the format allows [m]
constexpr double on_axis = 1e-6 * foot;        // [m]

/// The points of one section with its arcs as chords, as it is written [m].
Outline drawn(const std::string& file, const ghs::Section& section, std::optional<double> tolerance) {
    Vec2 low = section.points.front().place, high = low;
    for (const ghs::Point& point : section.points) {
        low = low.cwiseMin(point.place);
        high = high.cwiseMax(point.place);
    }
    const double off_arc =
        tolerance.value_or(std::max(chord_tolerance * foot * (high - low).maxCoeff(), 1e-9));
    Outline curve;
    const auto add = [&curve](Vec2 point) {
        if (curve.empty() || curve.back() != point) curve.push_back(point);
    };
    for (std::size_t k = 0; k < section.points.size(); ++k) {
        const ghs::Point& point = section.points[k];
        if (const ghs::Point* before = k > 0 ? &section.points[k - 1] : nullptr;
            before && point.radius != 0 && before->radius == point.radius) {
            try {
                for (const Vec2& on_arc :
                     arc_by_radius(foot * before->place, foot * point.place, foot * point.radius, off_arc))
                    add(on_arc);
            } catch (const InputError& error) {
                throw DataError(fmt::format("{}:{}: {}", file, point.line, error.what()));
            }
        }
        add(foot * point.place);
    }
    if (curve.size() > 1 && curve.front() == curve.back()) curve.pop_back();
    return curve;
}

Outline mirrored(Outline curve) {
    for (Vec2& corner : curve) corner.x() = -corner.x();
    std::reverse(curve.begin(), curve.end());  // stays counter-clockwise
    return curve;
}

struct Reach {
    double low = std::numeric_limits<double>::infinity(), high = -low;
};

Reach transverse_reach(const ghs::Shape& shape) {
    Reach reach;
    for (const ghs::Section& section : shape.sections)
        for (const ghs::Point& point : section.points) {
            reach.low = std::min(reach.low, foot * point.place.x());
            reach.high = std::max(reach.high, foot * point.place.x());
        }
    return reach;
}

bool one_sided(Reach reach) {
    return (reach.low >= -on_axis || reach.high <= on_axis) && reach.high - reach.low > on_axis;
}

bool ends_on_axis(const Outline& curve) {
    return std::abs(curve.front().x()) <= on_axis || std::abs(curve.back().x()) <= on_axis;
}

/// The closed curves of one section of a component, before the shift.
std::vector<Outline> curves_of(const Outline& curve, int side) {
    if (side == 1) return {curve};
    if (side == -1) return {mirrored(curve)};
    Reach reach;
    for (const Vec2& corner : curve) {
        reach.low = std::min(reach.low, corner.x());
        reach.high = std::max(reach.high, corner.x());
    }
    if (!one_sided(reach)) return {curve};
    if (!ends_on_axis(curve)) return {curve, mirrored(curve)};
    Outline whole = curve;
    for (const Vec2& corner : mirrored(curve))
        if (whole.back() != corner) whole.push_back(corner);
    if (whole.front() == whole.back()) whole.pop_back();
    return {whole};
}

class Stations {
  public:
    Stations(std::string file, const SectionOptions& options) : name_(std::move(file)), options_(options) {}

    SectionFile of(const ghs::Model& model) {
        file_.format = "GHS geometry file";
        file_.unit = "ft, as the format has it";
        if (model.preferred_unit == 'M') file_.unit += " (P:M only tells a program what to show)";
        file_.bow_first = true;
        file_.key = "station";
        collect(model);
        check_halves();
        for (const double location : locations()) add_station(location);
        if (file_.stations.empty()) throw DataError(name_ + ": holds no section of a hull");
        return std::move(file_);
    }

  private:
    void collect(const ghs::Model& model) {
        std::set<std::string> names, left_out;
        for (const ghs::Part& part : model.parts)
            for (const ghs::Component& component : part.components) {
                names.insert(component.name);
                if (options_.component ? component.name != *options_.component : part.type != 1)
                    left_out.insert(component.name);
                else
                    components_.push_back(component);
            }
        if (options_.component && components_.empty())
            throw DataError(fmt::format("{}: no component '{}', expected one of {}", name_,
                                        *options_.component, fmt::join(names, ", ")));
        if (model.parts.empty() && model.shapes.size() == 1) {
            ghs::Component alone;
            alone.name = model.shapes.front().name;
            alone.shape = model.shapes.front();
            components_.push_back(alone);
            file_.notes.push_back("The file holds a shape and no part: it is taken for the hull.");
        }
        if (components_.empty())
            throw DataError(fmt::format("{}: holds no part of type 1, a hull{}", name_,
                                        model.shapes.empty() ? ", and no shape" : ""));
        if (!left_out.empty())
            file_.notes.push_back(
                fmt::format("Left out: {} ({}).", fmt::join(left_out, ", "),
                            options_.component ? "not asked for" : "tanks and windage, no hull"));
        for (const ghs::Component& component : components_) {
            if (component.effectiveness > 0 && component.effectiveness < 1)
                file_.notes.push_back(
                    fmt::format("Component {} has effectiveness {}: its outlines and areas are those drawn.",
                                component.name, component.effectiveness));
            if (component.shape.has_shell)
                file_.notes.push_back(fmt::format(
                    "Shape {} has a thickness of shell: its outlines are those drawn, shell included.",
                    component.shape.name));
        }
    }

    /// One half with a side factor of 1 would be a body cut along the centre line.
    void check_halves() {
        for (std::size_t k = 0; k < components_.size(); ++k) {
            ghs::Component& one = components_[k];
            const bool ends =
                std::any_of(one.shape.sections.begin(), one.shape.sections.end(), [](const ghs::Section& s) {
                    return s.points.size() > 2 && (std::abs(s.points.front().place.x()) * foot <= on_axis ||
                                                   std::abs(s.points.back().place.x()) * foot <= on_axis);
                });
            if (one.side == 0 || !ends || !one_sided(transverse_reach(one.shape))) continue;
            const auto other = std::find_if(components_.begin(), components_.end(), [&](const auto& c) {
                return c.shape.name == one.shape.name && c.side == -one.side &&
                       c.effectiveness == one.effectiveness && (c.shift - one.shift).norm() < 1e-9;
            });
            if (other == components_.end() || std::abs(one.shift.y()) > 1e-9)
                throw DataError(fmt::format(
                    "{}:{}: component {} has side factor {}, which takes its shape as drawn, but all of the "
                    "shape lies on one side and ends on its centre line: expected side factor 0, which "
                    "mirrors it",
                    name_, one.line, one.name, one.side));
            one.side = 0;
            components_.erase(other);
            k = 0;
        }
    }

    std::vector<double> locations() const {
        std::vector<double> all;
        for (const ghs::Component& component : components_)
            for (const ghs::Section& section : component.shape.sections)
                all.push_back(foot * (section.location + component.shift.x()));
        std::sort(all.begin(), all.end());
        all.erase(
            std::unique(all.begin(), all.end(), [](double a, double b) { return b - a <= same_station; }),
            all.end());
        return all;
    }

    void add_curves(const ghs::Component& component, const ghs::Section& section, Station& station) {
        if (!station.source.empty()) station.source += '\n';
        station.source += component.source + '\n' + section.source;
        const Outline curve = drawn(name_, section, options_.tolerance);
        if (curve.size() < 3) return;
        const std::vector<Outline> curves = curves_of(curve, component.side);
        for (const Outline& whole : curves)
            if (const auto at = self_crossing(whole)) {
                station.problem =
                    fmt::format("the curve of component {} crosses itself near ({:.4g}, {:.4g}) m",
                                component.name, at->x(), at->y());
                return;
            }
        if (signed_area(curves.front()) < 0)
            station.notes.push_back(fmt::format(
                "component {} is drawn clockwise; the format asks for the other way", component.name));
        if (curves.size() == 2)
            station.notes.push_back(fmt::format(
                "component {} lies beside its centre line: it is there on both sides", component.name));
        for (Outline shifted : curves) {
            for (Vec2& corner : shifted) corner += foot * component.shift.tail<2>();
            (component.effectiveness < 0 ? taken_away_ : added_).push_back(std::move(shifted));
        }
    }

    void add_component(const ghs::Component& component, double location, Station& station) {
        const auto& sections = component.shape.sections;
        const auto place = [&](const ghs::Section& s) { return foot * (s.location + component.shift.x()); };
        for (const ghs::Section& section : sections)
            if (std::abs(place(section) - location) <= same_station)
                return add_curves(component, section, station);
        if (place(sections.front()) < location && location < place(sections.back()))
            station.problem = fmt::format(
                "component {} passes it and has no section there (ask for one "
                "component alone, or for a station that all have)",
                component.name);
    }

    void add_station(double location) {
        Station station;
        station.location = location;
        added_.clear();
        taken_away_.clear();
        for (const ghs::Component& component : components_) add_component(component, location, station);
        double drawn_area = 0;
        for (const Outline& curve : added_) drawn_area += std::abs(signed_area(curve));
        try {
            const ClosedOutlines closed = closed_outlines(added_, taken_away_);
            double area = 0;
            for (const Outline& outline : closed.outlines) {
                station.outlines.push_back({outline, true});
                area += signed_area(outline);
            }
            for (const Outline& hole : closed.holes) area += signed_area(hole);
            if (!closed.holes.empty() && station.problem.empty())
                station.problem = "its outlines enclose a hole, which no outline of a body can show";
            if (taken_away_.empty() && area < 0.999 * drawn_area)
                station.notes.push_back("components overlap: what both hold counts once");
        } catch (const InputError& error) {
            station.problem = error.what();
        }
        if (station.outlines.empty() && station.problem.empty())
            station.problem = "it is a point or a line without an area";
        file_.stations.push_back(std::move(station));
    }

    std::string name_;
    const SectionOptions& options_;
    SectionFile file_;
    std::vector<ghs::Component> components_;
    std::vector<Outline> added_, taken_away_;
};

}  // namespace

SectionFile parse_ghs(const std::string& name, std::string_view text, const SectionOptions& options) {
    if (options.unit)
        throw InputError(
            fmt::format("{}: a GHS geometry file holds feet, whatever it says: expected no "
                        "unit beside it",
                        name));
    return Stations(name, options).of(ghs::parse(name, text));
}

}  // namespace wetdeck

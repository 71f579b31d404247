// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/pictures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "validation/scene/shown_frames.hpp"
#include "validation/store/fields.hpp"
#include "validation/store/raster.hpp"

namespace wetdeck {
namespace {

std::vector<std::string> colours(Rgb (*map)(double)) {
    constexpr int count = 24;
    std::vector<std::string> result;
    for (int k = 0; k < count; ++k) {
        const Rgb c = map(static_cast<double>(k) / (count - 1));
        result.push_back(fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]));
    }
    return result;
}

/// Seconds per unit of T if it is the same for all comparisons.
std::optional<double> time_scale(const AnalysisSpec& analysis) {
    if (analysis.comparisons.empty()) return std::nullopt;
    const double scale = analysis.comparisons.front().x_scale;
    const bool one = std::all_of(
        analysis.comparisons.begin(), analysis.comparisons.end(),
        [scale](const ComparisonSpec& c) { return c.x_scale == scale && c.x_offset == 0 && !c.event; });
    return one && scale != 1 && scale > 0 ? std::optional(scale) : std::nullopt;
}

/// The frame nearest to a time; none further away than 2 % of the run.
const FrameEntry* frame_near(const Scene& scene, const std::vector<FrameEntry>& frames, double time) {
    const auto nearest =
        std::min_element(frames.begin(), frames.end(), [time](const FrameEntry& a, const FrameEntry& b) {
            return std::abs(a.time - time) < std::abs(b.time - time);
        });
    const bool near = nearest != frames.end() && std::abs(nearest->time - time) <= 0.02 * scene.end_time;
    return near ? &*nearest : nullptr;
}

/// Frames nearest to those that the report looks for.
std::vector<const FrameEntry*> frames_found(const Scene& scene, const RunRecord& record,
                                            const std::vector<FrameEntry>& frames) {
    std::map<double, const FrameEntry*> shown;
    const auto take = [&](double time) {
        if (const FrameEntry* frame = frame_near(scene, frames, time)) shown.emplace(frame->time, frame);
    };
    for (const double time : wanted_pictures(scene, record.variant)) take(time);
    std::vector<const FrameEntry*> in_order;
    for (const auto& entry : shown) in_order.push_back(entry.second);
    return in_order;
}

bool with_air(const RunRecord& record) {
    const auto air = record.provenance.find("air");
    return air != record.provenance.end() && air->second == "yes";
}

/// The whole tank; its colours are those of the pictures' own data (scale_to).
RasterOptions raster_of(const Scene& scene, const RunRecord& record) {
    RasterOptions options;
    options.width = 600;
    options.x_min = scene.tank.low.x();
    options.x_max = scene.tank.high.x();
    options.y_min = scene.tank.low.y();
    options.y_max = scene.tank.high.y();
    options.particle_radius = 0.75 * record.particle_spacing;
    return options;
}

/// Values of the particles of one phase, over all frames.
struct Shown {
    std::vector<double> water_pressure, air_speed;

    void add(const FieldFrame& frame) {
        for (std::size_t i = 0; i < frame.phase.size(); ++i) {
            if (frame.phase[i] == 0) water_pressure.push_back(frame.pressure[i]);
            if (frame.phase[i] == 1) air_speed.push_back(std::hypot(frame.vx[i], frame.vy[i]));
        }
    }
};

/// A colour range that all but one particle in five hundred lie in, from zero on. A few particles, whose
/// pressure is noise, would take all colours else; how much lies beyond is said.
struct ColourRange {
    double end = 0;
    std::string clipped;  ///< empty: nothing is
};

ColourRange range_of(std::vector<double> values, const char* unit) {
    constexpr double shown_share = 0.998;
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return {1, ""};
    const auto place = static_cast<std::size_t>(shown_share * static_cast<double>(values.size() - 1));
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), end, values.end());
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const ColourRange range{*end > 0 ? *end : std::max(*high, 1.0), ""};
    const auto share = [&values](auto beyond) {
        return 100.0 * static_cast<double>(std::count_if(values.begin(), values.end(), beyond)) /
               static_cast<double>(values.size());
    };
    const double above = share([&](double value) { return value > range.end; });
    const double below = share([](double value) { return value < 0; });
    std::vector<std::string> parts;
    if (above > 0) parts.push_back(fmt::format("{:.1g} % above, up to {:.3g} {}", above, *high, unit));
    if (below > 0) parts.push_back(fmt::format("{:.1g} % below, down to {:.3g} {}", below, *low, unit));
    return {range.end, fmt::format("{}", fmt::join(parts, "; "))};
}

std::string label_of(const char* what, const ColourRange& range) {
    return range.clipped.empty() ? what : fmt::format("{} (beyond the colours: {})", what, range.clipped);
}

/// One frame to draw.
struct Shot {
    const Scene& scene;
    const RunRecord& record;
    FrameEntry entry;
};

std::vector<report::ColourBar> colour_bars(const ColourRange& water, const std::optional<ColourRange>& air) {
    std::vector<report::ColourBar> bars{
        {label_of("gauge pressure in the water", water), "Pa", 0, water.end, colours(water_colour)}};
    if (air) bars.push_back({label_of("speed of the air", *air), "m/s", 0, air->end, colours(air_colour)});
    return bars;
}

/// Pictures with the same colours.
std::vector<report::Picture> pictures_of(const std::vector<Shot>& shots) {
    std::vector<FieldFrame> frames;
    Shown shown;
    for (const Shot& shot : shots) {
        frames.push_back(read_frame(shot.entry.path));
        shown.add(frames.back());
    }
    const ColourRange water = range_of(std::move(shown.water_pressure), "Pa");
    std::optional<ColourRange> air;
    if (!shown.air_speed.empty()) air = range_of(std::move(shown.air_speed), "m/s");
    std::vector<report::Picture> pictures;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const auto& [scene, record, entry] = shots[k];
        RasterOptions options = raster_of(scene, record);
        options.water_max = water.end;
        if (air && with_air(record)) options.air_speed_max = air->end;
        report::Picture picture;
        picture.title =
            fmt::format("{}, {}, dx {:.4g} m", scene.analysis.title, record.variant, record.particle_spacing);
        picture.time = entry.time;
        if (const std::optional<double> scale = time_scale(scene.analysis))
            picture.scaled_time = entry.time / *scale;
        picture.png = render_png(frames[k], options);
        picture.colour_bars = colour_bars(water, options.air_speed_max ? air : std::nullopt);
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

/// The value of a series that was taken with the field file of that time.
std::optional<double> recorded_at(const RunRecord& record, const char* name, double time) {
    const auto found = record.series.find(name);
    if (found == record.series.end()) return std::nullopt;
    const Series& series = found->second;
    for (std::size_t k = 0; k < series.time.size(); ++k)
        if (std::abs(series.time[k] - time) <= 1e-6 * std::abs(time)) return series.value[k];
    return std::nullopt;
}

std::string defects_at(const RunRecord& record, double time) {
    std::string out;
    if (const auto area = recorded_at(record, "void_area", time))
        out += fmt::format("; void area {:.3g} m^2", *area);
    for (const auto& [name, meaning] : {std::pair("water_in_air", "water particles in air"),
                                        std::pair("air_in_water", "air particles in water"),
                                        std::pair("particles_in_bodies", "particles in the body")})
        if (const auto number = recorded_at(record, name, time))
            out += fmt::format("; {} {}", *number, meaning);
    return out;
}

}  // namespace

std::vector<report::Picture> field_pictures(const PictureSource& run) {
    const std::vector<FrameEntry> frames = list_frames(run.directory);
    std::vector<Shot> shots;
    for (const FrameEntry* frame : frames_found(run.scene, run.record, frames))
        shots.push_back({run.scene, run.record, *frame});
    return pictures_of(shots);
}

std::vector<report::Picture> field_pictures_at(const std::vector<PictureSource>& runs, double time) {
    std::vector<Shot> shots;
    for (const PictureSource& run : runs) {
        const std::vector<FrameEntry> frames = list_frames(run.directory);
        if (const FrameEntry* frame = frame_near(run.scene, frames, time))
            shots.push_back({run.scene, run.record, *frame});
    }
    std::vector<report::Picture> pictures = pictures_of(shots);
    for (std::size_t k = 0; k < shots.size(); ++k)
        pictures[k].title += defects_at(shots[k].record, shots[k].entry.time);
    return pictures;
}

}  // namespace wetdeck

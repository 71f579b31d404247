// SPDX-License-Identifier: BSD-3-Clause
#include "validation/commands/pictures.hpp"

#include <fmt/format.h>

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

/// The whole tank. The colours reach the pressure of the impact of a body, else the slam would have one
/// colour.
RasterOptions raster_of(const Scene& scene, const RunRecord& record) {
    const double head = std::abs(scene.model.gravity.y()) * scene.initial.surface;  // [m^2/s^2]
    double fastest = 0;
    for (const BodySpec& spec : scene.bodies) fastest = std::max(fastest, spec.body.velocity.norm());
    RasterOptions options;
    options.width = 600;
    options.x_min = scene.tank.low.x();
    options.x_max = scene.tank.high.x();
    options.y_min = scene.tank.low.y();
    options.y_max = scene.tank.high.y();
    options.particle_radius = 0.75 * record.particle_spacing;
    options.water_max = scene.model.water.eos.reference_density * (head + fastest * fastest);
    if (!(options.water_max > 0)) {  // without gravity and bodies: what one percent of compression gives
        const TaitEquationOfState& water = scene.model.water.eos;
        options.water_max = 0.01 * water.reference_density * water.sound_speed * water.sound_speed;
    }
    if (with_air(record))
        options.air_speed_max = std::max(4 * std::sqrt(head), 0.01 * scene.model.air.eos.sound_speed);
    return options;
}

std::vector<report::ColourBar> colour_bars(const RasterOptions& options) {
    std::vector<report::ColourBar> bars{
        {"gauge pressure in the water", "Pa", 0, options.water_max, colours(water_colour)}};
    if (options.air_speed_max)
        bars.push_back({"speed of the air", "m/s", 0, *options.air_speed_max, colours(air_colour)});
    return bars;
}

report::Picture picture_of(const Scene& scene, const RunRecord& record, const FrameEntry& frame) {
    const RasterOptions options = raster_of(scene, record);
    report::Picture picture;
    picture.title =
        fmt::format("{}, {}, dx {:.4g} m", scene.analysis.title, record.variant, record.particle_spacing);
    picture.time = frame.time;
    if (const std::optional<double> scale = time_scale(scene.analysis))
        picture.scaled_time = frame.time / *scale;
    picture.png = render_png(read_frame(frame.path), options);
    picture.colour_bars = colour_bars(options);
    return picture;
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

std::vector<report::Picture> field_pictures(const Scene& scene, const RunRecord& record,
                                            const std::filesystem::path& run_directory) {
    const std::vector<FrameEntry> frames = list_frames(run_directory);
    std::vector<report::Picture> pictures;
    for (const FrameEntry* frame : frames_found(scene, record, frames))
        pictures.push_back(picture_of(scene, record, *frame));
    return pictures;
}

std::optional<report::Picture> field_picture_at(const Scene& scene, const RunRecord& record,
                                                const std::filesystem::path& run_directory, double time) {
    const std::vector<FrameEntry> frames = list_frames(run_directory);
    const FrameEntry* frame = frame_near(scene, frames, time);
    if (!frame) return std::nullopt;
    report::Picture picture = picture_of(scene, record, *frame);
    picture.title += defects_at(record, frame->time);
    return picture;
}

}  // namespace wetdeck

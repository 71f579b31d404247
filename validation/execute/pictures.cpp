// SPDX-License-Identifier: BSD-3-Clause
#include "validation/execute/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

std::string rectangle(const Scene& scene, const Box& box, double scale, const char* fill) {
    return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>",
                       box.low.x() * scale, (scene.tank.high.y() - box.high.y()) * scale,
                       (box.high.x() - box.low.x()) * scale, (box.high.y() - box.low.y()) * scale, fill);
}

}  // namespace

std::string sketch_svg(const Scene& scene) {
    constexpr double width = 560, margin = 46;
    const Vec2 size = scene.tank.high - scene.tank.low;
    const double scale = width / size.x(), height = size.y() * scale;
    std::string body;
    if (scene.air) {
        for (const Box& box : scene.air_boxes) body += rectangle(scene, box, scale, "#eef3f8");
    }
    for (const Box& box : scene.water_boxes) {
        body += rectangle(scene, box, scale, "#5b9bd5");
        const Vec2 middle = 0.5 * (box.low + box.high);
        body += fmt::format(
            "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"white\">water {:.4g} m x {:.4g} "
            "m</text>",
            middle.x() * scale, (scene.tank.high.y() - middle.y()) * scale, box.high.x() - box.low.x(),
            box.high.y() - box.low.y());
    }
    for (const ProbeSpec& probe : scene.probes) {
        if (probe.type == ProbeSpec::Type::wall_pressure) {
            body += fmt::format(
                "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"#c0392b\" "
                "stroke-width=\"4\" "
                "opacity=\"0.6\"><title>{3}</title></line>",
                probe.centre.x() * scale,
                (scene.tank.high.y() - probe.centre.y() - 0.5 * probe.diameter) * scale,
                (scene.tank.high.y() - probe.centre.y() + 0.5 * probe.diameter) * scale, probe.name);
        } else if (probe.type == ProbeSpec::Type::water_depth) {
            body += fmt::format(
                "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"{1:.1f}\" stroke=\"#7f8c8d\" "
                "stroke-dasharray=\"3 4\">"
                "<title>{2}</title></line>",
                probe.x * scale, height, probe.name);
        }
    }
    body += fmt::format(
        "<rect x=\"0\" y=\"0\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#333\" "
        "stroke-width=\"2\"/>",
        width, height);
    body += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.4g} m</text>", 0.5 * width,
                        height + 20, size.x());
    body += fmt::format("<text x=\"-8\" y=\"{:.1f}\" text-anchor=\"end\">{:.4g} m</text>", 0.5 * height,
                        size.y());
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.1f} -8 {:.1f} {:.1f}\" "
        "font-family=\"sans-serif\" "
        "font-size=\"13\" role=\"img\" aria-label=\"set-up of the scene\">{}</svg>",
        -margin - 14, width + margin + 24, height + 36, body);
}

namespace {

/// Seconds per unit of T if all comparisons agree on one.
std::optional<double> time_scale(const AnalysisSpec& analysis) {
    if (analysis.comparisons.empty()) return std::nullopt;
    const double scale = analysis.comparisons.front().x_scale;
    const bool one = std::all_of(analysis.comparisons.begin(), analysis.comparisons.end(),
                                 [scale](const ComparisonSpec& c) { return c.x_scale == scale; });
    return one && scale != 1 && scale > 0 ? std::optional(scale) : std::nullopt;
}

}  // namespace

std::vector<report::Picture> field_pictures(const Scene& scene, const RunRecord& record,
                                            const std::filesystem::path& run_directory) {
    std::vector<report::Picture> pictures;
    const std::vector<FrameEntry> frames = list_frames(run_directory);
    const double head = std::abs(scene.model.gravity.y()) * scene.initial.surface;  // [m^2/s^2]
    RasterOptions options;
    options.width = 700;
    options.x_min = scene.tank.low.x();
    options.x_max = scene.tank.high.x();
    options.y_min = scene.tank.low.y();
    options.y_max = scene.tank.high.y();
    options.particle_radius = 0.75 * record.particle_spacing;
    options.water_max = scene.model.water.eos.reference_density * head;
    const bool air = record.choices.count("air") && record.choices.at("air") == "yes";
    if (air) options.air_speed_max = 4 * std::sqrt(head);
    const std::optional<double> scale = time_scale(scene.analysis);
    double last = -1;
    for (const double time : scene.picture_times) {
        const FrameEntry* nearest = nullptr;
        for (const FrameEntry& frame : frames) {
            if (!nearest || std::abs(frame.time - time) < std::abs(nearest->time - time)) nearest = &frame;
        }
        if (!nearest || nearest->time == last || std::abs(nearest->time - time) > 0.02 * scene.end_time)
            continue;
        last = nearest->time;
        report::Picture picture;
        picture.title =
            fmt::format("{}, {}, dx {} m", scene.analysis.title, record.variant, record.particle_spacing);
        picture.time = nearest->time;
        if (scale) picture.scaled_time = nearest->time / *scale;
        picture.png = render_png(read_frame(nearest->path), options);
        picture.colour_bars.push_back(
            {"gauge pressure in the water", "Pa", 0, options.water_max, colours(water_colour)});
        if (air)
            picture.colour_bars.push_back(
                {"speed of the air", "m/s", 0, *options.air_speed_max, colours(air_colour)});
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace wetdeck

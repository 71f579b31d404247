// SPDX-License-Identifier: BSD-3-Clause
// A figure as plain data, and its three renderings: SVG by gnuplot, JSON for plotly.js, CSV.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/core/curve.hpp"
#include "validation/metrics/specification.hpp"

namespace wetdeck::report {

struct Axis {
    std::string label;
    std::string unit;  ///< "-" for no dimension; empty if the label holds it
    bool logarithmic = false;
    std::optional<Window> range;  ///< found from the data if absent
};

enum class Marker { circle, square, triangle, diamond };

enum class Style { solid, dashed, points, line_and_points, band };

struct PlotSeries {
    std::string label;  ///< empty: not in the legend
    Style style = Style::solid;
    Curve data;               ///< for a band: x and the middle
    std::vector<double> low;  ///< error bars of points, edges of a band; same length as data, or empty
    std::vector<double> high;
    std::string colour = "#08519c";  ///< #rrggbb
    double width = 1.8;              ///< of a line [px]
    double point_size = 6;           ///< diameter [px]
    Marker marker = Marker::circle;
    bool filled = true;                     ///< the marker
    std::vector<std::string> point_labels;  ///< beside the points; same length as data, or empty
};

/// A solid line.
PlotSeries line(std::string label, Curve data, std::string colour);

struct Figure {
    std::string name;  ///< stem of its files: lower-case letters, digits, hyphens
    std::string title;
    std::string identifier;  ///< of what is drawn, for scripts: the tooltip of the title
    std::string
        caption;  ///< what the title and the section do not say; one that a section has already is left out
    Axis x;
    Axis y;
    std::vector<PlotSeries> series;
    std::string stamp;             ///< provenance of the numbers: a small line on the drawing
    std::optional<Window> shaded;  ///< interval of x where the metrics are taken
};

/// "label [unit]"; a label that already has brackets stays as it is.
std::string axis_title(const Axis& axis);

/// Pixels across the axes of the interactive and of the static drawing: finer detail is not drawn.
inline constexpr std::size_t interactive_columns = 800;
inline constexpr std::size_t static_columns = 300;

/// Indices of the samples that are drawn: the lowest and highest sample of each pixel column (of every ten
/// columns for markers), so that no peak is lost; of a line only its corners. Samples that are not finite, or
/// not positive on a logarithmic axis, are left out.
std::vector<std::size_t> drawn_samples(const Figure& figure, const PlotSeries& series,
                                       std::size_t columns = interactive_columns);

/// Every sample: one row each, the header with units.
std::string figure_csv(const Figure& figure);

/// Commands and data for gnuplot, which draws to `output`.
std::string gnuplot_script(const Figure& figure, const std::filesystem::path& output);

/// True if a program of that name is on the PATH.
bool gnuplot_found();

/// What came of a drawing.
struct Drawing {
    std::string svg;      ///< without title and stamp, for a page that has them already
    std::string failure;  ///< the file and the message of gnuplot; empty where it has drawn
};

/// Draws each figure to NAME.svg in a folder; a file appears whole or not at all and has title and stamp. One
/// process of gnuplot draws them all, and another what is left where it fails at one: it takes longer to
/// start than to draw.
std::vector<Drawing> write_svgs(std::span<const Figure> figures, const std::filesystem::path& folder);

/// The same drawing in fewer bytes: without empty groups, coordinates to a tenth of a pixel, texts untouched.
std::string smaller_svg(const std::string& svg);

/// {"data": [...], "layout": {...}} for Plotly.newPlot.
nlohmann::json plotly_figure(const Figure& figure);

/// Axis range with a margin around all finite data, on a logarithmic axis around the positive data; [0, 1]
/// without data.
Window data_range(const Figure& figure, bool of_x);

}  // namespace wetdeck::report

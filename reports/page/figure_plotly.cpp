// SPDX-License-Identifier: BSD-3-Clause
// A figure as data and layout for plotly.js.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/page/figure.hpp"
#include "reports/page/html.hpp"

namespace wetdeck::report {
namespace {

using Json = nlohmann::json;

/// Five significant digits keep the page small and are more than a screen shows.
double rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return 0;
    const double scale = std::pow(10.0, 4 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

Json picked(const std::vector<double>& values, const std::vector<std::size_t>& indices) {
    Json out = Json::array();
    for (const std::size_t i : indices) out.push_back(rounded(values[i]));
    return out;
}

/// 1, 2, 5 of each decade in full: plotly itself writes the 2 of 0.2 without its decade.
void set_ticks(Json& axis, const Window& range) {
    axis["tickvals"] = axis["ticktext"] = Json::array();
    for (int decade = static_cast<int>(std::floor(std::log10(range.begin)));
         decade <= static_cast<int>(std::ceil(std::log10(range.end))); ++decade) {
        for (const int digit : {1, 2, 5}) {
            const double value = rounded(digit * std::pow(10.0, decade));
            if (value < range.begin || value > range.end) continue;
            axis["tickvals"].push_back(value);
            axis["ticktext"].push_back(number(value));
        }
    }
}

Json axis_layout(const Axis& axis, const Window& range) {
    Json out = {{"title", {{"text", escape(axis_title(axis))}, {"standoff", 8}}},
                {"gridcolor", "#e3e6ea"},
                {"linecolor", "#444444"},
                {"showline", true},
                {"zeroline", false},
                {"ticks", "outside"},
                {"automargin", true}};
    if (axis.logarithmic) {
        out["type"] = "log";
        out["exponentformat"] = "power";
        if (range.end / range.begin < 300) {
            set_ticks(out, range);
        } else {
            out["dtick"] = 1;
        }
        out["range"] = {rounded(std::log10(range.begin)), rounded(std::log10(range.end))};
    } else {
        out["range"] = {rounded(range.begin), rounded(range.end)};
    }
    return out;
}

/// Both edges as one closed outline.
Json band_trace(const PlotSeries& s, const std::vector<std::size_t>& indices) {
    Json x = picked(s.data.x, indices);
    Json y = picked(s.high, indices);
    for (auto i = indices.rbegin(); i != indices.rend(); ++i) {
        x.push_back(rounded(s.data.x[*i]));
        y.push_back(rounded(s.low[*i]));
    }
    return {{"x", x},
            {"y", y},
            {"mode", "lines"},
            {"line", {{"width", 0}}},
            {"fill", "toself"},
            {"fillcolor", s.colour + "2e"},
            {"hoverinfo", "skip"}};
}

Json error_bars(const PlotSeries& s, const std::vector<std::size_t>& indices) {
    Json above = Json::array();
    Json below = Json::array();
    for (const std::size_t i : indices) {
        above.push_back(rounded(s.high[i] - s.data.y[i]));
        below.push_back(rounded(s.data.y[i] - s.low[i]));
    }
    return {{"type", "data"},    {"array", above},   {"arrayminus", below},
            {"color", s.colour}, {"thickness", 0.8}, {"width", 3}};
}

std::string symbol(const PlotSeries& s) {
    static constexpr std::array<const char*, 4> filled{"circle", "square", "triangle-up", "diamond"};
    return std::string(filled.at(static_cast<std::size_t>(s.marker))) + (s.filled ? "" : "-open");
}

Json curve_trace(const PlotSeries& s, const std::vector<std::size_t>& indices) {
    const bool markers = s.style == Style::points || s.style == Style::line_and_points;
    const bool lines = s.style != Style::points;
    std::string mode = lines ? "lines" : "";
    if (markers) mode += mode.empty() ? "markers" : "+markers";
    Json out = {{"x", picked(s.data.x, indices)}, {"y", picked(s.data.y, indices)}};
    if (lines) {
        out["line"] = {{"color", s.colour}, {"width", s.width}};
        if (s.style == Style::dashed) out["line"]["dash"] = "dash";
    }
    if (markers) {
        out["marker"] = {{"color", s.colour}, {"size", s.point_size}, {"symbol", symbol(s)}};
    }
    if (!s.point_labels.empty()) {
        mode += "+text";
        for (const std::size_t i : indices) out["text"].push_back(escape(s.point_labels[i]));
        out["textposition"] = "top right";
        out["textfont"] = {{"size", 11}, {"color", s.colour}};
        out["cliponaxis"] = false;
    }
    if (!s.low.empty()) out["error_y"] = error_bars(s, indices);
    out["mode"] = mode;
    return out;
}

}  // namespace

nlohmann::json plotly_figure(const Figure& figure) {
    Json data = Json::array();
    for (const PlotSeries& s : figure.series) {
        const std::vector<std::size_t> indices = drawn_samples(figure, s);
        if (indices.empty()) continue;
        Json trace = s.style == Style::band ? band_trace(s, indices) : curve_trace(s, indices);
        trace["type"] = "scatter";
        trace["name"] = escape(s.label);
        trace["showlegend"] = !s.label.empty();
        data.push_back(std::move(trace));
    }
    Json layout = {{"xaxis", axis_layout(figure.x, data_range(figure, true))},
                   {"yaxis", axis_layout(figure.y, data_range(figure, false))}};
    if (figure.shaded) {
        layout["shapes"] = Json::array({{{"type", "rect"},
                                         {"xref", "x"},
                                         {"yref", "y domain"},
                                         {"x0", rounded(figure.shaded->begin)},
                                         {"x1", rounded(figure.shaded->end)},
                                         {"y0", 0},
                                         {"y1", 1},
                                         {"fillcolor", "#f3f1e6"},
                                         {"line", {{"width", 0}}},
                                         {"layer", "below"}}});
    }
    return {{"data", std::move(data)}, {"layout", std::move(layout)}};
}

}  // namespace wetdeck::report

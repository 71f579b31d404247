// SPDX-License-Identifier: BSD-3-Clause
// One description of a figure, three renderings.
#include "reports/page/figure.hpp"
#include "reports/figures/figures.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/core/errors.hpp"
#include "tests/unit/report/report_samples.hpp"

using namespace wetdeck;
using namespace wetdeck::report;

namespace {

Figure sample() {
    Figure figure;
    figure.name = "sample";
    figure.title = "Sample";
    figure.x = {"time", "s", false, {}};
    figure.y = {"pressure", "Pa", false, {}};
    PlotSeries line;
    line.label = "dx = 0.01 m";
    line.data = {{0, 1, 2}, {10, 20.5, 1e-7}};
    PlotSeries points;
    points.label = "gauge, \"raw\"";
    points.style = Style::points;
    points.data = {{0.5}, {12}};
    points.low = {11};
    points.high = {13};
    figure.series = {line, points};
    return figure;
}

PlotSeries ramp(std::size_t n) {
    PlotSeries s;
    for (std::size_t i = 0; i < n; ++i) {
        s.data.x.push_back(static_cast<double>(i));
        s.data.y.push_back(0);
    }
    return s;
}

}  // namespace

TEST_CASE("The CSV of a figure holds every sample, with units in its header", "[report]") {
    CHECK(figure_csv(sample()) ==
          "series,time [s],pressure [Pa],low: pressure [Pa],high: pressure [Pa]\n"
          "dx = 0.01 m,0,10,,\n"
          "dx = 0.01 m,1,20.5,,\n"
          "dx = 0.01 m,2,1e-07,,\n"
          "gauge; 'raw',0.5,12,11,13\n");
}

TEST_CASE("A label with brackets of its own keeps them", "[report]") {
    CHECK(axis_title({"T [-]", "s", false, {}}) == "T [-]");
    CHECK(axis_title({"T", "s", false, {}}) == "T [s]");
}

TEST_CASE("Thinning for the drawing keeps a peak of one sample and the ends", "[report]") {
    Figure figure;
    PlotSeries s = ramp(50000);
    s.data.y[31337] = 1;
    s.data.y[4242] = -1;
    const std::vector<std::size_t> kept = drawn_samples(figure, s);
    CHECK(kept.size() < 2000);
    CHECK(std::is_sorted(kept.begin(), kept.end()));
    CHECK(std::count(kept.begin(), kept.end(), 31337u) == 1);
    CHECK(std::count(kept.begin(), kept.end(), 4242u) == 1);
    CHECK(kept.front() == 0);
    CHECK(kept.back() >= 49900);
}

TEST_CASE("Of a straight line only the ends are drawn, of a corner the corner", "[report]") {
    Figure figure;
    PlotSeries s = ramp(1000);
    for (std::size_t i = 500; i < 1000; ++i) s.data.y[i] = static_cast<double>(i - 500);
    figure.series = {s};
    const std::vector<std::size_t> kept = drawn_samples(figure, s);
    CHECK(kept.size() <= 5);
    CHECK(kept.front() == 0);
    CHECK(kept.back() == 999);
    CHECK(std::any_of(kept.begin(), kept.end(), [](std::size_t i) { return i >= 498 && i <= 503; }));
}

TEST_CASE("A drawn line is never more than a pixel from its samples", "[report]") {
    Figure figure;
    PlotSeries s = ramp(700);
    for (std::size_t i = 0; i < 700; ++i) s.data.y[i] = std::sin(0.02 * static_cast<double>(i));
    figure.series = {s};
    const std::vector<std::size_t> kept = drawn_samples(figure, s);
    CHECK(kept.size() < 150);
    double largest = 0;
    for (std::size_t k = 1; k < kept.size(); ++k) {
        const std::size_t a = kept[k - 1], b = kept[k];
        for (std::size_t i = a; i <= b; ++i) {
            const double share = static_cast<double>(i - a) / static_cast<double>(b - a);
            const double drawn = s.data.y[a] + share * (s.data.y[b] - s.data.y[a]);
            largest = std::max(largest, std::abs(drawn - s.data.y[i]));
        }
    }
    const Window y = data_range(figure, false);
    CHECK(largest < (y.end - y.begin) / 400);  // of 400 pixels
}

TEST_CASE("Markers are not thinned to corners: every measured point is seen", "[report]") {
    Figure figure;
    PlotSeries s = ramp(100);
    s.style = Style::points;
    figure.series = {s};
    CHECK(drawn_samples(figure, s).size() == 100);
}

TEST_CASE("A drawing loses empty groups and needless decimals, not its words", "[report]") {
    CHECK(smaller_svg(
              "<svg>\n<g fill=\"none\">\n</g>\n<g fill=\"none\">\n\t<path d='M1.25,3.00 L10.123,4.56'/>\n"
              "<text>0.25</text>\n</g>\n</svg>\n") ==
          "<svg>\n<g fill=\"none\">\n<path d='M1.2,3 L10.123,4.5'/>\n<text>0.25</text>\n</g>\n</svg>\n");
}

TEST_CASE("Samples that an axis cannot show are not drawn", "[report]") {
    Figure figure;
    figure.y.logarithmic = true;
    PlotSeries s = ramp(4);
    s.data.y = {0, 1, -1, std::numeric_limits<double>::infinity()};
    CHECK(drawn_samples(figure, s) == std::vector<std::size_t>{1});
}

TEST_CASE("Both drawings use the same range on a logarithmic axis", "[report]") {
    Figure figure = sample();
    figure.y.logarithmic = true;
    figure.y.range = Window{1e-3, 100};
    const auto plot = plotly_figure(figure);
    CHECK(plot["layout"]["yaxis"]["type"] == "log");
    CHECK(plot["layout"]["yaxis"]["range"] == nlohmann::json({-3.0, 2.0}));
    const std::string script = gnuplot_script(figure, "out.svg");
    CHECK(samples::contains(script, "set yrange [0.001:100]"));
    CHECK(samples::contains(script, "set logscale y"));
}

TEST_CASE("A short logarithmic axis names its ticks in full", "[report]") {
    Figure figure = sample();
    figure.y.logarithmic = true;
    figure.y.range = Window{0.1, 3};
    const auto axis = plotly_figure(figure)["layout"]["yaxis"];
    CHECK(axis["tickvals"] == nlohmann::json({0.1, 0.2, 0.5, 1.0, 2.0}));
    CHECK(axis["ticktext"] == nlohmann::json({"0.1", "0.2", "0.5", "1", "2"}));
}

TEST_CASE("The interactive figure escapes texts and shows error bars", "[report]") {
    Figure figure = sample();
    figure.series[0].label = "<a href='x'>";
    const auto plot = plotly_figure(figure);
    CHECK(plot["data"][0]["name"] == "&lt;a href=&#39;x&#39;&gt;");
    CHECK(plot["data"][0]["mode"] == "lines");
    CHECK(plot["data"][1]["mode"] == "markers");
    CHECK(plot["data"][1]["error_y"]["array"] == nlohmann::json({1.0}));
}

TEST_CASE("A text cannot become a command of gnuplot", "[report]") {
    Figure figure = sample();
    figure.x.label = "it's\nsystem('touch /tmp/x')\n";
    figure.x.unit = "";
    const std::string script = gnuplot_script(figure, "it's.svg");
    CHECK(samples::contains(script, "set xlabel 'it''s system(''touch /tmp/x'') ' noenhanced\n"));
    CHECK(samples::contains(script, "set output 'it''s.svg'\n"));
    CHECK_FALSE(samples::contains(script, "\nsystem("));
}

TEST_CASE("gnuplot draws every style, also into a folder with quotes and spaces in its name", "[report]") {
    if (!gnuplot_found()) {
        WARN("gnuplot was not found: nothing drawn");
        return;
    }
    const samples::ScratchFolder scratch;
    const std::filesystem::path folder = scratch / "it's a folder";
    std::filesystem::create_directory(folder);
    Figure figure = sample();
    figure.title = "Title & <tag>";
    figure.shaded = Window{0.2, 0.8};
    figure.x.logarithmic = true;
    for (const Style style : {Style::dashed, Style::line_and_points, Style::band}) {
        PlotSeries s = ramp(5);
        s.style = style;
        s.low = std::vector<double>(5, 1);
        s.high = std::vector<double>(5, 2);
        s.point_labels = std::vector<std::string>(5, "p'q");
        figure.series.push_back(s);
    }
    figure.stamp = "revision <1>";
    figure.name = "a";
    const std::string drawn = write_svgs({&figure, 1}, folder).at(0).svg;
    const std::string file = samples::bytes_of(folder / "a.svg");
    for (const std::string& svg : {drawn, file}) CHECK(samples::contains(svg, "</svg>"));
    // the page has title and stamp of its own
    for (const char* words : {"Title &amp; &lt;tag&gt;", "revision &lt;1&gt;"}) {
        CHECK_FALSE(samples::contains(drawn, words));
        CHECK(samples::contains(file, words));
    }
    CHECK(samples::contains(drawn, "viewBox=\"0 0 620 "));
    CHECK(samples::contains(file, "viewBox=\"0 -26 620 "));
    CHECK(samples::names_in(folder) == std::vector<std::string>{"a.svg"});
}

TEST_CASE("A figure without data is drawn as empty axes", "[report]") {
    if (!gnuplot_found()) {
        WARN("gnuplot was not found: nothing drawn");
        return;
    }
    const samples::ScratchFolder scratch;
    Figure figure;
    figure.name = "empty";
    figure.y.logarithmic = GENERATE(false, true);
    CHECK(samples::contains(write_svgs({&figure, 1}, scratch).at(0).svg, "</svg>"));
}

TEST_CASE("A failure of gnuplot is reported in its own words, and the other figures are drawn", "[report]") {
    if (!gnuplot_found()) {
        WARN("gnuplot was not found: nothing drawn");
        return;
    }
    const samples::ScratchFolder scratch;
    std::vector<Figure> figures(4, sample());
    for (std::size_t k = 0; k < figures.size(); ++k)
        figures[k].name = std::string(1, static_cast<char>('a' + k));
    figures[1].series[0].colour = "no such colour";
    const std::vector<Drawing> drawings = write_svgs(figures, scratch);
    REQUIRE(drawings.size() == 4);
    for (const std::size_t k : {0U, 2U, 3U}) {
        CHECK(drawings[k].failure.empty());
        CHECK(samples::contains(drawings[k].svg, "</svg>"));
    }
    CHECK(samples::contains(drawings[1].failure, "b.svg: gnuplot failed"));
    CHECK(drawings[1].svg.empty());
    std::vector<std::string> names = samples::names_in(scratch);
    std::sort(names.begin(), names.end());
    CHECK(names == std::vector<std::string>{"a.svg", "c.svg", "d.svg"});
}

TEST_CASE("A figure is drawn as if it were alone", "[report]") {
    if (!gnuplot_found()) {
        WARN("gnuplot was not found: nothing drawn");
        return;
    }
    const samples::ScratchFolder alone, together;
    Figure first = sample(), second = sample();
    first.name = "first";
    first.shaded = Window{0.2, 0.8};
    first.x.logarithmic = first.y.logarithmic = true;
    first.series[0].point_labels = std::vector<std::string>(first.series[0].data.x.size(), "label");
    second.name = "second";
    const std::vector<Figure> both = {first, second};
    CHECK(write_svgs(both, together).at(1).svg == write_svgs({&second, 1}, alone).at(0).svg);
}

TEST_CASE("Predicted over measured values are drawn by their magnitudes, and not where one is zero",
          "[report]") {
    Summary summary;
    ScatterPoint falling, turning;
    falling.quantity_class = turning.quantity_class = "velocity";
    falling.counted = true;
    falling.kind = ReferenceKind::experiment;
    falling.expected = -5;
    falling.predicted = -4.5;
    turning.kind = ReferenceKind::stated;
    turning.expected = 0;
    turning.predicted = 0.1;
    summary.scatter = {falling, turning};
    const std::vector<Figure> figures = scatter_figures(summary);
    REQUIRE(figures.size() == 1);
    CHECK(figures[0].x.range->begin == Approx(3));
    CHECK(figures[0].x.range->end == Approx(7.5));
    CHECK(figures[0].series.back().data.x == std::vector<double>{5});
    CHECK(figures[0].series.back().data.y == std::vector<double>{4.5});
}

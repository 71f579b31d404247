// SPDX-License-Identifier: BSD-3-Clause
// What all renderings of a figure share.
#include "reports/page/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/page/strings.hpp"

namespace wetdeck::report {
namespace {

class Range {
  public:
    explicit Range(bool logarithmic) : logarithmic_(logarithmic) {}
    void take(const std::vector<double>& values) {
        for (const double value : values) {
            if (!std::isfinite(value) || (logarithmic_ && value <= 0)) continue;
            low_ = std::min(low_, value);
            high_ = std::max(high_, value);
        }
    }
    /// Margins are fractions of the range, of the decades on a logarithmic axis.
    Window with_margins(double below, double above) const {
        if (low_ > high_) return logarithmic_ ? Window{0.1, 1} : Window{0, 1};
        if (logarithmic_) {
            const double ratio = std::max(high_ / low_, 10.0);
            return {low_ / std::pow(ratio, below), high_ * std::pow(ratio, above)};
        }
        const double level = std::max(std::abs(low_), std::abs(high_));
        const double span = high_ > low_ ? high_ - low_ : (level > 0 ? 0.2 * level : 1.0);
        return {low_ - below * span, high_ + above * span};
    }

  private:
    bool logarithmic_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

PlotSeries line(std::string label, Curve data, std::string colour) {
    PlotSeries series;
    series.label = std::move(label);
    series.data = std::move(data);
    series.colour = std::move(colour);
    return series;
}

std::string axis_title(const Axis& axis) {
    if (axis.unit.empty() || axis.label.find('[') != std::string::npos) return axis.label;
    return axis.label + " [" + axis.unit + "]";
}

std::string figure_csv(const Figure& figure) {
    const bool edges = std::any_of(figure.series.begin(), figure.series.end(),
                                   [](const PlotSeries& s) { return !s.low.empty(); });
    const bool labels = std::any_of(figure.series.begin(), figure.series.end(),
                                    [](const PlotSeries& s) { return !s.point_labels.empty(); });
    const std::string y_title = axis_title(figure.y);
    std::string out = fmt::format("series,{},{}", csv_field(axis_title(figure.x)), csv_field(y_title));
    if (edges) out += fmt::format(",{},{}", csv_field("low: " + y_title), csv_field("high: " + y_title));
    if (labels) out += ",point";
    out += "\n";
    for (const PlotSeries& s : figure.series) {
        const std::string name = csv_field(s.label);
        for (std::size_t i = 0; i < s.data.x.size(); ++i) {
            out += fmt::format("{},{:.9g},{:.9g}", name, s.data.x[i], s.data.y[i]);
            if (edges) out += s.low.empty() ? ",," : fmt::format(",{:.9g},{:.9g}", s.low[i], s.high[i]);
            if (labels)
                out += s.point_labels.empty() ? "," : fmt::format(",{}", csv_field(s.point_labels[i]));
            out += "\n";
        }
    }
    return out;
}

Window data_range(const Figure& figure, bool of_x) {
    const Axis& axis = of_x ? figure.x : figure.y;
    if (axis.range) return *axis.range;
    Range range(axis.logarithmic);
    for (const PlotSeries& s : figure.series) {
        range.take(of_x ? s.data.x : s.data.y);
        if (!of_x) {
            range.take(s.low);
            range.take(s.high);
        }
    }
    const bool labels = std::any_of(figure.series.begin(), figure.series.end(),
                                    [](const PlotSeries& s) { return !s.point_labels.empty(); });
    if (labels) return range.with_margins(0.08, of_x ? 0.22 : 0.12);  // room for them, up and to the right
    const double margin = of_x ? 0.02 : 0.06;
    return range.with_margins(margin, margin);
}

}  // namespace wetdeck::report

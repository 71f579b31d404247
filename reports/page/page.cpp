// SPDX-License-Identifier: BSD-3-Clause
// Sections, figures and the frame of the page.
#include "reports/page/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/page/html.hpp"
#include "reports/page/page_assets.hpp"
#include "solver/core/errors.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::report {
namespace {

/// Nothing may be loaded from outside; pictures are part of the page.
constexpr std::string_view content_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

/// Adds -2, -3, ... to a name that is taken.
std::string unique(std::map<std::string, std::string>& names, const std::string& wanted,
                   std::string_view title) {
    std::string name = wanted;
    for (int i = 2; !names.emplace(name, title).second; ++i) name = fmt::format("{}-{}", wanted, i);
    return name;
}

}  // namespace

Page::Page(std::filesystem::path directory, std::string plotly, std::string stamp)
    : figures_(std::move(directory) / "figures"),
      plotly_(std::move(plotly)),
      stamp_(std::move(stamp)),
      gnuplot_(gnuplot_found()) {
    make_directories(figures_);
}

void Page::section(int level, std::string_view title, std::string_view scope) {
    const std::string scoped = scope.empty() ? std::string(title) : fmt::format("{} {}", scope, title);
    const std::string id = unique(names_, "section-" + slug(scoped), scoped);
    body_ += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", level, id, escape(title));
    contents_ += fmt::format("<a class=\"level{}\" href=\"#{}\">{}</a>\n", level, id, escape(title));
}

void Page::anchor(std::string_view name, std::string_view title) {
    body_ += fmt::format("<a id=\"{}\"></a>\n", unique(names_, slug(name), title));
}

std::vector<std::string> Page::anchors_like(const std::string& name) const {
    std::vector<std::string> out;
    for (auto each = names_.lower_bound(name); each != names_.end(); ++each) {
        if (each->first.rfind(name, 0) != 0) break;
        if (each->first.size() == name.size() || each->first[name.size()] == '-') out.push_back(each->first);
    }
    return out;
}

std::string Page::static_drawing(const Figure& figure) {
    if (!gnuplot_) return draws_interactive() ? "" : paragraph("Not drawn: gnuplot was not found.", "notice");
    const std::filesystem::path path = figures_ / (figure.name + ".svg");
    try {
        const std::string svg = write_svg(figure, path);
        files_.insert(path.filename().string());
        return fmt::format("<img class=\"static\" alt=\"{}\" src=\"{}\">\n", escape(figure.title),
                           svg_address(svg));
    } catch (const EnvironmentError& error) {
        return paragraph(std::string("Not drawn: ") + error.what(), "notice");
    }
}

std::string Page::figure(Figure figure) {
    figure.name = unique(names_, slug(figure.name), figure.title);
    figure.stamp = stamp_;
    const std::string csv = figure.name + ".csv";
    atomic_write(figures_ / csv, figure_csv(figure));
    files_.insert(csv);

    std::string html = fmt::format("<figure class=\"drawing\" id=\"{}\"><figcaption>{}</figcaption>\n",
                                   figure.name, escape(figure.title));
    if (draws_interactive()) {
        const auto replace = nlohmann::json::error_handler_t::replace;  // of bytes that are not UTF-8
        html += fmt::format(
            "<div class=\"plot\"></div><script type=\"application/json\" class=\"plot-data\">{}</script>\n",
            escape_json(plotly_figure(figure).dump(-1, ' ', false, replace)));
    }
    html += static_drawing(figure);
    html += "<p class=\"caption\">" + escape(figure.caption) + " Files: ";
    if (files_.count(figure.name + ".svg") != 0)
        html += fmt::format("<a href=\"figures/{0}.svg\">{0}.svg</a>, ", figure.name);
    html += fmt::format("<a href=\"figures/{0}\">{0}</a>", csv);
    if (!stamp_.empty()) html += fmt::format(". <span class=\"stamp\">{}</span>", escape(stamp_));
    return html + "</p></figure>\n";
}

void Page::add_figures(const std::vector<Figure>& figures) {
    if (figures.empty()) return;
    body_ += "<div class=\"figures\">\n";
    for (const Figure& each : figures) body_ += figure(each);
    body_ += "</div>\n";
}

std::string Page::html(std::string_view title, const std::string& header) const {
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    out += fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n", content_policy);
    out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    out += "<title>" + escape(title) + "</title>\n<style>\n" + std::string(page_style) +
           "</style>\n</head>\n<body>\n";
    out += "<nav aria-label=\"Contents\">\n" + contents_ + "</nav>\n<main>\n";
    out += "<header><h1>" + escape(title) + "</h1>\n" + header + "</header>\n" + body_ + "</main>\n";
    if (draws_interactive()) out += "<script>\n" + escape_script(plotly_) + "\n</script>\n";
    out += "<script>\n" + std::string(page_script) + "</script>\n";
    return out + "</body>\n</html>\n";
}

void Page::remove_stale_figures() const {
    for (const auto& entry : std::filesystem::directory_iterator(figures_)) {
        const std::string extension = entry.path().extension().string();
        const bool ours = extension == ".svg" || extension == ".csv";
        if (ours && files_.count(entry.path().filename().string()) == 0)
            std::filesystem::remove(entry.path());
    }
}

}  // namespace wetdeck::report

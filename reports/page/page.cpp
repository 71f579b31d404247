// SPDX-License-Identifier: BSD-3-Clause
// Sections and figures of a page.
#include "reports/page/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/page/html.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::report {

Page::Page(Pages& pages, std::string name, std::string title, std::string label)
    : pages_(pages), name_(std::move(name)), title_(std::move(title)), label_(std::move(label)) {}

void Page::section(int level, std::string_view title, std::string_view scope) {
    const std::string scoped = scope.empty() ? std::string(title) : fmt::format("{} {}", scope, title);
    const std::string id = pages_.take("section-" + slug(scoped), scoped, *this);
    body_ += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", level, id, escape(title));
    contents_ += fmt::format("<a class=\"level{}\" href=\"#{}\">{}</a>\n", level, id, escape(title));
    ++sections_;
    captions_.clear();
}

void Page::anchor(std::string_view name, std::string_view title) {
    body_ += fmt::format("<a id=\"{}\"></a>\n", pages_.take(slug(name), title, *this));
}

/// None in a single file, which is read where there is no other.
std::string Page::file_links(const std::string& name) const {
    if (pages_.single_file_) return "";
    std::string out = " Files: ";
    if (pages_.files_.contains(name + ".svg"))
        out += fmt::format("<a href=\"figures/{0}.svg\">{0}.svg</a>, ", name);
    return out + fmt::format("<a href=\"figures/{0}.csv\">{0}.csv</a>", name);
}

std::string Page::figure(const Figure& figure) {
    return figures({&figure, 1}).front();
}

std::vector<std::string> Page::figures(std::span<const Figure> wanted) {
    std::vector<Figure> named(wanted.begin(), wanted.end());
    for (Figure& each : named) {
        each.name = pages_.take(slug(each.name), each.title, *this);
        each.stamp = pages_.stamp_;
        const std::string csv = each.name + ".csv";
        atomic_write(pages_.figures_ / csv, figure_csv(each));
        pages_.files_.insert(csv);
    }
    std::vector<std::string> markup = pages_.static_drawings(named);
    for (std::size_t k = 0; k < named.size(); ++k) markup[k] = framed(named[k], markup[k]);
    return markup;
}

std::string Page::framed(const Figure& figure, const std::string& drawing) {
    std::string html = fmt::format("<figure class=\"drawing\" id=\"{}\"><figcaption>{}</figcaption>\n",
                                   figure.name, named_words(figure.title, figure.identifier));
    if (pages_.draws_interactive()) {
        interactive_ = true;
        const auto replace = nlohmann::json::error_handler_t::replace;  // of bytes that are not UTF-8
        html += fmt::format(
            "<div class=\"plot\"></div><script type=\"application/json\" class=\"plot-data\">{}</script>\n",
            escape_json(plotly_figure(figure).dump(-1, ' ', false, replace)));
    }
    html += drawing;
    const bool told = !captions_.insert(figure.caption).second;
    return html + "<p class=\"caption\">" + (told ? "" : escape(figure.caption)) + file_links(figure.name) +
           "</p></figure>\n";
}

void Page::add_figures(const std::vector<Figure>& figures) {
    if (figures.empty()) return;
    body_ += "<div class=\"figures\">\n";
    for (const std::string& each : this->figures(figures)) body_ += each;
    body_ += "</div>\n";
}

std::string Page::markup() const {
    const bool listed = sections_ > 3 && this != &pages_.pages_.front();
    std::string out = fmt::format("<div class=\"page{}\" id=\"page-{}\">\n", listed ? " listed" : "", name_);
    if (listed) out += "<nav class=\"contents\" aria-label=\"Contents\">\n" + contents_ + "</nav>\n";
    return out + "<article>\n<h1>" + escape(title_) + "</h1>\n" + body_ + "</article>\n</div>\n";
}

}  // namespace wetdeck::report

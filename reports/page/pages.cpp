// SPDX-License-Identifier: BSD-3-Clause
// What the pages of a report share: names, files, frame.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "reports/page/html.hpp"
#include "reports/page/page.hpp"
#include "reports/page/page_assets.hpp"
#include "validation/store/atomic_write.hpp"

namespace wetdeck::report {
namespace {

/// Nothing may be loaded from outside; pictures are part of the page.
constexpr std::string_view content_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

/// In the head of every page: by it a later report tells its own pages from files of the user.
constexpr std::string_view page_mark = "<meta name=\"generator\" content=\"wetdeck report\">";

bool is_page(const std::filesystem::path& path) {
    if (path.extension() != ".html") return false;
    std::ifstream in(path, std::ios::binary);
    std::string head(1000, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    return head.find(page_mark) != std::string::npos;
}

}  // namespace

Pages::Pages(std::filesystem::path directory, std::string plotly, std::string stamp, bool single_file)
    : directory_(std::move(directory)),
      figures_(directory_ / "figures"),
      plotly_(std::move(plotly)),
      stamp_(std::move(stamp)),
      single_file_(single_file),
      gnuplot_(gnuplot_found()) {
    make_directories(figures_);
}

Page& Pages::add(const std::string& name, const std::string& title, const std::string& label) {
    std::string free = name;
    const auto taken = [&](const Page& page) { return page.name() == free; };
    for (int i = 2; std::any_of(pages_.begin(), pages_.end(), taken); ++i)
        free = fmt::format("{}-{}", name, i);
    return pages_.emplace_back(*this, free, title, label);
}

std::string Pages::take(const std::string& wanted, std::string_view title, const Page& page) {
    std::string name = wanted;
    const Place place{page.name(), std::string(title)};
    for (int i = 2; !names_.emplace(name, place).second; ++i) name = fmt::format("{}-{}", wanted, i);
    return name;
}

std::string Pages::address_of(const std::string& anchor) const {
    return (single_file_ ? "" : names_.at(anchor).page + ".html") + "#" + anchor;
}

std::string Pages::address_of_page(const std::string& page) const {
    return single_file_ ? "#page-" + page : page + ".html";
}

std::vector<std::string> Pages::anchors_like(const std::string& name) const {
    std::vector<std::string> out;
    for (auto each = names_.lower_bound(name); each != names_.end(); ++each) {
        if (each->first.rfind(name, 0) != 0) break;
        if (each->first.size() == name.size() || each->first[name.size()] == '-') out.push_back(each->first);
    }
    return out;
}

std::vector<std::string> Pages::static_drawings(std::span<const Figure> figures) {
    if (!gnuplot_)
        return {figures.size(),
                draws_interactive() ? "" : paragraph("Not drawn: gnuplot was not found.", "notice")};
    std::vector<std::string> markup;
    const std::vector<Drawing> drawings = write_svgs(figures, figures_);
    for (std::size_t k = 0; k < figures.size(); ++k) {
        if (!drawings[k].failure.empty()) {
            markup.push_back(paragraph("Not drawn: " + drawings[k].failure, "notice"));
            continue;
        }
        files_.insert(figures[k].name + ".svg");
        markup.push_back(fmt::format("<img class=\"static\" alt=\"{}\" src=\"{}\">\n",
                                     escape(figures[k].title), svg_address(drawings[k].svg)));
    }
    return markup;
}

std::vector<std::pair<std::string, std::string>> Pages::listed() const {
    std::vector<std::pair<std::string, std::string>> out;
    for (const Page& page : pages_)
        if (&page != &pages_.front()) out.emplace_back(address_of_page(page.name()), page.title());
    return out;
}

std::string Pages::links(const Page* current) const {
    if (pages_.size() < 2) return "";
    std::string out = "<nav class=\"pages\" aria-label=\"Pages of the report\">\n";
    for (const Page& page : pages_) {
        out += fmt::format("<a href=\"{}\"{}>{}</a>\n", address_of_page(page.name()),
                           &page == current ? " aria-current=\"page\"" : "", escape(page.label()));
    }
    return out + "</nav>\n";
}

std::string Pages::framed(const std::string& title, const std::string& links, const std::string& content,
                          bool interactive) const {
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    out += fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n", content_policy);
    out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    out += std::string(page_mark) + "\n<title>" + escape(title) + "</title>\n<style>\n" +
           std::string(page_style) + "</style>\n</head>\n<body>\n" + links + "<main>\n" + content +
           "</main>\n";
    if (!stamp_.empty()) out += "<footer>" + escape(stamp_) + "</footer>\n";
    if (interactive) out += "<script>\n" + escape_script(plotly_) + "\n</script>\n";
    return out + "<script>\n" + std::string(page_script) + "</script>\n</body>\n</html>\n";
}

void Pages::write() const {
    remove_stale_files();
    const std::string& subject = pages_.front().title();
    std::string all;
    bool interactive = false;
    for (const Page& page : pages_) {
        if (single_file_) {
            all += page.markup();
            interactive = interactive || page.interactive();
            continue;
        }
        const std::string title = &page == &pages_.front() ? subject : page.title() + " · " + subject;
        atomic_write(directory_ / (page.name() + ".html"),
                     framed(title, links(&page), page.markup(), page.interactive()));
    }
    if (single_file_)
        atomic_write(directory_ / "index.html", framed(subject, links(nullptr), all, interactive));
}

void Pages::remove_stale_files() const {
    for (const auto& entry : std::filesystem::directory_iterator(figures_)) {
        const std::string extension = entry.path().extension().string();
        const bool ours = extension == ".svg" || extension == ".csv";
        if (ours && !files_.contains(entry.path().filename().string())) std::filesystem::remove(entry.path());
    }
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) {
        const std::string file = entry.path().filename().string();
        const bool kept = std::any_of(pages_.begin(), pages_.end(), [&](const Page& page) {
            return (!single_file_ || &page == &pages_.front()) && file == page.name() + ".html";
        });
        if (!kept && is_page(entry.path())) std::filesystem::remove(entry.path());
    }
}

}  // namespace wetdeck::report

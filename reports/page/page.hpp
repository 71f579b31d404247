// SPDX-License-Identifier: BSD-3-Clause
// The pages of a report as they grow: sections, contents, figures; and the frame around them.
#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/page/figure.hpp"

namespace wetdeck::report {

class Pages;

class Page {
  public:
    /// `name` is the stem of its file, `label` its name in the line of links on every page.
    Page(Pages& pages, std::string name, std::string title, std::string label);

    /// Opens a section: level 2 is a chapter, 3 a section of it. Both are in the table of contents. The
    /// anchor is "section-", then the scope, if there is one, and the title.
    void section(int level, std::string_view title, std::string_view scope = "");
    /// An anchor that is no section or figure.
    void anchor(std::string_view name, std::string_view title);
    /// Safe markup.
    void add(const std::string& html) { body_ += html; }
    /// Writes the figure's files and returns its markup.
    std::string figure(const Figure& figure);
    /// Figures side by side where there is room.
    void add_figures(const std::vector<Figure>& figures);

    const Pages& pages() const { return pages_; }
    const std::string& name() const { return name_; }
    const std::string& title() const { return title_; }
    const std::string& label() const { return label_; }
    /// Contents and text, below the title.
    std::string markup() const;
    /// Whether any of its figures is interactive.
    bool interactive() const { return interactive_; }

  private:
    /// Writes the figures' files and returns the markup of each.
    std::vector<std::string> figures(std::span<const Figure> wanted);
    /// A figure with its caption and links around the markup of its drawing.
    std::string framed(const Figure& figure, const std::string& drawing);
    std::string file_links(const std::string& name) const;

    Pages& pages_;
    std::string name_, title_, label_;
    std::string body_;
    std::string contents_;
    std::set<std::string> captions_;  ///< of the figures of this section
    int sections_ = 0;
    bool interactive_ = false;
};

/// What the pages of one report share: the names of anchors, the files of figures, and the frame. Anchors and
/// names of figures are unique over all pages.
class Pages {
  public:
    /// Figures go to DIR/figures; `plotly` is the library's text or empty; `stamp` says where the numbers
    /// come from: it stands at the foot of every page and on every drawing. With `single_file` all pages
    /// become one, DIR/index.html, without a link to another file.
    Pages(std::filesystem::path directory, std::string plotly, std::string stamp, bool single_file);

    /// The first page is "index".
    Page& add(const std::string& name, const std::string& title, const std::string& label);

    /// For links.
    std::string address_of(const std::string& anchor) const;
    std::string address_of_page(const std::string& page) const;
    /// The sections, figures and other anchors of that name, alone or with words behind it ("-filtered"), and
    /// what each shows.
    std::vector<std::string> anchors_like(const std::string& name) const;
    const std::string& title_of(const std::string& anchor) const { return names_.at(anchor).title; }

    /// Addresses and titles of all pages but the first.
    std::vector<std::pair<std::string, std::string>> listed() const;

    bool draws_static() const { return gnuplot_; }
    bool draws_interactive() const { return !plotly_.empty(); }

    /// Writes the pages, and removes what an earlier report left: its pages, and its drawings and tables in
    /// DIR/figures that no page of this one has.
    void write() const;

  private:
    friend class Page;
    struct Place {
        std::string page, title;
    };

    /// Takes the name, with -2, -3, ... if it is taken.
    std::string take(const std::string& wanted, std::string_view title, const Page& page);
    /// The markup of the drawings, or of why there is none.
    std::vector<std::string> static_drawings(std::span<const Figure> figures);
    std::string links(const Page* current) const;
    std::string framed(const std::string& title, const std::string& links, const std::string& content,
                       bool interactive) const;
    void remove_stale_files() const;

    std::filesystem::path directory_, figures_;
    std::string plotly_;
    std::string stamp_;
    bool single_file_;
    bool gnuplot_;
    std::list<Page> pages_;
    std::map<std::string, Place> names_;  ///< of sections, figures and other anchors
    std::set<std::string> files_;         ///< written to DIR/figures
};

}  // namespace wetdeck::report

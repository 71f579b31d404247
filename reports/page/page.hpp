// SPDX-License-Identifier: BSD-3-Clause
// The page as it grows: sections, contents, figures; and the frame around them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reports/page/figure.hpp"

namespace wetdeck::report {

class Page {
  public:
    /// Figures go to DIR/figures; `plotly` is the library's text or empty; `stamp` stands on every drawing.
    Page(std::filesystem::path directory, std::string plotly, std::string stamp);

    /// Opens a section: level 2 is a chapter, 3 a section of it. Both are in the table of contents. The
    /// anchor is "section-", then the scope, if there is one, and the title.
    void section(int level, std::string_view title, std::string_view scope = "");
    /// An anchor that is no section or figure.
    void anchor(std::string_view name, std::string_view title);
    /// The sections, figures and other anchors of that name, alone or with words behind it ("-filtered"), and
    /// what each shows.
    std::vector<std::string> anchors_like(const std::string& name) const;
    const std::string& title_of(const std::string& anchor) const { return names_.at(anchor); }
    /// Safe markup.
    void add(const std::string& html) { body_ += html; }
    /// Writes the figure's files and returns its markup.
    std::string figure(Figure figure);
    /// Figures side by side where there is room.
    void add_figures(const std::vector<Figure>& figures);

    /// The whole page. `header` is safe markup below the title.
    std::string html(std::string_view title, const std::string& header) const;

    bool draws_static() const { return gnuplot_; }
    bool draws_interactive() const { return !plotly_.empty(); }
    /// Removes drawings and tables in DIR/figures that this page does not have.
    void remove_stale_figures() const;

  private:
    std::string static_drawing(const Figure& figure);

    std::filesystem::path figures_;
    std::string plotly_;
    std::string stamp_;
    bool gnuplot_;
    std::string body_;
    std::string contents_;
    std::map<std::string, std::string> names_;  ///< titles of figures and sections by anchor
    std::set<std::string> files_;               ///< written to DIR/figures
};

}  // namespace wetdeck::report

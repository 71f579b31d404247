// SPDX-License-Identifier: BSD-3-Clause
// Where the report shows what the figures of each scene's sources show.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"

namespace wetdeck::report {
namespace {

std::string links_to(const Pages& pages, const SourceFigure& figure) {
    std::string links;
    for (const std::string& place : figure.places) {
        for (const std::string& anchor : pages.anchors_like(place)) {
            links += fmt::format("{}<a href=\"{}\">{}</a>", links.empty() ? "" : "<br>",
                                 pages.address_of(anchor), escape(pages.title_of(anchor)));
        }
    }
    return links;
}

/// The curves of others that the figure shows: what there is of them leads to the list of references.
std::string curves_of(const Pages& pages, const AnalysisSpec& scene, const SourceFigure& figure) {
    const std::vector<std::string> lists = pages.anchors_like("section-" + slug(scene.scene) + "-provenance");
    std::string out;
    for (const SourceCurve& curve : figure.curves) {
        const std::string file =
            escape(fmt::format("reference_data/{}/{}.csv", scene.scene, curve.reference));
        out += out.empty() ? "" : "<br>";
        if (!curve.available)
            out += "curve not available: " + file;
        else if (lists.empty())
            out += file;
        else
            out += fmt::format("<a href=\"{}\">{}</a>", pages.address_of(lists.front()), file);
    }
    return out.empty() ? "—" : out;
}

std::string reason_for_absence(const Summary& summary, const AnalysisSpec& scene,
                               const SourceFigure& figure) {
    if (figure.places.empty()) return "—";
    return runs_of(summary, scene).empty()
               ? "Not shown: this directory holds no run of the scene."
               : "Not shown: the runs in this directory do not hold the data for it.";
}

/// Sources in the order in which the scene names them first.
std::vector<std::string> sources_of(const AnalysisSpec& scene) {
    std::vector<std::string> sources;
    for (const SourceFigure& figure : scene.source_figures) {
        if (std::find(sources.begin(), sources.end(), figure.source) == sources.end())
            sources.push_back(figure.source);
    }
    return sources;
}

std::string figures_table(const Pages& pages, const Summary& summary, const AnalysisSpec& scene,
                          const std::string& source) {
    Table table({"figure", "content", "place in this report", "remark", "curves of others in it"});
    for (const SourceFigure& figure : scene.source_figures) {
        if (figure.source != source) continue;
        const std::string links = links_to(pages, figure);
        table.add({text(figure.number), text(figure.shows),
                   links.empty() ? text(reason_for_absence(summary, scene, figure)) : markup(links),
                   text(figure.remark), markup(curves_of(pages, scene, figure))});
    }
    return table.html();
}

/// The figures of one source in one scene.
struct Block {
    const AnalysisSpec* scene;
    std::string source;
    int first;  ///< number of its first figure
};

/// As the figures follow each other in a source that several scenes share.
std::vector<Block> blocks_of(const std::vector<AnalysisSpec>& scenes) {
    std::vector<Block> blocks;
    for (const AnalysisSpec& scene : scenes) {
        for (const std::string& source : sources_of(scene)) {
            const auto first =
                std::find_if(scene.source_figures.begin(), scene.source_figures.end(),
                             [&](const SourceFigure& figure) { return figure.source == source; });
            blocks.push_back({&scene, source, std::atoi(first->number.c_str())});
        }
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Block& a, const Block& b) { return a.first < b.first; });
    return blocks;
}

}  // namespace

void add_source_figures_part(Pages& pages, const Summary& summary) {
    const std::vector<AnalysisSpec> scenes = scenes_of(summary);
    const auto has_figures = [](const AnalysisSpec& scene) { return !scene.source_figures.empty(); };
    if (std::none_of(scenes.begin(), scenes.end(), has_figures)) return;
    Page& page = pages.add("sources", "Figures of the sources", "sources");
    page.add(
        paragraph("Where this report shows what the figures of the sources show, and whether the measured "
                  "or computed curves of others in them are at hand."));
    for (const Block& block : blocks_of(scenes))
        page.add("<h4>" + escape(block.source) + "</h4>\n" +
                 figures_table(pages, summary, *block.scene, block.source));
}

}  // namespace wetdeck::report

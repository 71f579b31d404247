// SPDX-License-Identifier: BSD-3-Clause
// Figures of the sources of a scene, and reference files that no comparison uses.
#include <fmt/format.h>

#include <set>

#include "validation/scene/sections.hpp"

namespace wetdeck {
namespace {

using Names = std::set<std::string>;

/// References of all quantities and comparisons of the file, whatever the variant.
Names compared_references(const TomlTable& root) {
    Names names;
    for (const char* key : {"quantities", "compare"}) {
        for (const TomlTable& table : root.tables(key)) {
            names.insert(table.text_or("reference", ""));
            for (const char* list : {"references", "shown"})
                for (const std::string& stem : table.texts(list)) names.insert(stem);
        }
    }
    return names;
}

/// The name of a reference file as comparisons give it.
void check_stem(const TomlTable& table, const std::string& key, const std::string& stem) {
    if (stem.empty() || stem.find('/') != std::string::npos || stem.ends_with(".csv"))
        table.fail(key, fmt::format("'{}' is no name of a reference file, expected the part before .csv, "
                                    "without folders",
                                    stem));
}

bool is_anchor(const std::string& text) {
    return !text.empty() &&
           text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

std::vector<SourceCurve> read_curves(const TomlTable& table, const Names& compared) {
    std::vector<SourceCurve> curves;
    for (const std::string& stem : table.texts("curves")) {
        check_stem(table, "curves", stem);
        if (!compared.contains(stem))
            table.fail("curves",
                       fmt::format("'{}' is not the reference of any [[compare]], expected one that "
                                   "the report can show",
                                   stem));
        curves.push_back({stem});
    }
    return curves;
}

SourceFigure read_source_figure(const TomlTable& table, const std::string& source_of_scene,
                                const Names& compared) {
    SourceFigure figure;
    figure.number = table.text("number");
    if (figure.number.empty()) table.fail("number", "expected the number of a figure");
    figure.shows = table.text("shows");
    figure.places = table.texts("places");
    figure.remark = table.text_or("remark", "");
    figure.source = table.text_or("source", source_of_scene);
    figure.curves = read_curves(table, compared);
    for (const std::string& place : figure.places) {
        if (!is_anchor(place))
            table.fail("places", fmt::format("'{}' is no anchor of the report, expected lower-case letters, "
                                             "digits and hyphens",
                                             place));
    }
    if (figure.places.empty() && figure.remark.empty()) {
        const char* expected =
            "expected a list of anchors of the report, or a remark that says why there is no counterpart";
        if (table.has("places")) table.fail("places", expected);
        table.fail_missing("places", expected);
    }
    table.finish();
    return figure;
}

void read_source_figures(const TomlTable& root, const Names& compared, AnalysisSpec& analysis) {
    std::set<std::pair<std::string, std::string>> known;
    for (const TomlTable& table : root.tables("source_figures")) {
        SourceFigure figure = read_source_figure(table, analysis.source, compared);
        if (!known.emplace(figure.source, figure.number).second)
            table.fail("number", fmt::format("'{}' is used twice for one source", figure.number));
        analysis.source_figures.push_back(std::move(figure));
    }
}

void read_unused_references(const TomlTable& root, const Names& compared, AnalysisSpec& analysis) {
    Names known;
    for (const TomlTable& table : root.tables("unused_references")) {
        UnusedReference unused{table.text("file"), table.text("reason")};
        check_stem(table, "file", unused.file);
        if (unused.reason.empty()) table.fail("reason", "expected why no comparison uses the file");
        if (compared.contains(unused.file))
            table.fail("file", fmt::format("'{}' is a reference of this scene, expected one that no "
                                           "comparison or quantity uses",
                                           unused.file));
        if (!known.insert(unused.file).second)
            table.fail("file", fmt::format("'{}' is listed twice", unused.file));
        table.finish();
        analysis.unused_references.push_back(std::move(unused));
    }
}

}  // namespace

void read_sources(const TomlTable& root, AnalysisSpec& analysis) {
    const Names compared = compared_references(root);
    read_source_figures(root, compared, analysis);
    read_unused_references(root, compared, analysis);
}

}  // namespace wetdeck

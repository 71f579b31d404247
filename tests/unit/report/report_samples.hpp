// SPDX-License-Identifier: BSD-3-Clause
// A small made-up summary for the tests of the report.
#pragma once

#include <catch2/catch.hpp>
#include <map>

#include "reports/report.hpp"
#include "tests/unit/store/store_samples.hpp"

namespace wetdeck::samples {

inline ComparisonResult comparison(ReferenceKind kind, const std::string& reference) {
    ComparisonResult c;
    c.title = "Pressure against " + reference;
    c.quantity = "pressure_gauge";
    c.reference = reference;
    c.kind = kind;
    c.citation = "Made-up source of " + reference;
    c.nrmse = 0.07;
    c.tolerance = 0.1;
    c.within = true;
    c.x_label = "T";
    c.y_label = "p";
    c.simulated = {{0, 1, 2}, {0, 5, 3}};
    c.measured = {{0, 1, 2}, {0.5, 4.5, 3.5}};
    return c;
}

inline RunSummary run(const std::string& variant, double spacing) {
    RunSummary r;
    r.record.scene = "tank";
    r.record.variant = variant;
    r.record.particle_spacing = spacing;
    r.record.particles = 1234;
    r.record.cost = {10, 20, 500, 5e5, 64, {{"rates", 7}, {"advance", 3}}, {{"acoustic", 500}}};
    r.record.provenance = {{"commit", "abc1234"}, {"start_time", "2020-01-01T00:00:00Z"}};
    r.directory = "runs/tank/" + variant + "/" + std::to_string(spacing);
    for (const char* name : {"energy_kinetic", "energy_potential", "energy_compression"}) {
        r.record.series[name] = {"J/m", "", {0, 1, 2}, {1, 2, 3}, {}};
    }
    r.quantities = {{"peak", "Pa", 105.0 + spacing, "", 100.0, 20.0, "made up", true}};
    r.comparisons = {comparison(ReferenceKind::experiment, "gauge"),
                     comparison(ReferenceKind::peer_simulation, "other_code"),
                     comparison(ReferenceKind::analytic, "theory")};
    return r;
}

/// Two variants, two spacings each; everything ended and is within tolerance.
inline Summary summary() {
    Summary s;
    s.tier = "quick";
    AnalysisSpec scene;
    scene.scene = "tank";
    scene.title = "Tank";
    scene.default_variant = "two-phase";
    scene.error_quantity = "peak";
    scene.deviations = {{"gravity", "9.8", "9.81", "standard value"}};
    s.scenes = {scene};
    for (const char* variant : {"single-phase", "two-phase"}) {
        for (const double spacing : {0.01, 0.02}) {
            s.runs.push_back(run(variant, spacing));
            s.speed_error.push_back({"tank", variant, spacing, 1 / spacing, spacing, true});
        }
        s.convergence.push_back({"tank",
                                 variant,
                                 "peak",
                                 {0.02, 0.01},
                                 {105.02, 105.01},
                                 {},
                                 {},
                                 {},
                                 {},
                                 {},
                                 true,
                                 "too few spacings"});
    }
    return s;
}

inline report::ReportInputs inputs() {
    report::ReportInputs in;
    in.program = {{"version", "0"}};
    in.sketches["tank"] = "<svg xmlns='http://www.w3.org/2000/svg'/>";
    in.pictures["runs/tank/two-phase/0.010000"] = {
        {"Pressure", 0.5, {1, 2, 3}, {{"p", "Pa", 0, 1, {"#000000", "#ffffff"}}}, 2.0}};
    in.plotly = "window.Plotly = {}; // </script>";
    return in;
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
    return n;
}

inline std::map<std::string, std::string> pages_of(const Summary& summary,
                                                   const report::ReportInputs& inputs = samples::inputs()) {
    const samples::ScratchFolder folder;
    report::write_report(folder, summary, inputs);
    return pages_in(folder);
}

inline std::string page_of(const Summary& summary, const report::ReportInputs& inputs = samples::inputs()) {
    return joined(pages_of(summary, inputs));
}

inline std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    REQUIRE(from != std::string::npos);
    const std::size_t to = text.find(end, from + begin.size());
    return text.substr(from, to - from);
}

}  // namespace wetdeck::samples

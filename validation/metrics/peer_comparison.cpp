// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/peer_comparison.hpp"

#include <algorithm>

#include "validation/metrics/resample.hpp"

namespace wetdeck {
namespace {

using Comparisons = std::vector<const ComparisonResult*>;

bool same_curve(const Curve& a, const Curve& b) {
    return a.x == b.x && a.y == b.y;
}

/// Comparisons of pressures whose curve, simulated or of the reference, is not yet in the list.
void add_once(Comparisons& list, const ComparisonResult& c, Curve ComparisonResult::*curve) {
    const auto known = [&](const ComparisonResult* other) { return same_curve(other->*curve, c.*curve); };
    if ((c.*curve).x.size() > 1 && std::none_of(list.begin(), list.end(), known)) list.push_back(&c);
}

bool of_pressure(const ComparisonResult& c, const RunRecord& record) {
    const auto series = record.series.find(c.quantity);
    return series != record.series.end() && series->second.unit == "Pa";
}

std::optional<Window> common_window(const Comparisons& experiments, const Comparisons& peers) {
    Window window = *experiments.front()->window;
    for (const Comparisons* list : {&experiments, &peers}) {
        for (const ComparisonResult* c : *list) {
            window.begin = std::max(window.begin, c->window->begin);
            window.end = std::min(window.end, c->window->end);
        }
    }
    return window.begin < window.end ? std::optional(window) : std::nullopt;
}

std::optional<double> difference(const Curve& a, const Curve& b, const Window& window) {
    if (!covers(a, window) || !covers(b, window)) return std::nullopt;
    const auto both = overlap(b, *overlap(a, window));
    return both ? std::optional(rms_difference(a, b, *both)) : std::nullopt;
}

}  // namespace

std::optional<PeerComparison> compare_with_peers(const RunSummary& run) {
    Comparisons experiments, peers, own;
    for (const ComparisonResult& c : run.comparisons) {
        const bool experiment = c.kind == ReferenceKind::experiment;
        if (!c.available || !c.window || !of_pressure(c, run.record)) continue;
        if (!experiment && c.kind != ReferenceKind::peer_simulation) continue;
        add_once(experiment ? experiments : peers, c, &ComparisonResult::measured);
        add_once(own, c, &ComparisonResult::simulated);
    }
    if (experiments.empty() || peers.empty()) return std::nullopt;
    const std::optional<Window> window = common_window(experiments, peers);
    if (!window) return std::nullopt;

    PeerComparison result{*window, {}, {}, {}};
    for (const ComparisonResult* c : experiments) result.measured.push_back({c->title, c->reference});
    const auto add_row = [&](std::vector<PeerComparison::Row>& rows, const ComparisonResult& c,
                             const Curve& curve) {
        PeerComparison::Row row{{c.title, c.reference}, c.quantity, {}};
        for (const ComparisonResult* experiment : experiments)
            row.rms.push_back(difference(curve, experiment->measured, *window));
        rows.push_back(std::move(row));
    };
    for (const ComparisonResult* c : peers) add_row(result.peers, *c, c->measured);
    for (const ComparisonResult* c : own) add_row(result.own, *c, c->simulated);
    return result;
}

}  // namespace wetdeck

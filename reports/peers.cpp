// SPDX-License-Identifier: BSD-3-Clause
// Names of references for readers, and what other codes reach against the same measurements.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "reports/html.hpp"
#include "reports/parts.hpp"

namespace wetdeck::report {
namespace {

constexpr std::size_t longest_name = 42;

bool belongs_to_authors(const std::string& word) {
    return word == "et" || word == "al." || word == "and" || word == "&" ||
           (!word.empty() && std::isupper(static_cast<unsigned char>(word.front())) && word.back() != ',');
}

/// Start of "Authors (year)" in a title, npos if there is none.
std::size_t authors_in(const std::string& title) {
    const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(title[i])) != 0; };
    for (std::size_t open = title.find(" ("); open != std::string::npos; open = title.find(" (", open + 1)) {
        const bool year = open + 6 < title.size() && digit(open + 2) && digit(open + 3) && digit(open + 4) &&
                          digit(open + 5) && title[open + 6] == ')';
        if (!year) continue;
        std::size_t begin = open;
        while (begin > 0) {
            const std::size_t gap = title.rfind(' ', begin - 1);
            const std::size_t word = gap == std::string::npos ? 0 : gap + 1;
            if (!belongs_to_authors(title.substr(word, begin - word))) break;
            begin = word == 0 ? 0 : gap;
        }
        if (begin < open) return title[begin] == ' ' ? begin + 1 : begin;
    }
    return std::string::npos;
}

/// Curves that are compared on the same axes.
struct Entry {
    std::string name;
    const Curve* curve;
    Window window;
};

void add_once(std::vector<Entry>& entries, std::string name, const Curve& curve, const Window& window) {
    if (curve.x.size() < 2) return;
    const bool known = std::any_of(entries.begin(), entries.end(), [&](const Entry& e) {
        return e.curve->x == curve.x && e.curve->y == curve.y;
    });
    if (!known) entries.push_back({std::move(name), &curve, window});
}

struct Peers {
    std::vector<Entry> measured, simulated, own;
};

/// The pressures of a run: only they are compared at one height of the gauge.
Peers pressures_of(const RunSummary& run) {
    Peers peers;
    for (const ComparisonResult& c : run.comparisons) {
        const auto series = run.record.series.find(c.quantity);
        const bool pressure = series != run.record.series.end() && series->second.unit == "Pa";
        if (!pressure || !c.available || !c.window) continue;
        if (c.kind == ReferenceKind::experiment) {
            add_once(peers.measured, reference_name(c.title, c.reference), c.measured, *c.window);
        } else if (c.kind == ReferenceKind::peer_simulation) {
            add_once(peers.simulated, c.title, c.measured, *c.window);
        } else {
            continue;
        }
        add_once(peers.own, "this program, " + c.quantity, c.simulated, *c.window);
    }
    return peers;
}

/// What all windows share; empty if nothing.
std::optional<Window> common(const Peers& peers) {
    Window window = peers.measured.front().window;
    for (const auto* entries : {&peers.measured, &peers.simulated}) {
        for (const Entry& e : *entries) {
            window.begin = std::max(window.begin, e.window.begin);
            window.end = std::min(window.end, e.window.end);
        }
    }
    return window.begin < window.end ? std::optional(window) : std::nullopt;
}

/// Linear between the samples; `x` lies within them.
double at(const Curve& curve, double x) {
    const auto above = std::lower_bound(curve.x.begin(), curve.x.end(), x);
    const auto k = static_cast<std::size_t>(above - curve.x.begin());
    if (k == 0) return curve.y.front();
    const double share = (x - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
    return curve.y[k - 1] + share * (curve.y[k] - curve.y[k - 1]);
}

bool covers(const Curve& curve, const Window& window) {
    return curve.x.front() <= window.begin && curve.x.back() >= window.end;
}

std::optional<double> rms_difference(const Curve& a, const Curve& b, const Window& window) {
    if (!covers(a, window) || !covers(b, window)) return std::nullopt;
    constexpr int instants = 2000;
    double sum = 0;
    for (int k = 0; k < instants; ++k) {
        const double x = window.begin + (window.end - window.begin) * k / (instants - 1);
        const double difference = at(a, std::min(x, window.end)) - at(b, std::min(x, window.end));
        sum += difference * difference;
    }
    return std::sqrt(sum / instants);
}

/// The finest run of the first variant that reached its end.
const RunSummary* speaker(const Runs& runs) {
    const RunSummary* out = nullptr;
    for (const RunSummary* run : runs) {
        if (run->record.variant == runs.front()->record.variant && run->record.status == RunStatus::ok)
            out = run;
    }
    return out;
}

}  // namespace

std::string reference_name(const std::string& title, const std::string& stem) {
    std::string name = title;
    if (const std::size_t authors = authors_in(name); authors != std::string::npos) {
        name = name.substr(authors);
        if (name.size() > longest_name) name = name.substr(0, name.find(')') + 1);
    } else if (const std::size_t comma = name.find(", "); comma != std::string::npos) {
        name = name.substr(comma + 2);
    }
    if (name.size() > longest_name) name = name.substr(0, name.find(": "));
    return name.empty() || name.size() > longest_name ? stem : name;
}

std::string peer_table(const Runs& runs) {
    const RunSummary* run = speaker(runs);
    if (run == nullptr) return "";
    const Peers peers = pressures_of(*run);
    if (peers.measured.empty() || peers.simulated.empty()) return "";
    const std::optional<Window> window = common(peers);
    if (!window) return "";
    std::vector<std::string> headers{"simulation"};
    for (const Entry& e : peers.measured) headers.push_back(e.name);
    Table table(headers, "compact");
    for (const auto* entries : {&peers.simulated, &peers.own}) {
        for (const Entry& e : *entries) {
            std::vector<Cell> row{markup(escape(e.name), "wide")};
            for (const Entry& m : peers.measured)
                row.push_back(value(rms_difference(*e.curve, *m.curve, *window)));
            table.add(row);
        }
    }
    return "<h4>What other codes reach against the same measurements</h4>\n" + table.html() +
           paragraph(
               fmt::format("Root mean square difference of the scaled pressures at 2000 equidistant instants "
                           "from {} to {} on the scaled axis of time, interpolated linearly, without a shift "
                           "in time. Rows differ in the height at which they sample: compare those of one "
                           "height. This program: {}. The curves of the others were read from their figures "
                           "or data. A peer as far away as this program shows that the difference is not "
                           "this program's alone; it shows neither that the record nor that the model is "
                           "right.",
                           number(window->begin), number(window->end), run_name(*run)),
               "soft");
}

}  // namespace wetdeck::report

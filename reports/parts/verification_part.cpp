// SPDX-License-Identifier: BSD-3-Clause
// Problems with exact solutions: acceptance criteria, errors and curves.
#include <fmt/format.h>

#include "reports/figures/figures.hpp"
#include "reports/page/html.hpp"
#include "reports/parts/parts.hpp"

namespace wetdeck::report {
namespace {

Cell order_cell(const VerificationRow& row) {
    if (!row.claim.order) return text("none");
    const std::string range =
        fmt::format("{} to {}", number(row.claim.order->begin), number(row.claim.order->end));
    return markup(fmt::format("{}<br><span class=\"soft\">{}</span>",
                              row.order ? fmt::format("{:.2f}", *row.order) : "—", range),
                  "number");
}

std::string outcome(const VerificationRow& row) {
    if (row.within) return "<span class=\"badge good\">met</span>";
    return row.claim.known_miss.empty() ? "<span class=\"badge bad\">not met</span>"
                                        : "<span class=\"badge bad\">not met, known</span>";
}

std::string criteria_table(const VerificationProblem& problem) {
    Table table({"criterion", "error, coarse to fine", "bound", "order, expected range",
                 "reason for bound and order"},
                "compact");
    for (const VerificationRow& row : problem.rows) {
        std::string errors = joined(row.error);
        if (row.claim.resolution != "none")
            errors += "<br><span class=\"soft\">" + escape(row.claim.resolution) + " " +
                      joined(row.resolution) + "</span>";
        table.add({markup(fmt::format("<b>{}</b> {}<br>{}", escape(row.claim.quantity), outcome(row),
                                      escape(row.claim.meaning))),
                   markup(errors, "wide"), value(row.claim.bound), order_cell(row),
                   markup(escape(row.claim.reason), "wide")});
    }
    return table.html();
}

/// Criteria that are not met, over all problems.
std::string misses(const std::vector<VerificationProblem>& problems) {
    Table table({"criterion", "error, coarse to fine", "order, expected range", "cause"});
    for (const VerificationProblem& problem : problems) {
        if (!problem.unstable.empty())
            table.add({text(problem.name), text("a run became unstable"), text("—"), text(problem.unstable)});
        for (const VerificationRow& row : problem.rows) {
            if (row.within) continue;
            const std::string cause = row.claim.known_miss.empty() ? "unknown" : row.claim.known_miss;
            table.add(
                {markup(fmt::format("<b>{}</b><br>{}", escape(row.claim.quantity), escape(problem.title))),
                 text(joined(row.error)), order_cell(row), markup(escape(cause), "wide")});
        }
    }
    return table.empty() ? paragraph("All criteria are met.")
                         : "<h4>Criteria that are not met</h4>\n" + table.html();
}

}  // namespace

void add_verification_part(Page& page, const Summary& summary) {
    if (summary.verification.empty()) return;
    page.add(
        paragraph("The acceptance criteria are set before a problem is run: an upper bound of each error at "
                  "the coarsest resolution, which decreases with the resolution at the lowest expected "
                  "order, and a range of the observed order where an order is expected. The exact solutions "
                  "are computed by quadrature, root finding and integration, not read from tables."));
    page.add(misses(summary.verification));
    for (const VerificationProblem& problem : summary.verification) {
        page.section(2, problem.title);
        page.add(paragraph("Exact solution: " + problem.exact));
        for (const std::string& note : problem.notes) page.add(paragraph(note, "notice"));
        page.add(criteria_table(problem));
        page.add_figures(verification_figures(problem));
    }
}

}  // namespace wetdeck::report

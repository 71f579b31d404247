// SPDX-License-Identifier: BSD-3-Clause
#include "validation/verification/problem.hpp"

#include <algorithm>
#include <chrono>

namespace wetdeck::verification {

Findings::Findings(const std::vector<Claim>& claims, Effort effort) : effort_(effort) {
    for (const Claim& claim : claims) rows_.push_back({claim, {}, {}, std::nullopt, false});
}

std::vector<double> Findings::levels(std::vector<double> coarse_to_fine) const {
    constexpr std::size_t quick_levels = 2;
    if (!full() && coarse_to_fine.size() > quick_levels) coarse_to_fine.resize(quick_levels);
    return coarse_to_fine;
}

void Findings::record(const std::string& quantity, double resolution, double error) {
    const auto row = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const VerificationRow& r) { return r.claim.quantity == quantity; });
    if (row == rows_.end()) throw std::logic_error("no claim of " + quantity);
    row->resolution.push_back(resolution);
    row->error.push_back(error);
}

VerificationFigure& Findings::figure(VerificationFigure figure) {
    figures_.push_back(std::move(figure));
    return figures_.back();
}

std::vector<VerificationRow> Findings::rows() const {
    std::vector<VerificationRow> judged = rows_;
    for (VerificationRow& row : judged) judge(row);
    return judged;
}

VerificationProblem solve(const Problem& problem, Effort effort) {
    const auto start = std::chrono::steady_clock::now();
    Findings findings(problem.claims, effort);
    VerificationProblem result;
    try {
        problem.run(findings);
    } catch (const Unstable& instability) {
        result.unstable = instability.what();
    }
    result.name = problem.name;
    result.title = problem.title;
    result.exact = problem.exact;
    result.rows = findings.rows();
    result.figures = findings.figures();
    result.notes = findings.notes();
    result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

void advance(Simulation& simulation, double end, const std::function<void(const Simulation&)>& observe) {
    // a run that becomes unstable slowly would never end
    constexpr double smallest_share = 0.02;
    const double first_step = simulation.time_step().size;
    while (simulation.time() < end) {
        if (const auto instability = simulation.step(end - simulation.time()))
            throw Unstable(instability->describe());
        if (simulation.time_step().size < smallest_share * first_step)
            throw Unstable("at t = " + std::to_string(simulation.time()) +
                           " s: the stable step has collapsed");
        if (observe) observe(simulation);
    }
}

}  // namespace wetdeck::verification

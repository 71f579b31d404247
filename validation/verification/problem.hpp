// SPDX-License-Identifier: BSD-3-Clause
// A problem with an exact solution: its claims, and its runs.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/simulation.hpp"
#include "validation/metrics/verification.hpp"

namespace wetdeck::verification {

/// quick: the coarse resolutions of the problems that take seconds, for tests. full: everything.
enum class Effort { quick, full };

/// A run of the solver became unstable.
class Unstable : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Collects the results of a problem.
class Findings {
  public:
    Findings(const std::vector<Claim>& claims, Effort effort);

    /// The resolutions to run, coarse to fine: all, or with quick effort the first two.
    std::vector<double> levels(std::vector<double> coarse_to_fine) const;
    bool full() const { return effort_ == Effort::full; }

    /// An error of a claimed quantity. Throws std::logic_error for a quantity without a claim.
    void record(const std::string& quantity, double resolution, double error);
    void note(std::string text) { notes_.push_back(std::move(text)); }
    VerificationFigure& figure(VerificationFigure figure);

    /// Judged rows; a claim without recorded errors is missed.
    std::vector<VerificationRow> rows() const;
    const std::vector<VerificationFigure>& figures() const { return figures_; }
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    Effort effort_;
    std::vector<VerificationRow> rows_;
    std::vector<VerificationFigure> figures_;
    std::vector<std::string> notes_;
};

struct Problem {
    std::string name, title;
    std::string exact;  ///< the exact solution
    bool quick = true;  ///< cheap enough for the tests
    std::vector<Claim> claims;
    std::function<void(Findings&)> run;
};

/// Runs a problem and judges it. An unstable run is part of the result.
VerificationProblem solve(const Problem& problem, Effort effort);

/// Steps to `end`; calls `observe` after each step. Throws Unstable.
void advance(Simulation& simulation, double end, const std::function<void(const Simulation&)>& observe = {});

}  // namespace wetdeck::verification

// SPDX-License-Identifier: BSD-3-Clause
// The choice of the passes of one instruction set, once per run.
#include "solver/passes/instruction_sets.hpp"
#include "solver/passes/isa_passes.hpp"

namespace wetdeck::WETDECK_ISA {

PairPasses choose_pair_passes(const Model& model, Precision precision, bool graded) {
    PairPasses passes;
    passes.wall_means = wall_mean_pass(graded);
    passes.density_rates = density_pass(model, precision, graded);
    passes.accelerations = momentum_pass(model, precision, graded);
    passes.body_forces = body_force_pass(model, graded);
    passes.update_density = update_density;
    passes.filter_near = graded ? filter_near<true> : filter_near<false>;
    return passes;
}

}  // namespace wetdeck::WETDECK_ISA

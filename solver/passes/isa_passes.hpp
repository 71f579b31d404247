// SPDX-License-Identifier: BSD-3-Clause
// The parts that the passes of one instruction set are put together from, one file each.
#pragma once

#include <type_traits>
#include <utility>

#include "solver/passes/pair_passes.hpp"

namespace wetdeck::WETDECK_ISA {

/// `graded` where particles differ in their spacings.
Pass density_pass(const Model& model, Precision precision, bool graded);
Pass momentum_pass(const Model& model, Precision precision, bool graded);
Pass wall_mean_pass(bool graded);
Pass body_force_pass(const Model& model, bool graded);
void update_density(FluidState* state, const DensityUpdate& update);
template <bool graded>
std::uint32_t filter_near(const ClusterPoints& points, const Candidates& candidates, const ListReach& reach,
                          std::uint32_t* out);

/// Calls f.operator()<flags...>() with run-time flags as template arguments.
template <class F>
auto with_flags(F f) {
    return f.template operator()<>();
}
template <class F, class... Rest>
auto with_flags(F f, bool flag, Rest... rest) {
    if (flag)
        return with_flags(
            [f]<bool... more>() { return f.template operator()<true, more...>(); }, rest...);
    return with_flags(
        [f]<bool... more>() { return f.template operator()<false, more...>(); }, rest...);
}

}  // namespace wetdeck::WETDECK_ISA

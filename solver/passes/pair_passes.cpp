// SPDX-License-Identifier: BSD-3-Clause
#include "solver/passes/pair_passes.hpp"

#include "solver/core/errors.hpp"
#include "solver/passes/instruction_sets.hpp"
#include "solver/physics/mixed_precision.hpp"

namespace wetdeck {

PairPasses pair_passes(const Model& model, const std::string& instruction_set, Precision precision,
                       bool graded) {
    if (const std::string choice = without_mixed_pairs(model); !choice.empty()) {
        if (precision == Precision::mixed)
            throw InputError("there are no passes in mixed precision for " + choice);
        if (graded) throw InputError("there are no passes over differing spacings for " + choice);
    }
    struct Choice {
        const char* name;
        bool supported;
        PairPasses (*choose)(const Model&, Precision, bool graded);
    };
#if defined(__x86_64__) && !defined(WETDECK_PLAIN_SIMD)
    const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                            __builtin_cpu_supports("avx512vl");
    const Choice best_first[] = {{"avx512", has_avx512, avx512::choose_pair_passes},
                                 {"avx2", has_avx2, avx2::choose_pair_passes},
                                 {"sse2", true, sse2::choose_pair_passes}};
#else
    const Choice best_first[] = {{"sse2", true, sse2::choose_pair_passes}};  // two lanes, whatever their name
#endif
    for (const Choice& choice : best_first) {
        if (instruction_set.empty() ? !choice.supported : instruction_set != choice.name) continue;
        if (!choice.supported)
            throw InputError(std::string("this processor does not support ") + choice.name);
        PairPasses passes = choice.choose(model, precision, graded);
        passes.instruction_set = choice.name;
        return passes;
    }
    throw InputError("unknown instruction set '" + instruction_set + "', expected sse2, avx2 or avx512");
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
// One set of pair loops per instruction set; each lives in a namespace of its own (see passes.cpp).
#pragma once

namespace wetdeck {

struct Model;
struct PairLoops;

namespace sse2 {
PairLoops choose_pair_loops(const Model& model);
}
namespace avx2 {
PairLoops choose_pair_loops(const Model& model);
}
namespace avx512 {
PairLoops choose_pair_loops(const Model& model);
}

}  // namespace wetdeck

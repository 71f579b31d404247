// SPDX-License-Identifier: BSD-3-Clause
// One set of passes per instruction set; each is compiled in a namespace of its own.
#pragma once

namespace wetdeck {

struct Model;
struct PairPasses;
enum class Precision;

namespace sse2 {
PairPasses choose_pair_passes(const Model& model, Precision precision, bool graded);
}
namespace avx2 {
PairPasses choose_pair_passes(const Model& model, Precision precision, bool graded);
}
namespace avx512 {
PairPasses choose_pair_passes(const Model& model, Precision precision, bool graded);
}

}  // namespace wetdeck

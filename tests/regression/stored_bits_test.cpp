// SPDX-License-Identifier: BSD-3-Clause
// The default scheme keeps its bits in double precision: a change of a formula's rounding is a change of
// results that nobody may make without noticing. Where the change is meant, take the values that the test
// prints, and raise solver/scheme_revision.hpp if results change beyond rounding. (Bits of mixed precision
// depend on the make of the processor, too.)
#include <gnu/libc-version.h>

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/samples.hpp"
#include "validation/run/assemble.hpp"
#include "validation/store/hash.hpp"

using namespace wetdeck;

namespace {

using Known = std::map<std::string, std::uint64_t>;  ///< by instruction set
struct Case {
    const char *scene, *variant;
    double particle_spacing;  // [m]
    Known known;
    std::vector<std::string> overrides = {"execution.precision=double", "execution.skin=0.2"};
};

/// Of positions, velocities and densities after 40 steps, by the order of the particles' ids.
std::uint64_t state_after_steps(const Case& of) {
    const Scene scene = read_scene(find_scene(of.scene), of.variant, of.overrides);
    Simulation simulation = assemble(scene, of.particle_spacing, 1);
    for (int step = 0; step < 40; ++step) REQUIRE_FALSE(simulation.step(1));
    std::vector<double> numbers;
    for (const FluidState& p : samples::by_id(simulation.fluid()))
        numbers.insert(numbers.end(), {p.x, p.y, p.vx, p.vy, p.density});
    return fnv1a_of_words({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)});
}

/// Other compilers, libraries or options round elsewhere.
bool comparable() {
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12 && defined(NDEBUG)
    return std::string_view(gnu_get_libc_version()) == "2.36";
#else
    return false;
#endif
}

const std::vector<Case> cases{
    {"dam_break",
     "two-phase",
     0.04,
     {{"sse2", 0x468d007b313d7bbb}, {"avx2", 0x39e3ac2e16eb0fc3}, {"avx512", 0x65a63598f14cc031}}},
    {"dam_break",
     "single-phase",
     0.04,
     {{"sse2", 0xbb3918071baa727d}, {"avx2", 0xf9726bb2ee0ba134}, {"avx512", 0xccd3c9f8c9704cc1}},
     {"execution.precision=double", "execution.skin=0.4"}},
    {"wedge",
     "two-phase",
     0.02,
     {{"sse2", 0x711d685625e5b49f}, {"avx2", 0x85b14fc0ff574485}, {"avx512", 0xfa63426d9b7dd60f}},
     {"symmetry.x=\"none\"", "execution.precision=double", "execution.skin=0.2"}},
};

}  // namespace

TEST_CASE("The default scheme keeps its bits over forty steps", "[bits]") {
    if (!comparable()) {
        WARN("not tested: the stored bits are of g++ 12 in Release with glibc 2.36");
        return;
    }
    for (const Case& of : cases) {
        for (const std::string& name : samples::instruction_sets()) {
            const samples::ChosenInstructionSet chosen(name);
            const std::uint64_t found = state_after_steps(of);
            INFO(of.scene << " " << of.variant << ", " << name << ": 0x" << std::hex << found);
            CHECK(found == of.known.at(name));
        }
    }
}

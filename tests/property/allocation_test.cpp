// SPDX-License-Identifier: BSD-3-Clause
// Steps take no memory from the heap: every use of operator new in this program is counted.
#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "tests/support/samples.hpp"

using namespace wetdeck;

namespace {
std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
    ++allocations;
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    void* memory =
        alignment <= alignof(std::max_align_t) ? std::malloc(size) : std::aligned_alloc(alignment, whole);
    if (!memory) throw std::bad_alloc();
    return memory;
}
}  // namespace

void* operator new(std::size_t size) {
    return counted(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

TEST_CASE("A step without a list build takes no memory from the heap", "[allocation]") {
    Model model = samples::two_phase_model();
    model.dissipation_switch = GENERATE(false, true);
    model.air_substeps = model.dissipation_switch ? 1 : 3;
    samples::Setup setup = samples::shaken_tank(model, 31);
    setup.execution.threads = GENERATE(1, 2);
    Simulation simulation = setup.simulate();
    const std::size_t at_start = allocations;
    CHECK(at_start > 10);  // the counter counts
    const std::uint64_t builds = simulation.list_builds();
    while (simulation.list_builds() == builds) REQUIRE_FALSE(simulation.step(2e-4));
    const std::uint64_t builds_so_far = simulation.list_builds();
    std::size_t before = 0, quiet_steps = 0;
    while (simulation.list_builds() == builds_so_far) {
        before = allocations;
        const bool stable = !simulation.step(2e-4);
        const std::size_t after = allocations;
        REQUIRE(stable);
        if (simulation.list_builds() > builds_so_far) break;
        ++quiet_steps;
        CHECK(after == before);
    }
    CHECK(quiet_steps > 0);
}

// SPDX-License-Identifier: BSD-3-Clause
// Tests of properties with generated inputs: rapidcheck draws them, and prints the smallest input that it
// finds to fail. The seed is fixed, so that every run draws the same; WETDECK_PROPERTY_SEED sets another.
#pragma once

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>

namespace wetdeck::generated {

inline std::uint64_t seed() {
    const char* given = std::getenv("WETDECK_PROPERTY_SEED");
    return given ? std::strtoull(given, nullptr, 10) : 20200717;
}

/// Calls `property`, which draws its input and states what must hold with RC_ASSERT, with so many inputs.
template <class Property>
void check(int inputs, const Property& property) {
    rc::detail::TestParams parameters;
    parameters.seed = seed();
    parameters.maxSuccess = inputs;
    rc::detail::TestListenerAdapter quiet;
    const std::unordered_map<std::string, rc::detail::Reproduce> nothing_to_reproduce;
    const rc::detail::TestResult result = rc::detail::checkTestable(property, rc::detail::TestMetadata(),
                                                                    parameters, quiet, nothing_to_reproduce);
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    INFO(message.str() << "\nseed: WETDECK_PROPERTY_SEED=" << seed());
    CHECK(result.is<rc::detail::SuccessResult>());
}

/// A number of [low, high], evenly distributed; shrinks towards `low`.
inline rc::Gen<double> number(double low, double high) {
    constexpr int steps = 1 << 16;
    const auto whole = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1));
    return rc::gen::map(whole, [low, high](int n) { return low + (high - low) * n / steps; });
}

/// A whole number of [low, high].
inline rc::Gen<int> whole(int low, int high) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

/// One of the values; a failure prints its place in the list under `name`.
template <class Value>
Value one_of(const char* name, std::initializer_list<Value> values) {
    const int place = *whole(0, static_cast<int>(values.size()) - 1).as(name);
    return *(values.begin() + place);
}

}  // namespace wetdeck::generated

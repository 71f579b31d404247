// SPDX-License-Identifier: BSD-3-Clause
// Programs started through the shell: quoting, what they say, how they end.
#include "validation/store/child_process.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/store/store_samples.hpp"

using namespace wetdeck;

TEST_CASE("A quoted text reaches a program as one word, letter for letter", "[child_process]") {
    for (const char* word : {"plain", "two words", "it's", "$HOME `id` \"x\" \\ ; | > /", "", "a\nb"}) {
        INFO(word);
        CHECK(run_in_shell("printf %s " + shell_quoted(word)).output == word);
    }
}

TEST_CASE("Both streams are kept, in their order and without trailing line ends", "[child_process]") {
    const ShellResult result = run_in_shell("echo one; echo two >&2; echo; exit 3");
    CHECK(result.output == "one\ntwo");
    CHECK(result.status == 3);
    CHECK_FALSE(result.succeeded());
}

TEST_CASE("A command that a signal ended has not succeeded", "[child_process]") {
    CHECK(run_in_shell("kill -9 $$").status == 128 + 9);
}

TEST_CASE("A program is found by its name alone", "[child_process]") {
    CHECK(program_found("sh"));
    CHECK_FALSE(program_found("no such program"));
}

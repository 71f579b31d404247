// SPDX-License-Identifier: BSD-3-Clause
// `wetdeck --version`.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "solver/passes/pair_passes.hpp"
#include "validation/commands/commands.hpp"
#include "validation/commands/options.hpp"
#include "validation/store/environment.hpp"
#include "validation/store/provenance.hpp"

namespace wetdeck {
namespace {

std::string version_text(bool as_json) {
    const Provenance p =
        collect_provenance(pair_passes(Model{}, instruction_set_from_environment()).instruction_set,
                           static_cast<unsigned>(omp_get_max_threads()));
    if (!as_json)
        return fmt::format("wetdeck {}\ncommit {}\ncompiler {} ({})\ninstruction set {}\nthreads {}",
                           p.program_version, p.commit, p.compiler, p.build_type, p.simd, p.threads);
    const nlohmann::json all = {
        {"version", p.program_version}, {"commit", p.commit}, {"compiler", p.compiler},
        {"build_type", p.build_type},   {"simd", p.simd},     {"threads", p.threads}};
    return all.dump(1);
}

}  // namespace

void add_version(CLI::App& app) {
    const auto as_json = std::make_shared<bool>(false);
    add_json(app, *as_json, "with --version: print JSON, for scripts");  // CLI11 reads options in this order
    app.set_version_flag(
        "--version", [as_json] { return version_text(*as_json); },
        "print version, commit, compiler, instruction set and number of threads");
}

}  // namespace wetdeck

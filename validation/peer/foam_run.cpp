// SPDX-License-Identifier: BSD-3-Clause
#include "validation/peer/foam_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>

#include "solver/core/errors.hpp"
#include "validation/openfoam/case_folder.hpp"
#include "validation/run/progress.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/child_process.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* finished_file = "finished";
constexpr int status_of_timeout = 124;
constexpr double largest_slant = 0.1;  // of the first cell at a keel 0.07, of cells along the axes 0
constexpr int test_cells = 12, test_steps = 20;

std::string text_of(const fs::path& file) {
    return fs::is_regular_file(file) ? read_whole_file(file) : std::string();
}

/// Runs a command for at most a wall time [s]. It ends with this process, even where that is killed: else the
/// solver would go on writing into the folder.
ShellResult run_watched(const std::string& command, double limit) {
    return run_in_shell(
        fmt::format("timeout -k 5 {:.0f} {} & job=$!; (while [ -d /proc/{} ]; do sleep 0.5; done; kill $job) "
                    ">/dev/null 2>&1 & watch=$!; wait $job; status=$?; kill $watch; exit $status",
                    std::max(1.0, std::ceil(limit)), command, ::getpid()));
}

/// A step of water in a sheared box.
FoamCase sheared_case() {
    FoamCase foam;
    MeshGrid grid;
    grid.u = grid.v = even_lines(0, 1, 1.0 / test_cells);
    grid.place = [](Vec2 p) { return Vec2(p.x() + 0.5 * p.y(), p.y()); };
    grid.patch = [](Vec2) { return "walls"; };
    foam.mesh = mesh_of(grid);
    foam.gravity = {0, -9.81};
    foam.water = {1000, 1e-3, 0, 1};
    foam.air = {1, 1e-5, 0, 1};
    foam.water_boxes = {{{-10, -10}, {0.6, 0.5}}};
    foam.reference = foam.mesh.centre(foam.mesh.cells.size() - 1);
    foam.largest_step = 2e-3;
    foam.end_time = foam.field_interval = test_steps * 2e-3;
    return foam;
}

/// The largest component of the velocities in a field file.
double largest_speed(const std::string& field) {
    const std::size_t begin = field.find("internalField"), end = field.find("boundaryField");
    double largest = 0;
    if (begin == std::string::npos || end == std::string::npos) return std::nan("");
    std::string inside = field.substr(begin, end - begin);
    std::replace_if(
        inside.begin(), inside.end(), [](char c) { return c == '(' || c == ')' || c == '\n'; }, ' ');
    for (const std::string_view word : cells_of(inside, ' '))
        if (const auto number = number_in(word); number && word.find_first_of(".e") != std::string_view::npos)
            largest = std::max(largest, std::abs(*number));
    return largest;
}

/// The largest speed after the steps in a layer of a thickness; NaN where the solver failed.
double speed_in_layer(const fs::path& folder, double thickness) {
    for (const auto& [name, text] : foam_files(sheared_case(), thickness)) {
        make_directories((folder / name).parent_path());
        atomic_write(folder / name, text);
    }
    const ShellResult result = run_watched("sh " + shell_quoted((folder / "run.sh").string()), 60);
    if (!result.succeeded()) return std::nan("");
    double last = 0;
    fs::path found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto time = number_in(entry.path().filename().string());
        if (!time || *time <= last) continue;
        last = *time;
        found = entry.path();
    }
    return largest_speed(text_of(found / "U"));
}

}  // namespace

void check_solver(const std::string& solver) {
    if (!program_found(solver))
        throw EnvironmentError(fmt::format(
            "{} was not found: install OpenFOAM (Debian: apt install openfoam), or load your own first",
            solver));
}

bool is_finished(const fs::path& folder, const SceneCase& written) {
    return text_of(folder / finished_file) == case_hash(written) + "\n";
}

double last_time_in(const std::string& log) {
    const std::size_t at = log.rfind("\nTime = ");
    if (at == std::string::npos) return 0;
    const std::string_view rest = std::string_view(log).substr(at + 8);
    return number_in(trimmed(rest.substr(0, rest.find('\n')))).value_or(0);
}

void run_case(const fs::path& folder, const Scene& scene, const SceneCase& written, double limit) {
    fs::remove(folder / finished_file);
    write_case(folder, scene, written, true);
    const fs::path log = folder / ("log." + written.foam.solver());
    Progress progress(fmt::format("{} {:.4g} m", written.foam.solver(), written.cell));
    const std::string command = shell_quoted((folder / "run.sh").string());
    auto running = std::async(std::launch::async, [command, limit] { return run_watched(command, limit); });
    while (running.wait_for(std::chrono::seconds(1)) != std::future_status::ready) {
        const double time = last_time_in(text_of(log));
        progress.update(time / written.foam.end_time,
                        fmt::format("t = {:.4g} of {:.4g} s", time, written.foam.end_time));
    }
    const ShellResult result = running.get();
    if (result.status == status_of_timeout)
        throw EnvironmentError(
            fmt::format("{}: not finished within the limit, at {:.4g} of {:.4g} s: the same command "
                        "again with a larger --limit keeps the finished meshes",
                        folder.string(), last_time_in(text_of(log)), written.foam.end_time));
    if (!result.succeeded())
        throw EnvironmentError(fmt::format("{}: {} ended with {}, see {}", folder.string(),
                                           written.foam.solver(), result.status, log.string()));
    atomic_write(folder / finished_file, case_hash(written) + "\n");
}

bool slanted_cells_are_sound(const fs::path& folder) {
    check_solver("interFoam");
    const double thin = speed_in_layer(folder / "layer1", 1),
                 thick = speed_in_layer(folder / "layer1000", 1000);
    fs::remove_all(folder);
    return std::isfinite(thin) && std::isfinite(thick) &&
           std::abs(thin - thick) < 1e-3 * std::max(thin, thick);
}

void check_cells(const SceneCase& written, bool slanted_are_sound) {
    if (slanted_are_sound) return;
    for (std::size_t c = 0; c < written.foam.mesh.cells.size(); ++c)
        if (slant(written.foam.mesh, c) > largest_slant)
            throw EnvironmentError(
                "this build of OpenFOAM multiplies a tensor and a vector in place: velocities on slanted "
                "cells are wrong, and the mesh has such cells; install a build of openfoam.com or "
                "openfoam.org");
}

}  // namespace wetdeck

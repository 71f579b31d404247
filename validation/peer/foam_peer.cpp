// SPDX-License-Identifier: BSD-3-Clause
#include "validation/peer/foam_peer.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <utility>

#include "validation/import/openfoam_files.hpp"
#include "validation/metrics/convergence.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/openfoam/scene_case.hpp"
#include "validation/peer/foam_run.hpp"
#include "validation/peer/foam_series.hpp"
#include "validation/store/atomic_write.hpp"
#include "validation/store/directory_lock.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* fault =
    "This build of OpenFOAM computes slanted cells wrongly (a tensor times a vector in place); the cells of "
    "this mesh are along the axes or locally square, which it computes rightly.";

std::string version_of(const fs::path& folder) {
    OpenfoamFile file;
    file.path = folder / "postProcessing" / "any";
    if (std::string version = openfoam_case(file).version; !version.empty()) return version;
    return "of unknown version";
}

/// Where the columns of a profile lie.
std::string profile_note(const Series& series) {
    return fmt::format("one column for each place [m]: {:.6g}", fmt::join(series.abscissa, " "));
}

/// Writes CURVES/SERIES.csv of the finest mesh in the form of a reference.
void write_curve(const fs::path& file, const std::string& code, const RunRecord& record,
                 const std::string& name) {
    const Series& series = record.series.at(name);
    std::string text = fmt::format(
        "# kind: peer-simulation\n# citation: {}, scene {}, variant {}, cells of {:.6g} m\n# doi: none\n# "
        "figure: none\n"
        "# obtained: computed\n# obtained_from: wetdeck peer openfoam\n# date: {:%Y-%m-%d}\n# "
        "digitisation_error: none\n"
        "# u_data: unknown\n# u_data_source: peer.json has the spread over the meshes\n# sensor: {}\n# "
        "filter: none\n"
        "# sign: as the series of wetdeck\n# time_origin: clock of the scene\n# note: {}\nt [s]",
        code, record.scene, record.variant, record.particle_spacing, fmt::localtime(std::time(nullptr)),
        series.description.empty() ? name : series.description,
        series.abscissa.empty() ? "nothing left out" : profile_note(series));
    const std::size_t columns = series.columns();
    for (std::size_t c = 0; c < columns; ++c)
        text += series.abscissa.empty() ? fmt::format(",{} [{}]", name, series.unit)
                                        : fmt::format(",{}_{} [{}]", name, c + 1, series.unit);
    for (std::size_t k = 0; k < series.time.size(); ++k) {
        text += fmt::format("\n{:.12g}", series.time[k]);
        for (std::size_t c = 0; c < columns; ++c)
            text += fmt::format(",{:.10g}", series.value[k * columns + c]);
    }
    text += "\n";
    make_directories(file.parent_path());
    atomic_write(file, text);
}

}  // namespace

PeerResult run_foam_peer(const Scene& scene, const fs::path& directory, const FoamPeerOptions& options) {
    std::vector<SceneCase> cases;
    for (const double cell : options.cells) cases.push_back(scene_case(scene, cell, options.until));
    check_solver(cases.front().foam.solver());
    make_directories(directory);
    // a solver of an earlier call that was killed ends within a second
    const DirectoryLock lock(directory, std::chrono::seconds(15), DirectoryLock::Holder::with_children);
    const bool sound = slanted_cells_are_sound(directory / "self_test");
    for (const SceneCase& written : cases) check_cells(written, sound);
    const auto start = Clock::now();
    std::vector<RunRecord> records;
    fs::path folder;
    for (const SceneCase& written : cases) {
        folder = directory / fmt::format("cell{:.6g}", written.cell);
        const double spent = std::chrono::duration<double>(Clock::now() - start).count();
        if (!is_finished(folder, written)) run_case(folder, scene, written, options.limit - spent);
        records.push_back(foam_record(scene, written, folder));
    }
    PeerResult result{scene.name(),
                      scene.variant,
                      fmt::format("OpenFOAM {}, {}", version_of(folder), cases.back().foam.solver()),
                      cases.back().differences,
                      {}};
    if (!sound) result.differences.emplace_back(fault);
    for (const auto& [name, series] : records.back().series)
        write_curve(directory / "curves" / (name + ".csv"), result.code, records.back(), name);
    ReferenceShelf references(reference_directory() / scene.name(), scene.analysis.folder);
    for (const QuantitySpec& spec : scene.analysis.quantities) {
        std::vector<std::pair<double, double>> values;
        for (const RunRecord& record : records)
            if (const QuantityResult found = evaluate_quantity(spec, record, references); found.value)
                values.emplace_back(record.particle_spacing, *found.value);
        if (values.empty()) continue;
        PeerQuantity quantity{spec.unit, convergence(values), fmt::format("curves/{}.csv", spec.series)};
        quantity.values.scene = scene.name();
        quantity.values.variant = scene.variant;
        quantity.values.qoi = spec.name;
        result.quantities.push_back(std::move(quantity));
    }
    write_peer_result(directory, result);
    return result;
}

}  // namespace wetdeck

// SPDX-License-Identifier: BSD-3-Clause
#include "validation/import/openfoam_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/import/code_record.hpp"
#include "validation/store/text_table.hpp"
#include "validation/store/whole_file.hpp"

namespace wetdeck {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_mesh = 300'000'000;  // [bytes]

/// What a folder holds, by name.
std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<double> time_of(const fs::path& folder) {
    return number_in(folder.filename().string());
}

/// "force_0.5.dat" is force of a second run, "force.dat" of the first.
void name_quantity(OpenfoamFile& file) {
    file.quantity = file.path.filename().string();
    if (!file.quantity.ends_with(".dat")) return;
    file.quantity.resize(file.quantity.size() - 4);
    const std::size_t mark = file.quantity.rfind('_');
    if (mark == std::string::npos || !number_in(std::string_view(file.quantity).substr(mark + 1))) return;
    file.quantity.resize(mark);
    file.again = true;
}

void add_file(const fs::path& path, std::vector<OpenfoamFile>& files) {
    OpenfoamFile file;
    file.path = path;
    const fs::path folder = fs::absolute(path).parent_path();
    if (const auto start = time_of(folder)) {
        file.start = *start;
        file.object = folder.parent_path().filename().string();
    } else {
        file.object = folder.filename().string();
    }
    name_quantity(file);
    files.push_back(std::move(file));
}

void add_start(const fs::path& folder, std::vector<OpenfoamFile>& files) {
    for (const fs::path& entry : entries_of(folder))
        if (fs::is_regular_file(entry)) add_file(entry, files);
}

bool is_object(const fs::path& folder) {
    const std::vector<fs::path> entries = entries_of(folder);
    return std::any_of(entries.begin(), entries.end(),
                       [](const fs::path& entry) { return fs::is_directory(entry) && time_of(entry); });
}

void add_object(const fs::path& folder, std::vector<OpenfoamFile>& files) {
    for (const fs::path& entry : entries_of(folder))
        if (fs::is_directory(entry) && time_of(entry)) add_start(entry, files);
}

void add_folder(const fs::path& folder, std::vector<OpenfoamFile>& files) {
    if (time_of(folder)) return add_start(folder, files);
    const fs::path inside = folder / "postProcessing";
    const fs::path objects = fs::is_directory(inside) ? inside : folder;
    if (is_object(objects)) return add_object(objects, files);
    std::vector<fs::path> found;
    for (const fs::path& entry : entries_of(objects))
        if (fs::is_directory(entry) && is_object(entry)) found.push_back(entry);
    if (found.size() == 1) return add_object(found.front(), files);
    if (found.empty())
        throw InputError(
            fmt::format("{}: holds no function object, expected a case, postProcessing/NAME, or its files",
                        folder.string()));
    std::vector<std::string> names;
    for (const fs::path& object : found) names.push_back(object.string());
    throw InputError(fmt::format("{}: holds several function objects, expected one of {}", folder.string(),
                                 fmt::join(names, ", ")));
}

/// The folder of the case that a file of postProcessing belongs to, or nothing.
std::optional<fs::path> case_of(const fs::path& file) {
    for (fs::path at = fs::absolute(file).parent_path(); at.has_relative_path(); at = at.parent_path())
        if (at.filename() == "postProcessing") return at.parent_path();
    return std::nullopt;
}

std::string version_in_logs(const fs::path& folder) {
    for (const fs::path& entry : entries_of(folder)) {
        if (!entry.filename().string().starts_with("log") || !fs::is_regular_file(entry)) continue;
        if (const std::string number = word_behind(entry.string(), "OPENFOAM="); !number.empty())
            return fmt::format("v{}", number);
        if (std::string build = word_behind(entry.string(), "Build  :"); !build.empty()) return build;
    }
    return {};
}

/// Whether a dictionary of materials lists two phases.
bool names_phases(const fs::path& folder) {
    for (const char* name : {"transportProperties", "thermophysicalProperties"}) {
        const fs::path file = folder / "constant" / name;
        if (!fs::is_regular_file(file)) continue;
        const std::string text = read_whole_file(file);
        if (text.find("\nphases") != std::string::npos) return true;
    }
    return false;
}

}  // namespace

std::vector<OpenfoamFile> openfoam_files(const std::vector<std::string>& paths) {
    std::vector<OpenfoamFile> files;
    for (const std::string& path : paths) {
        const std::size_t before = files.size();
        if (fs::is_directory(path))
            add_folder(path, files);
        else if (fs::is_regular_file(path))
            add_file(path, files);
        else
            throw InputError(fmt::format("{}: no such file or folder", path));
        if (files.size() == before) throw InputError(fmt::format("{}: holds no files", path));
    }
    std::stable_sort(files.begin(), files.end(), [](const OpenfoamFile& a, const OpenfoamFile& b) {
        return std::tie(a.object, a.quantity, a.start, a.again) <
               std::tie(b.object, b.quantity, b.start, b.again);
    });
    return files;
}

std::optional<double> layer_of_points(const std::string& text) {
    std::array<std::set<double>, 3> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while ((at = std::find(at, end, '(')) != end) {
        ++at;
        std::array<double, 3> point{};
        bool sound = true;
        for (double& value : point) {
            while (at != end && *at == ' ') ++at;
            const auto [stop, error] = std::from_chars(at, end, value);
            sound = sound && error == std::errc{};
            at = stop;
        }
        if (!sound) continue;
        for (std::size_t k = 0; k < 3; ++k)
            if (values[k].size() < 3) values[k].insert(point[k]);
    }
    std::optional<double> layer;
    for (const std::set<double>& planes : values) {
        if (planes.size() != 2) continue;
        if (layer) return std::nullopt;  // two of them: a mesh of one row
        layer = *planes.rbegin() - *planes.begin();
    }
    return layer;
}

OpenfoamCase openfoam_case(const OpenfoamFile& file) {
    OpenfoamCase found;
    const auto folder = case_of(file.path);
    if (!folder) return found;
    found.version = version_in_logs(*folder);
    if (names_phases(*folder)) found.phase = "two-phase";
    const fs::path points = *folder / "constant" / "polyMesh" / "points";
    std::error_code error;
    if (fs::is_regular_file(points, error) && fs::file_size(points, error) < largest_mesh)
        found.layer = layer_of_points(read_whole_file(points));
    return found;
}

}  // namespace wetdeck

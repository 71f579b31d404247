// SPDX-License-Identifier: BSD-3-Clause
// The collection of frames of a run on disk.
#include "validation/store/fields.hpp"

#include <fmt/format.h>

#include <set>
#include <system_error>

#include "validation/store/atomic_write.hpp"
#include "validation/store/frame_file.hpp"

namespace wetdeck {
namespace {

const std::filesystem::path frames_folder = "fields";

std::filesystem::path collection_of(const std::filesystem::path& run_dir) {
    return run_dir / "fields.pvd";
}

/// Numbers go on behind the last frame kept, so that an orphan of a kill is overwritten.
std::filesystem::path next_path(const std::filesystem::path& run_dir, std::size_t index) {
    return run_dir / frames_folder / fmt::format("frame_{:06}.vtp", index);
}

bool is_frame(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with("frame_") && (name.ends_with(".vtp") || name.ends_with(".vtp.tmp"));
}

/// Removes the frames that the collection does not list.
void remove_others(const std::filesystem::path& folder, const std::vector<FrameEntry>& kept) {
    std::set<std::string> names;
    for (const FrameEntry& frame : kept) names.insert(frame.path.filename().string());
    std::error_code error;
    std::vector<std::filesystem::path> others;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const bool listed = names.contains(entry.path().filename().string());
        if (is_frame(entry.path()) && !listed) others.push_back(entry.path());
    }
    for (const auto& path : others) {
        std::filesystem::remove(path, error);
        if (error) throw environment_error(path, "remove", error.value());
    }
}

}  // namespace

FieldWriter::FieldWriter(const std::filesystem::path& run_dir, double keep_until) : run_dir_(run_dir) {
    make_directories(run_dir_ / frames_folder);
    if (keep_until != -std::numeric_limits<double>::infinity()) {
        // Frames are numbered without gaps: the first that is late or lost ends what is kept.
        for (const FrameEntry& frame : list_frames(run_dir_)) {
            const bool expected = frame.path == next_path(run_dir_, frames_.size());
            if (!expected || frame.time > keep_until || !std::filesystem::exists(frame.path)) break;
            frames_.push_back(frame);
        }
    }
    write_collection();
    remove_others(run_dir_ / frames_folder, frames_);
}

void FieldWriter::write(const FieldFrame& frame) {
    const std::filesystem::path path = next_path(run_dir_, frames_.size());
    atomic_write(path, vtp_bytes(frame));
    frames_.push_back({frame.time, path});
    try {
        write_collection();
    } catch (...) {
        frames_.pop_back();
        throw;
    }
}

void FieldWriter::write_collection() const {
    std::vector<FrameEntry> relative = frames_;
    for (FrameEntry& frame : relative) frame.path = frames_folder / frame.path.filename();
    atomic_write(collection_of(run_dir_), pvd_bytes(relative));
}

std::vector<FrameEntry> list_frames(const std::filesystem::path& run_dir) {
    const std::filesystem::path path = collection_of(run_dir);
    if (!std::filesystem::exists(path)) return {};
    std::vector<FrameEntry> frames = read_pvd(path);
    for (FrameEntry& frame : frames) frame.path = run_dir / frame.path;
    return frames;
}

}  // namespace wetdeck

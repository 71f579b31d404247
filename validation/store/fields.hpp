// SPDX-License-Identifier: BSD-3-Clause
// Fields of a run for ParaView: DIR/fields/frame_000012.vtp and DIR/fields.pvd, which lists them with their
// times. VTK stays behind this target.
//
// Data are inline base64, zlib level 1. Appended data, VTK's default, must not be used: ParaView 5.11 with a
// current libexpat cannot open it (VTK bug 19258). One vertex cell per particle, or nothing would be drawn.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace wetdeck {

/// All particles at one time, SI, in the precision of a picture: half the bytes and half the time to write
/// them. All vectors have the same length, but that of the spacings, which is empty where all are equal.
struct FieldFrame {
    double time = 0;  ///< [s]
    std::vector<float> x, y, vx, vy, pressure, density;
    std::vector<float> spacing;  ///< that each particle was laid at [m]
    std::vector<int> phase;      ///< 0 water, 1 air, 2 wall, 3 and above: bodies
    std::vector<std::int64_t> id;
    std::string provenance;  ///< one line: which run of which program; empty: none is written
};

struct FrameEntry {
    double time = 0;  ///< [s]
    std::filesystem::path path;
};

/// Writes the frames of one run. Each frame, and after it the collection, appears whole. Members throw
/// EnvironmentError if the machine refuses; the frames before stay readable.
class FieldWriter {
  public:
    /// Starts anew and removes old frames, or, to go on from a checkpoint, keeps those with
    /// time <= `keep_until` [s].
    explicit FieldWriter(const std::filesystem::path& run_dir,
                         double keep_until = -std::numeric_limits<double>::infinity());

    /// Throws DataError if the vectors of the frame differ in length.
    void write(const FieldFrame& frame);

    const std::vector<FrameEntry>& frames() const { return frames_; }

  private:
    void write_collection() const;

    std::filesystem::path run_dir_;
    std::vector<FrameEntry> frames_;
};

/// The frames that DIR/fields.pvd lists, in its order; none if there is no such file. Throws DataError if it
/// is not a collection.
std::vector<FrameEntry> list_frames(const std::filesystem::path& run_dir);

/// Throws DataError, naming the file, if it is missing, damaged or lacks an array.
FieldFrame read_frame(const std::filesystem::path& path);

}  // namespace wetdeck

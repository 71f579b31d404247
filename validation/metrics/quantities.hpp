// SPDX-License-Identifier: BSD-3-Clause
// Quantities of interest: one number from one series of a run.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "validation/metrics/reference.hpp"
#include "validation/metrics/specification.hpp"
#include "validation/metrics/summary.hpp"

namespace wetdeck {

/// Path of the file `stem`.csv of a scene: in the scene's own folder if that holds it, else in `directory`.
std::filesystem::path reference_file(const std::string& stem, const std::filesystem::path& own,
                                     const std::filesystem::path& directory);

/// The references of one scene, each read or computed once.
class ReferenceShelf {
  public:
    /// @param directory  holds the files of the scene, for example reference_data/dam_break
    /// @param own        looked into first, if not empty
    explicit ReferenceShelf(std::filesystem::path directory, std::filesystem::path own = {})
        : directory_(std::move(directory)), own_(std::move(own)) {}

    /// The file `stem`.csv, or null if there is none; the computed curve where `stem` begins with
    /// "analytic:". Throws DataError for a file that is not sound, InputError for an unknown analytic curve.
    const Reference* find(const std::string& stem);

  private:
    std::optional<Reference> read(const std::string& stem) const;

    std::filesystem::path directory_, own_;
    struct Entry {
        std::optional<Reference> reference;
        std::string problem;  ///< of a file that is not sound
    };
    std::map<std::string, Entry> files_;
};

/// "stem fnv1a64:..., ..." of every reference file that the scene names and that exists, in order.
std::string reference_hashes(const AnalysisSpec& scene, const std::filesystem::path& directory);

/// The note on a quantity or comparison whose reference file does not exist.
std::string curve_not_available(const std::string& stem);

/// A column of a reference as a scaled curve: a column without a unit is scaled already, one in SI units is
/// divided by the scale.
Curve scaled_reference(const Reference& reference, const std::string& x_column, const std::string& y_column,
                       double x_scale, double y_scale);

/// The first key that the metric of the specification needs and the specification lacks; null if there is
/// none.
const char* missing_key(const QuantitySpec& spec);

/// Takes the quantity from the run: its metric over the scaled series y(x), in its window (the whole series
/// if there is none). The value is empty, with a note, where the series is missing or not sound, the
/// reference is missing, not sound or of another dimension, the threshold is not reached, or the series
/// covers less than `required_coverage` of a window that the metric needs whole. Throws InputError for a key
/// that the metric needs and the specification lacks.
QuantityResult evaluate_quantity(const QuantitySpec& spec, const RunRecord& record,
                                 ReferenceShelf& references);

}  // namespace wetdeck

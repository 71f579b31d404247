// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/reference_curve.hpp"

#include "solver/core/errors.hpp"
#include "validation/metrics/dimensions.hpp"

namespace wetdeck {
namespace {

/// On the scaled axis; nothing where it is that of a column of another dimension.
std::optional<StandardUncertainty> scaled(const std::optional<StandardUncertainty>& given, const Column& y,
                                          double scale) {
    if (!given || given->relative()) return given;
    if (!same_dimension(unit_named(given->unit), unit_named(y.unit))) return std::nullopt;
    return StandardUncertainty{given->value / (y.unit == "-" ? 1 : scale), "-"};
}

ReferenceCurve sound_curve(const ReferenceRequest& request, ReferenceShelf& references) {
    ReferenceCurve found;
    found.reference = references.find(request.reference);
    if (found.reference == nullptr) {
        found.problem = curve_not_available(request.reference);
        return found;
    }
    const Reference& reference = *found.reference;
    const std::string& first = reference.columns.front().name;
    const Column& x = find_column(reference, request.x_column.empty() ? first : request.x_column);
    const Column& y = find_column(reference, request.y_column);
    check_dimensions(request.series, request.units, x, y);
    found.empty_cells = y.empty_cells;
    found.curve =
        scaled_reference(reference, x.name, y.name, request.scaling.x_scale, request.scaling.y_scale);
    found.u_data = scaled(reference.u_data, y, request.scaling.y_scale);
    found.u_data_assumed = scaled(reference.u_data_assumed, y, request.scaling.y_scale);
    const bool along_first = x.name == first;
    if (reference.u_abscissa && along_first)
        found.u_abscissa = *reference.u_abscissa / (x.unit == "-" ? 1 : request.scaling.x_scale);
    return found;
}

ReferenceCurve unusable(const std::string& why) {
    ReferenceCurve found;
    found.problem = "curve not available: " + why;
    found.unusable = true;
    return found;
}

}  // namespace

ReferenceRequest request_of(const ComparisonSpec& spec) {
    return {spec, spec.units, spec.quantity, spec.reference, spec.x_column, spec.y_column};
}

ReferenceRequest request_of(const QuantitySpec& spec) {
    return {spec, spec.units, spec.series, spec.reference, "", spec.y_column};
}

ReferenceCurve reference_curve(const ReferenceRequest& request, ReferenceShelf& references) {
    try {
        return sound_curve(request, references);
    } catch (const InputError& error) {
        return unusable(error.what());
    } catch (const EnvironmentError& error) {
        return unusable(error.what());
    }
}

}  // namespace wetdeck

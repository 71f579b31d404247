// SPDX-License-Identifier: BSD-3-Clause
// Quantities of a scene and its comparisons with references.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "solver/core/errors.hpp"
#include "validation/analytic/curves.hpp"
#include "validation/metrics/dimensions.hpp"
#include "validation/metrics/quantities.hpp"
#include "validation/scene/axes.hpp"
#include "validation/scene/sections.hpp"
#include "validation/scene/time_origins.hpp"

namespace wetdeck {
namespace {

std::optional<Window> window(const TomlTable& table) {
    if (!table.has("window")) return std::nullopt;
    const std::vector<double> ends = table.numbers("window", 2);
    if (!(ends[0] < ends[1])) table.fail("window", "expected a begin below its end");
    return Window{ends[0], ends[1]};
}

/// A missing file is no error until the report is written; an analytic curve must exist.
std::string read_reference(const TomlTable& table, const std::string& key, std::string reference) {
    if (!is_analytic(reference)) return reference;
    try {
        check_analytic(reference);
    } catch (const InputError& error) {
        table.fail(key, error.what());
    }
    return reference;
}

std::string read_unit(const TomlTable& table, const QuantitySpec& q) {
    std::optional<std::string> stated;
    if (table.has("unit")) stated = table.text("unit");
    try {
        return quantity_unit(q, stated);
    } catch (const InputError& error) {
        table.fail("unit", error.what());
    }
}

/// Where a profile is taken: at one instant, or as the mean of an interval; no other series has one.
void read_instant(const TomlTable& table, const std::string& series, const SeriesUnits& units,
                  SeriesScaling& scaling) {
    const bool profile = units.x.series == "m";
    if (profile != table.has("instant"))
        table.fail("instant",
                   profile ? fmt::format("missing: series '{}' is a profile, taken at one instant or as the "
                                         "mean of an interval",
                                         series)
                           : fmt::format("expected none: series '{}' is no profile", series));
    if (!profile) return;
    if (table.is_number("instant")) {
        scaling.instant = table.number("instant");
        return;
    }
    const std::vector<double> ends = table.numbers("instant", 2);
    if (!(ends[0] < ends[1])) table.fail("instant", "expected a begin below its end");
    scaling.instant = ends[0];
    scaling.interval = ends[1] - ends[0];
}

QuantitySpec read_quantity(const TomlTable& table, const Axes& axes) {
    QuantitySpec q;
    q.name = table.text("name");
    q.metric = &metric_named(table.choice("metric", metric_names()));
    q.series = table.text("series");
    q.units = axes.read(table, q.series, q);
    read_instant(table, q.series, q.units, q);
    q.window = window(table);
    q.threshold = table.optional_number("threshold");
    q.reference = read_reference(table, "reference", table.text_or("reference", ""));
    q.y_column = table.text_or("y_column", "");
    q.unit = read_unit(table, q);
    q.expected = table.optional_number("expected");
    q.tolerance = table.optional_number("tolerance");
    q.expected_source = table.text_or("expected_source", "");
    if (table.has("expected_kind"))
        q.expected_kind = reference_kind_named(table.choice("expected_kind", reference_kind_names()));
    q.expected_uncertainty = table.optional_number("expected_uncertainty");
    if (table.has("assumed_uncertainty")) {
        if (q.expected_uncertainty)
            table.fail("assumed_uncertainty", "expected none beside 'expected_uncertainty'");
        q.expected_uncertainty = table.number("assumed_uncertainty");
        q.assumed_reason = table.text("assumed_reason");
    }
    if (table.has("required")) q.required = table.positive("required");
    if (q.expected_uncertainty && *q.expected_uncertainty < 0)
        table.fail("expected_uncertainty", "expected zero or a positive number");
    if (const char* key = missing_key(q); key != nullptr)
        table.fail(key, fmt::format("missing, the metric {} needs it", q.metric->name));
    if (const std::optional<TomlTable> lines = table.optional_table("lines")) {
        for (const std::string& name : lines->keys()) q.lines.emplace_back(name, lines->number(name));
        lines->finish();
    }
    if (const std::optional<TomlTable> curve = table.optional_table("curve")) {
        q.curve = {curve->text("title"), curve->text("label"), curve->number("x")};
        curve->finish();
    }
    if (q.tolerance && !(*q.tolerance > 0)) table.fail("tolerance", "expected a positive number");
    if (q.expected && !q.tolerance) table.fail("tolerance", "missing beside 'expected'");
    table.finish();
    return q;
}

bool aligns_peaks(const TomlTable& table) {
    if (!table.has("align")) return false;
    table.choice("align", {"peak"});
    for (const char* key : {"x_origin", "instant"}) {
        if (table.has(key))
            table.fail(key,
                       "expected none beside 'align = \"peak\"', which puts the origin at the largest "
                       "value of each curve over time");
    }
    return true;
}

/// One reference, or a list of references with the same columns.
std::vector<std::string> compared_references(const TomlTable& table) {
    if (!table.has("references")) return {read_reference(table, "reference", table.text("reference"))};
    if (table.has("reference")) table.fail("references", "expected none beside 'reference'");
    const std::vector<std::string> stems = table.texts("references");
    if (stems.empty()) table.fail("references", "expected at least one reference");
    for (const std::string& stem : stems) read_reference(table, "references", stem);
    return stems;
}

/// One comparison for each reference, and one without a verdict for each that is only shown; those of lists
/// have its name after the title.
std::vector<ComparisonSpec> read_comparison(const TomlTable& table, const Axes& axes) {
    ComparisonSpec c;
    c.title = table.text("title");
    c.quantity = table.text("quantity");
    const std::vector<std::string> references = compared_references(table);
    c.x_column = table.text("x_column");
    c.y_column = table.text("y_column");
    c.units = axes.read(table, c.quantity, c);
    c.y_offset = table.number_or("y_offset", 0);
    c.align_peaks = aligns_peaks(table);
    read_instant(table, c.quantity, c.units, c);
    c.window = window(table);
    c.tolerance = table.positive("tolerance");
    if (table.has("required")) c.required = table.positive("required");
    c.x_label = table.text_or("x_label", c.x_column);
    c.y_label = table.text_or("y_label", c.y_column);
    std::vector<ComparisonSpec> all(references.size(), c);
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k].reference = references[k];
        if (table.has("references")) all[k].title += ", " + references[k];
    }
    for (const std::string& stem : table.texts("shown")) {
        c.reference = read_reference(table, "shown", stem);
        c.judged = false;
        all.push_back(c);
        all.back().title += ", " + stem;
    }
    table.finish();
    return all;
}

/// Whether an entry applies to the variant that is read; one without a list of variants applies to all.
bool of_this_variant(const TomlTable& table, const Scene& scene) {
    if (!table.has("variants")) return true;
    std::vector<std::string> known;
    for (const VariantInfo& variant : scene.variants) known.push_back(variant.name);
    const std::vector<std::string> named = table.texts("variants");
    for (const std::string& name : named) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            table.fail("variants", fmt::format("'{}' is not a variant of this scene", name));
    }
    return std::find(named.begin(), named.end(), scene.variant) != named.end();
}

/// Those of this variant are kept; the names of all are returned.
std::set<std::string> read_quantities(const TomlTable& root, const Axes& axes, Scene& scene) {
    std::set<std::string> names;
    std::vector<QuantitySpec>& quantities = scene.analysis.quantities;
    for (const TomlTable& table : root.tables("quantities")) {
        table.choice("series", axes.series_names());
        const bool wanted = of_this_variant(table, scene);
        const QuantitySpec quantity = read_quantity(table, axes);
        names.insert(quantity.name);
        if (!wanted) continue;
        const auto same = [&](const QuantitySpec& q) { return q.name == quantity.name; };
        if (std::any_of(quantities.begin(), quantities.end(), same))
            table.fail("name", "is used twice for one variant");
        quantities.push_back(quantity);
    }
    return names;
}

void read_comparisons(const TomlTable& root, const Axes& axes, Scene& scene) {
    for (const TomlTable& table : root.tables("compare")) {
        table.choice("quantity", axes.series_names());
        const bool wanted = of_this_variant(table, scene);
        const std::vector<ComparisonSpec> read = read_comparison(table, axes);
        if (!wanted) continue;
        std::vector<ComparisonSpec>& comparisons = scene.analysis.comparisons;
        comparisons.insert(comparisons.end(), read.begin(), read.end());
    }
}

void read_deviations(const TomlTable& root, AnalysisSpec& analysis) {
    for (const TomlTable& table : root.tables("deviations")) {
        analysis.deviations.push_back(
            {table.text("item"), table.text("source"), table.text("used"), table.text("reason")});
        table.finish();
    }
}

void read_sensitivities(const TomlTable& root, AnalysisSpec& analysis) {
    for (const TomlTable& table : root.tables("sensitivity")) {
        SensitivitySpec spec;
        spec.key = table.text("key");
        spec.low = table.number("low");
        spec.high = table.number("high");
        spec.uncertainty = table.positive("uncertainty");
        spec.assumed = table.has("reason");
        if (spec.assumed == table.has("source"))
            table.fail("source", "expected either who states the uncertainty, or a 'reason' to assume it");
        spec.source = table.text(spec.assumed ? "reason" : "source");
        if (table.has("low_with")) spec.low_with = table.texts("low_with");
        if (table.has("high_with")) spec.high_with = table.texts("high_with");
        if (!(spec.low < spec.high)) table.fail("low", "expected a number below 'high'");
        table.finish();
        analysis.sensitivities.push_back(spec);
    }
}

/// Names of variants of this scene.
std::vector<std::string> variants_in(const TomlTable& table, const Scene& scene) {
    const std::vector<std::string> names = table.texts("variants");
    if (names.empty()) table.fail("variants", "expected at least one variant");
    for (const std::string& name : names) {
        const auto same = [&](const VariantInfo& variant) { return variant.name == name; };
        if (std::none_of(scene.variants.begin(), scene.variants.end(), same))
            table.fail("variants", fmt::format("'{}' is not a variant of this scene", name));
    }
    return names;
}

void read_sound_speed_study(const TomlTable& root, Scene& scene) {
    scene.analysis.sound_speed = scene.model.water.eos.sound_speed;
    const std::optional<TomlTable> table = root.optional_table("sound_speed_study");
    if (!table) return;
    scene.analysis.sound_speed_variants = variants_in(*table, scene);
    scene.analysis.twice_sound_speed_with = table->texts("twice_with");
    table->finish();
}

void read_replicates(const TomlTable& root, Scene& scene) {
    const std::optional<TomlTable> table = root.optional_table("replicates");
    if (!table) return;
    scene.analysis.replicated_variants = variants_in(*table, scene);
    const double count = table->number_or("count", scene.analysis.replicates);
    if (count < 2 || count > 1000 || count != std::floor(count))
        table->fail("count", "expected a whole number of runs from 2 to 1000");
    scene.analysis.replicates = static_cast<int>(count);
    table->finish();
}

void read_source_run(const TomlTable& root, AnalysisSpec& analysis) {
    const std::optional<TomlTable> table = root.optional_table("source_run");
    if (!table) return;
    const double duration = table->positive("duration");
    analysis.source_run = {table->positive("particles"), duration / table->positive("time_step"),
                           table->text("conditions")};
    table->finish();
}

/// Names of the time origins that the entries of a table use, in whatever variant.
void add_origins(const TomlTable& root, const std::string& key, std::set<std::string>& used) {
    for (const TomlTable& table : root.tables(key)) used.insert(table.text_or("x_origin", ""));
}

void read_origins(const TomlTable& root, const Axes& axes, Scene& scene) {
    AnalysisSpec& analysis = scene.analysis;
    analysis.origins = axes.origins();
    analysis.contacts = geometric_contacts(scene);
    analysis.sample_interval = scene.sample_interval;
    std::set<std::string> used;
    for (const char* key : {"quantities", "compare"}) add_origins(root, key, used);
    analysis.stated_contacts = stated_contacts(analysis, used);
}

}  // namespace

void read_analysis(const TomlTable& root, Scene& scene) {
    AnalysisSpec& analysis = scene.analysis;
    const Axes axes(root, scene);
    for (const Probe& probe : scene.probes) analysis.probes.push_back(probe.series.name);
    const std::set<std::string> quantities = read_quantities(root, axes, scene);
    read_comparisons(root, axes, scene);
    read_origins(root, axes, scene);
    read_statements(root, axes.series_names(), {quantities.begin(), quantities.end()}, scene);
    read_deviations(root, analysis);
    read_sources(root, analysis);
    read_sensitivities(root, analysis);
    read_sound_speed_study(root, scene);
    read_replicates(root, scene);
    read_source_run(root, analysis);
    analysis.limits = root.texts("limits");
    analysis.error_quantity = root.text_or("error_quantity", "");
    if (!analysis.error_quantity.empty() && !quantities.contains(analysis.error_quantity))
        root.fail("error_quantity", fmt::format("'{}' is not among [[quantities]]", analysis.error_quantity));
}

}  // namespace wetdeck

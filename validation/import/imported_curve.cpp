// SPDX-License-Identifier: BSD-3-Clause
#include "validation/import/imported_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.hpp"
#include "validation/metrics/units.hpp"

namespace wetdeck {
namespace {

/// The options that are missing, in one message.
class Missing {
  public:
    void ask(const char* option, const std::string& for_what) {
        texts_.push_back(fmt::format("{} ({})", option, for_what));
    }
    void check() const {
        if (!texts_.empty())
            throw InputError(
                fmt::format("the files do not say all: expected also {}", fmt::join(texts_, ", ")));
    }

  private:
    std::vector<std::string> texts_;
};

bool is(const Unit& unit, const char* name) {
    return same_dimension(unit, unit_named(name));
}

std::vector<const RecordColumn*> chosen(const CodeRecord& record, const ImportChoices& choices) {
    std::vector<std::string> names;
    for (const RecordColumn& column : record.columns) names.push_back(column.name);
    if (choices.columns.empty() && record.columns.size() == 1) return {&record.columns.front()};
    if (choices.columns.empty())
        throw InputError(fmt::format("--column is missing: expected one of {}", fmt::join(names, ", ")));
    std::vector<const RecordColumn*> found;
    for (const std::string& name : choices.columns) {
        const auto at = std::find(names.begin(), names.end(), name);
        if (at == names.end())
            throw InputError(
                fmt::format("--column {}: no such column, expected one of {}", name, fmt::join(names, ", ")));
        found.push_back(&record.columns[static_cast<std::size_t>(at - names.begin())]);
        const std::vector<double>& values = found.back()->values;
        if (std::all_of(values.begin(), values.end(), [](double v) { return std::isnan(v); }))
            throw InputError(fmt::format("--column {}: holds no value{}", name,
                                         found.back()->sensor.empty() ? "" : ", " + found.back()->sensor));
    }
    return found;
}

/// A chosen column and what its numbers become.
struct Output {
    const RecordColumn* column = nullptr;
    Unit unit;
    double factor = 1, offset = 0;  ///< value * factor + offset, SI
    std::string unit_text;
};

void check_word(const char* option, const std::optional<std::string>& word,
                std::initializer_list<const char*> words) {
    if (word && std::none_of(words.begin(), words.end(), [&](const char* w) { return *word == w; }))
        throw InputError(fmt::format("{} is '{}', expected {}", option, *word, fmt::join(words, " or ")));
}

void check_choices(const ImportChoices& choices) {
    check_word("--datum", choices.datum, {"gauge", "absolute"});
    check_word("--pressure", choices.pressure, {"p", "p_rgh"});
    check_word("--phase", choices.phase, {"water", "two-phase"});
    for (const auto& [option, value] :
         {std::pair("--layer", choices.layer), std::pair("--factor", choices.factor)})
        if (value && (!std::isfinite(*value) || *value == 0 || (option[2] == 'l' && *value < 0)))
            throw InputError(fmt::format("{} is {}, expected a {}number that is not 0", option, *value,
                                         option[2] == 'l' ? "positive " : ""));
    for (const auto* text : {&choices.sign, &choices.code_version, &choices.setup, &choices.scene,
                             &choices.time_origin, &choices.code})
        if (*text && (text->value().empty() || text->value().find('\n') != std::string::npos))
            throw InputError("an option is empty or has several lines, expected one line of text");
}

/// The layer of loads, from the mesh or from the user.
double layer_of(const CodeRecord& record, const ImportChoices& choices) {
    if (record.layer && choices.layer && std::abs(*record.layer / *choices.layer - 1) > 1e-6)
        throw InputError(fmt::format("--layer is {} m, and the mesh of the case is {} m thick",
                                     *choices.layer, *record.layer));
    return choices.layer.value_or(record.layer.value_or(1));
}

Output output_of(const RecordColumn& column, const CodeRecord& record, const ImportChoices& choices,
                 Missing& missing) {
    Output out{&column, {}, 1, 0, {}};
    const std::string unit = !column.unit.empty() ? column.unit : choices.unit.value_or("");
    if (unit.empty()) {
        missing.ask("--unit", fmt::format("of column {}: Pa, N, N/m, m ...", column.name));
        return out;
    }
    if (choices.unit && !column.unit.empty() && !same_dimension(unit_named(*choices.unit), unit_named(unit)))
        throw InputError(
            fmt::format("--unit is {}, and column {} is in {}", *choices.unit, column.name, unit));
    out.unit = unit_named(unit);
    out.factor = out.unit.factor * choices.factor.value_or(1);
    if (is(out.unit, "N") || is(out.unit, "N m")) {
        if (!choices.layer && !record.layer)
            missing.ask("--layer",
                        "thickness of the computed layer in m; 1 where the loads are those of a metre");
        out.factor /= layer_of(record, choices);
        out.unit = out.unit / unit_named("m");
        out.unit_text = is(out.unit, "N/m") ? "N/m" : "";
    } else if (choices.layer && !record.layer) {
        throw InputError(
            fmt::format("--layer divides loads in N or N m, and column {} is in {}", column.name, unit));
    }
    if (out.unit_text.empty()) out.unit_text = out.unit.text == "-" ? "-" : si_name(out.unit.powers);
    if (column.sign.empty() && !choices.sign && out.unit_text != "-")
        missing.ask("--sign", "which direction is positive");
    return out;
}

void take_datum(Output& out, const ImportChoices& choices, Missing& missing) {
    if (!is(out.unit, "Pa")) return;
    if (!choices.datum) missing.ask("--datum", "gauge or absolute");
    if (out.column->name.find("p_rgh") != std::string::npos) {
        if (!choices.pressure)
            missing.ask("--pressure",
                        "p_rgh, to say that this column lacks rho g h; the pressure on a wall is p");
        else if (*choices.pressure != "p_rgh")
            throw InputError(
                fmt::format("--pressure is {}, and column {} is p_rgh", *choices.pressure, out.column->name));
    }
    if (choices.datum.value_or("") == "absolute") {
        if (!choices.reference_pressure)
            missing.ask("--reference-pressure", "in Pa, which is taken off absolute pressures");
        out.offset = -choices.reference_pressure.value_or(0);
    } else if (choices.reference_pressure) {
        throw InputError("--reference-pressure goes with --datum absolute");
    }
}

std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return text;
}

struct Head {
    std::string code, version, phase, setup;
};

Head head_of(const CodeRecord& record, const ImportChoices& choices, Missing& missing) {
    Head head{choices.code.value_or(record.code), choices.code_version.value_or(record.version),
              choices.phase.value_or(record.phase), choices.setup.value_or("")};
    if (choices.scene)
        head.setup = fmt::format("scene {}{}{}", *choices.scene, head.setup.empty() ? "" : ", ", head.setup);
    if (head.code.empty()) missing.ask("--code", "name of the code");
    if (head.version.empty()) missing.ask("--code-version", "version of the code");
    if (head.phase.empty()) missing.ask("--phase", "water or two-phase: whether air was computed");
    if (head.setup.empty()) missing.ask("--setup", "what was computed, or --scene NAME");
    return head;
}

/// Distinct texts of the chosen columns.
template <class Text>
std::string texts_of(const std::vector<Output>& outputs, Text text) {
    std::vector<std::string> all;
    for (const Output& out : outputs)
        if (const std::string found = text(*out.column);
            !found.empty() && std::find(all.begin(), all.end(), found) == all.end())
            all.push_back(found);
    return fmt::format("{}", fmt::join(all, "; "));
}

std::string notes_of(const CodeRecord& record, const ImportChoices& choices, const Head& head,
                     const std::vector<Output>& outputs) {
    std::vector<std::string> notes{head.phase == "water" ? "water alone" : "water and air"};
    for (const Output& out : outputs) {
        const bool load = is(out.unit, "N/m") || is(out.unit, "N");
        if (load && (choices.layer || record.layer))
            notes.push_back(
                fmt::format("{} divided by the layer of {} m", out.column->name, layer_of(record, choices)));
        if (!is(out.unit, "Pa")) continue;
        notes.push_back(out.offset != 0
                            ? fmt::format("{}: absolute less {} Pa", out.column->name, -out.offset)
                            : fmt::format("{}: gauge pressure as computed", out.column->name));
        if (choices.pressure) notes.push_back("pressure is " + *choices.pressure);
    }
    if (choices.factor) notes.push_back(fmt::format("values times {}", *choices.factor));
    notes.insert(notes.end(), record.notes.begin(), record.notes.end());
    return fmt::format("{}", fmt::join(notes, "; "));
}

}  // namespace

std::string imported_curve(const CodeRecord& record, const ImportChoices& choices, const std::string& date) {
    check_choices(choices);
    Missing missing;
    std::vector<Output> outputs;
    for (const RecordColumn* column : chosen(record, choices)) {
        outputs.push_back(output_of(*column, record, choices, missing));
        take_datum(outputs.back(), choices, missing);
    }
    const std::string time_unit =
        record.time_unit.empty() ? choices.time_unit.value_or("") : record.time_unit;
    if (time_unit.empty()) missing.ask("--time-unit", "of the time: s, ms ...");
    const Head head = head_of(record, choices, missing);
    missing.check();
    if (!is(unit_named(time_unit), "s"))
        throw InputError(fmt::format("the time is in {}, expected a unit of time", time_unit));
    const double second = unit_named(time_unit).factor;
    const std::string sensor = texts_of(outputs, [](const RecordColumn& c) { return c.sensor; });
    const std::string sign = texts_of(outputs, [](const RecordColumn& c) { return c.sign; });
    std::string text = fmt::format(
        "# kind: peer-simulation\n# citation: {} {}, {}\n# doi: none\n# figure: none\n# obtained: computed\n"
        "# obtained_from: {}\n# date: {}\n# digitisation_error: none\n# u_data: unknown\n"
        "# u_data_source: files of one computation do not tell the error of its mesh or spacing\n"
        "# sensor: {}\n# filter: none\n# sign: {}\n# time_origin: {}\n# note: {}\n",
        one_line(head.code), one_line(head.version), one_line(head.setup),
        one_line(fmt::format("{}", fmt::join(record.files, ", "))), date,
        sensor.empty() ? texts_of(outputs, [](const RecordColumn& c) { return "column " + c.name; })
                       : one_line(sensor),
        one_line(choices.sign.value_or(sign.empty() ? "a number without direction" : sign)),
        one_line(choices.time_origin.value_or("time 0 of the other code")),
        one_line(notes_of(record, choices, head, outputs)));
    text += "t [s]";
    for (const Output& out : outputs) text += fmt::format(",{} [{}]", out.column->name, out.unit_text);
    text += '\n';
    for (std::size_t row = 0; row < record.time.size(); ++row) {
        text += fmt::format("{:.12g}", record.time[row] * second);
        for (const Output& out : outputs) {
            const double value = out.column->values[row];
            text += std::isnan(value) ? "," : fmt::format(",{:.10g}", value * out.factor + out.offset);
        }
        text += '\n';
    }
    return text;
}

}  // namespace wetdeck

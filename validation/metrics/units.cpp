// SPDX-License-Identifier: BSD-3-Clause
#include "validation/metrics/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>

#include "solver/core/errors.hpp"

namespace wetdeck {
namespace {

constexpr std::array<std::string_view, 4> base_units{"m", "kg", "s", "rad"};

struct NamedPowers {
    const char* name;
    Powers powers;
};

/// The names that results and reference files use; the first of equal powers counts.
constexpr std::array si_names{NamedPowers{"-", {0, 0, 0, 0}},       NamedPowers{"m", {1, 0, 0, 0}},
                              NamedPowers{"m^2", {2, 0, 0, 0}},     NamedPowers{"m^3", {3, 0, 0, 0}},
                              NamedPowers{"s", {0, 0, 1, 0}},       NamedPowers{"Hz", {0, 0, -1, 0}},
                              NamedPowers{"kg", {0, 1, 0, 0}},      NamedPowers{"kg/m", {-1, 1, 0, 0}},
                              NamedPowers{"kg/m^3", {-3, 1, 0, 0}}, NamedPowers{"m/s", {1, 0, -1, 0}},
                              NamedPowers{"m/s^2", {1, 0, -2, 0}},  NamedPowers{"m^2/s", {2, 0, -1, 0}},
                              NamedPowers{"m^3/s", {3, 0, -1, 0}},  NamedPowers{"Pa", {-1, 1, -2, 0}},
                              NamedPowers{"Pa s", {-1, 1, -1, 0}},  NamedPowers{"N", {1, 1, -2, 0}},
                              NamedPowers{"N/m", {0, 1, -2, 0}},    NamedPowers{"N s/m", {0, 1, -1, 0}},
                              NamedPowers{"N s", {1, 1, -1, 0}},    NamedPowers{"J", {2, 1, -2, 0}},
                              NamedPowers{"W/m", {1, 1, -3, 0}},    NamedPowers{"W", {2, 1, -3, 0}},
                              NamedPowers{"rad", {0, 0, 0, 1}},     NamedPowers{"rad/s", {0, 0, -1, 1}},
                              NamedPowers{"rad/s^2", {0, 0, -2, 1}}};

/// What udunits2 would take for something else, or does not know.
const std::map<std::string, std::string>& own_names() {
    static const std::map<std::string, std::string> names{
        {"-", "1"}, {"g", "standard_free_fall"}, {"g0", "standard_free_fall"}};
    return names;
}

/// Units at sea that udunits2 reads as a prefix and a unit (nano-miles, femtometres, thousandths of the
/// weight of water), and tons, of which it means the one of 907 kg.
void refuse_units_at_sea(const std::string& text) {
    static const std::map<std::string, std::string> meant{{"nmi", "nautical_mile in full"},
                                                          {"fm", "fathom in full"},
                                                          {"ton", "t (1000 kg), short_ton or long_ton"},
                                                          {"tons", "t (1000 kg), short_ton or long_ton"},
                                                          {"ton_force", "a force in kN, or in kgf"},
                                                          {"mH2O", "'m H2O' for metres of water, or kPa"}};
    std::string word;
    for (const char c : text + " ") {
        if (std::isalpha(static_cast<unsigned char>(c)) || c == '_' || word == "mH" || word == "mH2") {
            word += c;
            continue;
        }
        if (const auto found = meant.find(word); found != meant.end())
            throw InputError(fmt::format("unknown unit '{}', expected {}", word, found->second));
        word.clear();
    }
}

/// The text with the word "deg", which the library does not know, in full.
std::string with_degrees(std::string text) {
    const auto is_letter = [&](std::size_t at) {
        return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
    };
    for (std::size_t at = 0; (at = text.find("deg", at)) != std::string::npos; at += 3)
        if (!is_letter(at + 3) && (at == 0 || !is_letter(at - 1))) text.insert(at + 3, "ree");
    return text;
}

using UnitHandle = std::unique_ptr<ut_unit, decltype(&ut_free)>;

/// Reads the units of the library once; they live as long as the program.
ut_system* unit_system() {
    static ut_system* const system = [] {
        ut_set_error_message_handler(ut_ignore);
        return ut_read_xml(nullptr);
    }();
    if (system == nullptr)
        throw EnvironmentError(
            "the units of udunits2 cannot be read; install libudunits2-data or set UDUNITS2_XML_PATH");
    return system;
}

/// What a walk through a unit of the library finds.
struct Found {
    double factor = 1;
    Powers powers{};
    std::string problem;  ///< empty if the unit is one of mechanics
};

void add_base(Found& found, const ut_unit* base, int power) {
    const char* const symbol = ut_get_symbol(base, UT_ASCII);
    const auto known =
        std::find(base_units.begin(), base_units.end(), std::string_view(symbol ? symbol : ""));
    if (known == base_units.end())
        found.problem = fmt::format("depends on '{}', expected a unit of mechanics", symbol ? symbol : "?");
    else
        found.powers[static_cast<std::size_t>(known - base_units.begin())] += power;
}

ut_status visit_base(const ut_unit* unit, void* found) {
    add_base(*static_cast<Found*>(found), unit, 1);
    return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* bases, const int* powers,
                        void* found) {
    for (int k = 0; k < count; ++k) add_base(*static_cast<Found*>(found), bases[k], powers[k]);
    return UT_SUCCESS;
}

ut_status visit_scaled(const ut_unit*, double scale, const ut_unit* underlying, double origin, void* found);

ut_status visit_time(const ut_unit*, const ut_unit*, double, void* found) {
    static_cast<Found*>(found)->problem = "counts from a date";
    return UT_SUCCESS;
}

ut_status visit_logarithm(const ut_unit*, double, const ut_unit*, void* found) {
    static_cast<Found*>(found)->problem = "is logarithmic";
    return UT_SUCCESS;
}

constexpr ut_visitor visitor{visit_base, visit_product, visit_scaled, visit_time, visit_logarithm};

ut_status visit_scaled(const ut_unit*, double scale, const ut_unit* underlying, double origin, void* found) {
    Found& all = *static_cast<Found*>(found);
    all.factor *= scale;
    if (origin != 0) all.problem = "has another zero than the SI unit";
    return ut_accept_visitor(underlying, &visitor, found);
}

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw InputError(
        fmt::format("unknown unit '{}'{}, expected -, or a unit such as m, mm, s, ms, Pa, kPa, "
                    "bar, N/m, kN/m, m/s, km/h, m/s^2, g, rad, deg, l/min",
                    text, why.empty() ? why : fmt::format(" ({})", why)));
}

/// A number in front of a unit, or alone, is more often a slip than a unit; "1" and "1/s" are none.
bool has_number_in_front(const std::string& text) {
    if (text == "1" || text.starts_with("1/")) return false;
    return text.find_first_of("0123456789.+") == 0;
}

Unit parsed(const std::string& text) {
    static std::mutex one_at_a_time;  // the parser of the library is not reentrant
    const std::lock_guard lock(one_at_a_time);
    if (text.empty() || has_number_in_front(text)) refuse(text, "");
    const auto own = own_names().find(text);
    const std::string name = own == own_names().end() ? with_degrees(text) : own->second;
    ut_system* const system = unit_system();
    const UnitHandle unit(ut_parse(system, name.c_str(), UT_UTF8), &ut_free);
    if (!unit) refuse(text, "");
    Found found;
    ut_accept_visitor(unit.get(), &visitor, &found);
    if (!found.problem.empty()) refuse(text, found.problem);
    return {text, found.factor, found.powers};
}

}  // namespace

Unit unit_named(const std::string& text) {
    for (const NamedPowers& known : si_names)
        if (text == known.name) return {text, 1, known.powers};
    refuse_units_at_sea(text);
    return parsed(text);
}

std::string si_name(const Powers& powers) {
    for (const NamedPowers& known : si_names)
        if (known.powers == powers) return known.name;
    std::string name;
    for (std::size_t k = 0; k < powers.size(); ++k) {
        if (powers[k] == 0) continue;
        name += fmt::format("{}{}", name.empty() ? "" : " ", base_units[k]);
        if (powers[k] != 1) name += fmt::format("^{}", powers[k]);
    }
    return name;
}

bool same_dimension(const Unit& a, const Unit& b) {
    return a.powers == b.powers;
}

bool is_length(const std::string& text) {
    try {
        return same_dimension(unit_named(text), unit_named("m"));
    } catch (const InputError&) {
        return false;
    }
}

namespace {

Unit combined(const Unit& a, const Unit& b, int sign) {
    Unit unit{"", sign > 0 ? a.factor * b.factor : a.factor / b.factor, a.powers};
    for (std::size_t k = 0; k < unit.powers.size(); ++k) unit.powers[k] += sign * b.powers[k];
    unit.text = si_name(unit.powers);
    return unit;
}

}  // namespace

Unit operator*(const Unit& a, const Unit& b) {
    return combined(a, b, 1);
}

Unit operator/(const Unit& a, const Unit& b) {
    return combined(a, b, -1);
}

}  // namespace wetdeck

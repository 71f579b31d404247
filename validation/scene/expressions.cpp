// SPDX-License-Identifier: BSD-3-Clause
#include "validation/scene/expressions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <tuple>
#include <variant>

#include "solver/core/errors.hpp"
#include "solver/probes/pressure.hpp"
#include "validation/analytic/heeled_wedge.hpp"
#include "validation/analytic/wedge_similarity.hpp"
#include "validation/metrics/resample.hpp"
#include "validation/store/text_table.hpp"

namespace wetdeck {
namespace {

/// Solutions are kept: a scene is read many times, and each takes up to a second.
template <class Solution, class... Inputs>
const Solution& kept(Solution (*solve)(Inputs...), Inputs... inputs) {
    static std::mutex mutex;
    static std::map<std::tuple<Inputs...>, Solution> known;
    const std::lock_guard lock(mutex);
    const std::tuple<Inputs...> key(inputs...);
    const auto found = known.find(key);
    return found != known.end() ? found->second : known.emplace(key, solve(inputs...)).first->second;
}

HeeledWedge heeled(double left, double right, double horizontal) {
    return heeled_wedge({left, right, horizontal});
}

double wedge_force(double deadrise) {
    return kept(wedge_similarity, deadrise).force_coefficient;
}
double wedge_peak_pressure(double deadrise) {
    return kept(wedge_similarity, deadrise).maximum_pressure;
}
double wedge_chine_depth(double deadrise, double half_beam) {
    return chine_wetting_penetration(kept(wedge_similarity, deadrise), half_beam);
}
/// @param length  of the patch over V t
double wedge_patch_pressure(double deadrise, double length) {
    const WedgeSimilarity& wedge = kept(wedge_similarity, deadrise);
    constexpr int parts = 4000;
    const double face = (wedge.tip_z + 1) / std::sin(deadrise);  // from the apex to the tip, over V t
    if (!(length > 0)) throw InputError(fmt::format("a patch of the length {:.6g}", length));
    if (length >= face)  // water at rest, as it were, beyond the tip
        return wedge.force_coefficient / std::cos(deadrise) / length;
    std::vector<double> pressures;
    for (int k = 0; k < parts; ++k)
        pressures.push_back(interpolate(wedge.pressure, -1 + (wedge.tip_z + 1) * (k + 0.5) / parts));
    return largest_mean(pressures, std::max(1.0, parts * length / face));
}
double heeled_lift(double left, double right, double horizontal) {
    return kept(heeled, left, right, horizontal).force_y;
}
double heeled_side_force(double left, double right, double horizontal) {
    return kept(heeled, left, right, horizontal).force_x;
}
double heeled_moment(double left, double right, double horizontal) {
    return kept(heeled, left, right, horizontal).moment;
}
double smaller(double a, double b) {
    return std::min(a, b);
}
double larger(double a, double b) {
    return std::max(a, b);
}

using One = double (*)(double);
using Two = double (*)(double, double);
using Three = double (*)(double, double, double);

struct Function {
    ExpressionFunction described;
    std::variant<One, Two, Three> value;

    template <class Value>
    Function(const char* name, Value function, const char* meaning)
        : described{name, static_cast<int>(std::variant<One, Two, Three>(function).index()) + 1, meaning},
          value(function) {}
};

/// All functions: a new one is a row.
const std::vector<Function>& functions() {
    static const std::vector<Function> all = {
        {"sin", One(std::sin), "sine of an angle in rad"},
        {"cos", One(std::cos), "cosine"},
        {"tan", One(std::tan), "tangent"},
        {"asin", One(std::asin), "arc sine [rad]"},
        {"acos", One(std::acos), "arc cosine [rad]"},
        {"atan", One(std::atan), "arc tangent [rad]"},
        {"sqrt", One(std::sqrt), "square root"},
        {"exp", One(std::exp), "exponential"},
        {"ln", One(std::log), "natural logarithm"},
        {"log10", One(std::log10), "decimal logarithm"},
        {"abs", One(std::fabs), "absolute value"},
        {"floor", One(std::floor), "largest whole number that is not above"},
        {"ceil", One(std::ceil), "smallest whole number that is not below"},
        {"min", smaller, "the smaller of two"},
        {"max", larger, "the larger of two"},
        {"wedge_force", wedge_force,
         "F/(rho V^3 t) of a wedge of this deadrise [rad] at constant speed V, exact similarity solution"},
        {"wedge_peak_pressure", wedge_peak_pressure, "largest pressure on its faces over rho V^2/2"},
        {"wedge_patch_pressure", wedge_patch_pressure,
         "largest mean pressure over a patch of a face over rho V^2/2; the second number is the length of "
         "the "
         "patch over V t"},
        {"wedge_chine_depth", wedge_chine_depth,
         "penetration [m] at which its pressure peak reaches a chine at this half beam [m]"},
        {"heeled_lift", heeled_lift,
         "F_y/(rho V^3 t) of a wedge whose left and right faces make these angles [rad] with the water, and "
         "that moves to the right with the third number times V"},
        {"heeled_side_force", heeled_side_force, "F_x/(rho V^3 t) of the same"},
        {"heeled_moment", heeled_moment, "moment about its keel over rho V^4 t^2"}};
    return all;
}

bool is_name(const std::string& name) {
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) &&
           std::all_of(name.begin(), name.end(),
                       [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
}

/// What stands behind the "=".
std::string formula_of(const std::string& expression) {
    return std::string(trimmed(std::string_view(expression).substr(expression.find('=') + 1)));
}

}  // namespace

bool is_expression(std::string_view text) {
    return trimmed(text).starts_with('=');
}

const std::vector<ExpressionFunction>& expression_functions() {
    static const std::vector<ExpressionFunction> described = [] {
        std::vector<ExpressionFunction> all;
        for (const Function& each : functions()) all.push_back(each.described);
        return all;
    }();
    return described;
}

struct Expressions::Parser {
    mu::Parser formulas;

    Parser() {
        formulas.ClearFun();
        formulas.ClearConst();
        formulas.DefineConst("pi", std::numbers::pi);
        for (const Function& each : functions())
            std::visit([&](auto function) { formulas.DefineFun(each.described.name, function); }, each.value);
    }

    /// Names in a formula that are known or not.
    std::set<std::string> names_in(const std::string& formula) {
        std::set<std::string> names;
        formulas.SetExpr(formula);
        for (const auto& entry : formulas.GetUsedVar()) names.insert(entry.first);
        return names;
    }
};

Expressions::Expressions() : parser_(std::make_unique<Parser>()) {}
Expressions::~Expressions() = default;
Expressions::Expressions(Expressions&&) noexcept = default;

void Expressions::define(const std::string& name, double value) {
    if (!is_name(name))
        throw InputError(fmt::format("'{}' is no name, expected letters, digits and _", name));
    const std::vector<ExpressionFunction>& functions = expression_functions();
    if (name == "pi" || parameters_.contains(name) ||
        std::any_of(functions.begin(), functions.end(),
                    [&name](const ExpressionFunction& f) { return f.name == name; }))
        throw InputError(fmt::format("the name '{}' is taken", name));
    parser_->formulas.DefineVar(name, &(parameters_[name] = value));
}

std::set<std::string> Expressions::unknown_names(const std::string& expression) const {
    try {
        std::set<std::string> names = parser_->names_in(formula_of(expression));
        for (const auto& [name, value] : parameters_) names.erase(name);
        return names;
    } catch (const mu::Parser::exception_type& error) {
        throw InputError(fmt::format("is '{}': {}", expression, error.GetMsg()));
    }
}

double Expressions::value(const std::string& expression) const {
    const std::set<std::string> unknown = unknown_names(expression);
    if (!unknown.empty()) {
        std::vector<std::string> known;
        for (const auto& [name, value] : parameters_) known.push_back(name);
        throw InputError(
            fmt::format("is '{}' with the unknown name '{}', expected {}", expression, *unknown.begin(),
                        known.empty() ? "a table [parameters] that defines it"
                                      : fmt::format("one of [parameters]: {}", fmt::join(known, ", "))));
    }
    try {
        for (const std::string& name : parser_->names_in(formula_of(expression))) used_.insert(name);
        int results = 0;
        const double number = *parser_->formulas.Eval(results);
        if (results != 1)
            throw InputError(fmt::format(
                "is '{}', which has a comma outside a function: expected one number with a decimal point",
                expression));
        if (!std::isfinite(number)) throw InputError(fmt::format("is '{}', which is not finite", expression));
        return number;
    } catch (const mu::Parser::exception_type& error) {
        throw InputError(fmt::format("is '{}': {}", expression, error.GetMsg()));
    }
}

std::string Expressions::filled(const std::string& text) const {
    std::string result;
    std::size_t from = 0;
    for (std::size_t open = text.find("{="); open != std::string::npos; open = text.find("{=", from)) {
        const std::size_t close = text.find('}', open);
        if (close == std::string::npos)
            throw InputError(fmt::format("is '{}', in which '{{=' has no '}}'", text));
        result += text.substr(from, open - from);
        result += fmt::format("{:.10g}", value(text.substr(open + 1, close - open - 1)));
        from = close + 1;
    }
    return result + text.substr(from);
}

std::vector<std::string> Expressions::unused() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : parameters_)
        if (!used_.contains(name)) names.push_back(name);
    return names;
}

}  // namespace wetdeck

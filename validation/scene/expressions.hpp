// SPDX-License-Identifier: BSD-3-Clause
// Numbers that follow from others: a text of a scene file that begins with "=" is an expression in the
// parameters of the scene, "= 12*pi*speed/(2*tan(deadrise))". The library muparser evaluates it.
//
// muparser 2.3.3 takes "1,5" for two results and hands out the last one, 5, and calls the natural logarithm
// `log`: here the first is refused and only `ln` and `log10` are known.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wetdeck {

/// Whether a text is an expression: its first letter other than a blank is "=".
bool is_expression(std::string_view text);

/// A function that expressions may call, for the documentation.
struct ExpressionFunction {
    const char* name;
    int arguments;
    const char* meaning;
};
const std::vector<ExpressionFunction>& expression_functions();

class Expressions {
  public:
    Expressions();
    ~Expressions();
    Expressions(Expressions&&) noexcept;

    /// Makes a number known by a name. Throws InputError for a name that is taken or is none of letters,
    /// digits and _.
    void define(const std::string& name, double value);
    const std::map<std::string, double>& parameters() const { return parameters_; }

    /// The number that an expression, "=" included, stands for, in SI units and rad. Throws InputError for
    /// one that cannot be read, has an unknown name, or is not finite.
    double value(const std::string& expression) const;
    /// Names in the expression that are no functions, constants or parameters.
    std::set<std::string> unknown_names(const std::string& expression) const;
    /// The text with every "{= EXPRESSION}" in it replaced by its number.
    std::string filled(const std::string& text) const;
    /// Parameters that no expression has used so far.
    std::vector<std::string> unused() const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
    std::map<std::string, double> parameters_;
    mutable std::set<std::string> used_;
};

}  // namespace wetdeck

// SPDX-License-Identifier: MIT
#include "scene/model/expressions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/formula_text.h"
#include "freshet/real.h"

#ifdef FRESHET_MUPARSER
#include <muParser.h>
#endif

namespace freshet {

std::optional<std::string> not_finite(const std::vector<std::string>& functions,
                                      const std::string& key, const double (&x)[3],
                                      std::optional<double> t, const double* values,
                                      int dimension) {
  const std::size_t n = functions.size(), axes = dimension > 0 ? std::size_t(dimension) : n;
  const auto finite = [](double a) { return std::isfinite(Real(a)); };
  if (!std::all_of(x, x + axes, finite)) return {};
  const double* bad = std::find_if_not(values, values + n, finite);
  if (bad == values + n) return {};
  return fmt::format("{} is {} at ({:.4g}){} in {}; fix the function", key,
                     std::isnan(*bad) ? "NaN" : "infinite", fmt::join(x, x + axes, ", "),
                     t ? fmt::format(", {:.6g} s,", *t) : "",
                     quoted_formula(functions[std::size_t(bad - values)]));
}

#ifdef FRESHET_MUPARSER

struct Expressions::Parsers {
  double x[3] = {}, t = 0;
  std::vector<mu::Parser> all;
  bool depends_on_place = false, depends_on_time = false;

  Parsers(const std::vector<std::string>& functions, std::string_view variables)
      : all(functions.size()) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (const char name : variables)
        all[k].DefineVar(std::string(1, name), name == 't' ? &t : &x[name - 'x']);
      all[k].DefineConst("pi", std::numbers::pi);
      all[k].SetExpr(functions[k]);
    }
  }
  /// Sets depends_on_place. Throws if a function is invalid.
  void look() {
    for (mu::Parser& parser : all)
      for (const auto& [name, place] : parser.GetUsedVar())
        (name == "t" ? depends_on_time : depends_on_place) = true;
  }
};

namespace {

std::string_view variables_of(const std::vector<std::string>& functions,
                              std::string_view variables) {
  static constexpr std::string_view of_axes[] = {"t", "xt", "xyt", "xyzt"};
  return variables.empty() ? of_axes[std::min<std::size_t>(functions.size(), 3)] : variables;
}

/// "xyt" as "x, y and t"
std::string listed(std::string_view variables) {
  std::string list(variables.substr(0, 1));
  for (std::size_t k = 1; k < variables.size(); ++k)
    list += (k + 1 == variables.size() ? " and " : ", ") + std::string(1, variables[k]);
  return list;
}

}  // namespace

bool reads_expressions() { return true; }

std::optional<std::string> fault_in(const std::vector<std::string>& functions,
                                    std::string_view variables) {
  variables = variables_of(functions, variables);
  for (const std::string& function : functions)
    if (const std::string why = formula_error(function); !why.empty()) return why;
  Expressions::Parsers parsers(functions, variables);
  for (std::size_t k = 0; k < functions.size(); ++k) try {
      int values = 0;
      parsers.all[k].Eval(values);
      if (values != 1) return values_error(functions[k], values);
    } catch (const mu::Parser::exception_type& e) {
      std::string why = e.GetMsg();
      why.erase(why.find_last_not_of(" .\n") + 1);
      return fmt::format(
          "has an error in {}: {}; write a function of {} with numbers, pi, + - * / ^ and "
          "functions such as sin, cos, exp, sqrt, min, max",
          quoted_formula(functions[k]), shortened(why, 160), listed(variables));
    }
  return {};
}

Expressions::Expressions(const std::vector<std::string>& functions, std::string_view variables)
    : parsers_(std::make_unique<Parsers>(functions, variables_of(functions, variables))) {
  parsers_->look();
}
bool Expressions::empty() const { return parsers_->all.empty(); }
bool Expressions::depends_on_place() const { return parsers_->depends_on_place; }
bool Expressions::depends_on_time() const { return parsers_->depends_on_time; }
void Expressions::operator()(const double (&x)[3], double t, double* values) {
  std::copy(x, x + 3, parsers_->x);
  parsers_->t = t;
  for (mu::Parser& parser : parsers_->all) *values++ = parser.Eval();
}

#else

struct Expressions::Parsers {};

bool reads_expressions() { return false; }

std::optional<std::string> fault_in(const std::vector<std::string>&, std::string_view) {
  return "is a function, which needs muParser, and this Freshet was built without it; install "
         "libmuparser-dev and rebuild";
}

Expressions::Expressions(const std::vector<std::string>&, std::string_view) {}
bool Expressions::empty() const { return true; }
bool Expressions::depends_on_place() const { return false; }
bool Expressions::depends_on_time() const { return false; }
void Expressions::operator()(const double (&)[3], double, double*) {}

#endif

Expressions::Expressions(Expressions&&) noexcept = default;
Expressions::~Expressions() = default;

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/model/expressions.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#ifdef FRESHET_MUPARSER
#include <muParser.h>
#endif

namespace freshet {

#ifdef FRESHET_MUPARSER

struct Expressions::Parsers {
  double x[3] = {}, t = 0;
  std::vector<mu::Parser> all;
  bool depends_on_place = false;

  explicit Parsers(const std::vector<std::string>& functions) : all(functions.size()) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (std::size_t j = 0; j < all.size(); ++j) all[k].DefineVar(axes[j], &x[j]);
      all[k].DefineVar("t", &t);
      all[k].DefineConst("pi", std::numbers::pi);
      all[k].SetExpr(functions[k]);
    }
  }
  /// Sets depends_on_place. Throws if a function is invalid.
  void look() {
    for (mu::Parser& parser : all)
      for (const auto& [name, place] : parser.GetUsedVar()) depends_on_place |= name != "t";
  }
};

bool reads_expressions() { return true; }

std::optional<std::string> fault_in(const std::vector<std::string>& functions) {
  Expressions::Parsers parsers(functions);
  for (std::size_t k = 0; k < functions.size(); ++k) try {
      parsers.all[k].Eval();
    } catch (const mu::Parser::exception_type& e) {
      std::string why = e.GetMsg();
      why.erase(why.find_last_not_of(" .\n") + 1);
      return fmt::format(
          "has an error in \"{}\": {}; write a function of {} and t with numbers, pi, + - * / ^ "
          "and functions such as sin, cos, exp, sqrt, min, max",
          functions[k], why, functions.size() == 3 ? "x, y, z" : "x, y");
    }
  return {};
}

Expressions::Expressions(const std::vector<std::string>& functions)
    : parsers_(std::make_unique<Parsers>(functions)) {
  parsers_->look();
}
bool Expressions::empty() const { return parsers_->all.empty(); }
bool Expressions::depends_on_place() const { return parsers_->depends_on_place; }
void Expressions::operator()(const double (&x)[3], double t, double* values) {
  std::copy(x, x + 3, parsers_->x);
  parsers_->t = t;
  for (mu::Parser& parser : parsers_->all) *values++ = parser.Eval();
}

#else

struct Expressions::Parsers {};

bool reads_expressions() { return false; }

std::optional<std::string> fault_in(const std::vector<std::string>&) {
  return "is a function, which needs muParser, and this Freshet was built without it; install "
         "libmuparser-dev and rebuild";
}

Expressions::Expressions(const std::vector<std::string>&) {}
bool Expressions::empty() const { return true; }
bool Expressions::depends_on_place() const { return false; }
void Expressions::operator()(const double (&)[3], double, double*) {}

#endif

Expressions::Expressions(Expressions&&) noexcept = default;
Expressions::~Expressions() = default;

}  // namespace freshet

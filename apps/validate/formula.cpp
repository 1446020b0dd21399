// SPDX-License-Identifier: MIT
#include "validate/formula.h"

#include <fmt/format.h>

#include <cctype>
#include <numbers>

#include "core/formula_text.h"
#include "freshet/error.h"

#ifdef FRESHET_MUPARSER
#include <muParser.h>
#endif

namespace freshet {

namespace {

bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

}  // namespace

std::string variable_of(const std::string& column) {
  std::string name = column;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && !is_beyond_ascii(c)) c = '_';
  return name;
}

#ifdef FRESHET_MUPARSER

namespace {

/// The characters of variables: those of muParser, and letters of any alphabet in UTF-8.
std::string name_characters(const mu::Parser& parser) {
  std::string all = parser.ValidNameChars();
  for (int byte = 0x80; byte <= 0xFF; ++byte) all += static_cast<char>(byte);
  return all;
}

}  // namespace

std::vector<double> evaluate(const std::string& formula, const Table& table,
                             const std::string& place) {
  const auto fail = [&](const std::string& why) {
    throw Error(Error::Kind::scene, place, "the formula " + why);
  };
  if (const std::string why = formula_error(formula); !why.empty()) fail(why);
  mu::Parser parser;
  parser.DefineNameChars(name_characters(parser).c_str());
  parser.DefineConst("pi", std::numbers::pi);
  std::vector<const Column*> columns;
  std::string names;
  for (const Column& c : table.columns) {
    if (c.of_words()) continue;
    columns.push_back(&c);
    names += (names.empty() ? "" : ", ") + variable_of(c.name);
  }
  std::vector<double> row(columns.size()), values;
  for (std::size_t k = 0; k < columns.size(); ++k)
    parser.DefineVar(variable_of(columns[k]->name), &row[k]);
  try {
    parser.SetExpr(formula);
    for (std::size_t i = 0; i < table.rows; ++i) {
      for (std::size_t k = 0; k < columns.size(); ++k) row[k] = columns[k]->numbers[i];
      int count = 0;
      values.push_back(*parser.Eval(count));
      if (count != 1) fail(values_error(formula, count));
    }
  } catch (const mu::Parser::exception_type& e) {
    throw Error(Error::Kind::scene, place,
                fmt::format("cannot parse the formula {}: {}; it may use {}, pi and the usual "
                            "functions",
                            quoted_formula(formula), shortened(e.GetMsg(), 160), names));
  }
  return values;
}

#else

std::vector<double> evaluate(const std::string&, const Table&, const std::string& place) {
  throw Error(Error::Kind::scene, place,
              "formulas need muParser, and this Freshet was built without it; install "
              "libmuparser-dev and build again");
}

#endif

std::vector<double> evaluate(const std::string& formula, const std::string& variable,
                             const std::vector<double>& values, const std::string& place) {
  return evaluate(formula, Table{{Column{variable, "", values, {}}}, values.size()}, place);
}

}  // namespace freshet

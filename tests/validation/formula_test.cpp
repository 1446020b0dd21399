// SPDX-License-Identifier: MIT
#include "validate/formula.h"

#include <gtest/gtest.h>

#include "freshet/error.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

std::string error_of(const std::string& formula) {
  try {
    evaluate(formula, "x", {1, 2}, "case.toml");
    return "no error";
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(Formula, IsEvaluatedForEachRow) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  EXPECT_EQ((std::vector<double>{2, 4}), evaluate("max(x, 0) + x", "x", {1, 2}, "case.toml"));
  EXPECT_EQ((std::vector<double>{1, 0}), evaluate("x == 1 || x >= 3", "x", {1, 2}, "case.toml"));
}

TEST(Formula, ReadsColumnsWithLettersOfAnyAlphabet) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  Table table;
  table.rows = 2;
  table.columns = {{"force on 水 x", "N/m", {1, 2}, {}}, {"force on 火 x", "N/m", {4, 8}, {}}};
  EXPECT_EQ((std::vector<double>{3, 6}),
            evaluate("force_on_火_x - force_on_水_x", table, "case.toml"));
}

TEST(Formula, HasOneValueAndNoAssignment) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  EXPECT_EQ(
      "case.toml: error: the formula has 2 values in \"1,5\"; exactly one is allowed: write "
      "decimals "
      "with a point, such as 1.5, and commas only between the arguments of a function",
      error_of("1,5"));
  EXPECT_EQ(
      "case.toml: error: the formula has an assignment in \"x=5\"; remove it, or compare two "
      "values "
      "with ==",
      error_of("x=5"));
  EXPECT_EQ("case.toml: error: the formula is 40001 characters long in \"1" + std::string(79, '0') +
                "...\"; at most 4096 are allowed; shorten it",
            error_of("1" + std::string(40000, '0')));
}

TEST(Formula, OfManyParenthesesIsReadOrRejected) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  EXPECT_EQ("no error", error_of(std::string(2000, '(') + "x" + std::string(2000, ')')));
  EXPECT_LT(error_of(std::string(4000, '(')).size(), 500u);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include "run/interval.h"

#include <gtest/gtest.h>

#include <limits>

namespace freshet::test {
namespace {

TEST(Interval, HasTheExtremesTheMeanAndTheIntegralOfItsSteps) {
  IntervalRecord interval;
  include(interval, {3, -1}, 0.5);
  include(interval, {33, -2}, 0.1);  // a peak
  include(interval, {3, std::numeric_limits<double>::quiet_NaN()}, 0.4);
  EXPECT_EQ(",3,33,6,6", interval_cells(interval, 0, 1));
  EXPECT_EQ(",-2,-1,-1.16666667,-0.7", interval_cells(interval, 1, 1));
}

TEST(Interval, WithoutAValueIsNaN) {
  IntervalRecord interval;
  EXPECT_EQ(",nan,nan,nan,nan", interval_cells(interval, 0, 1));
  include(interval, {std::numeric_limits<double>::quiet_NaN()}, 0.5);
  EXPECT_EQ(",nan,nan,nan,nan", interval_cells(interval, 0, 1));
}

TEST(Interval, NamesItsColumns) {
  EXPECT_EQ(",p min [Pa],p max [Pa],p mean [Pa],p integral [Pa s]", interval_columns("p", "Pa"));
  EXPECT_TRUE(interval_columns("f", "N/m").ends_with(",f integral [N s/m]"));
  EXPECT_TRUE(interval_columns("u", "m/s").ends_with(",u integral [m]"));
  EXPECT_EQ(",f min,f max,f mean,f integral [s]", interval_columns("f", ""));
  EXPECT_EQ(",\"a,b min [N]\",\"a,b max [N]\",\"a,b mean [N]\",\"a,b integral [N s]\"",
            interval_columns("a,b", "N"));
}

}  // namespace
}  // namespace freshet::test

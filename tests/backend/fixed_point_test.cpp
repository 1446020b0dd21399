// SPDX-License-Identifier: MIT
#include "backend/fixed_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace freshet {
namespace {

double sum(const std::vector<double>& values) {
  double largest = 0;
  for (const double v : values) largest = std::max(largest, std::abs(v));
  const FixedPoint fixed(largest, std::int64_t(values.size()));
  std::int64_t total = 0;
  for (const double v : values) total += fixed.whole(v);
  return fixed.value(total);
}

TEST(FixedPoint, SumDoesNotDependOnTheOrder) {
  std::mt19937 generator(3);
  std::normal_distribution<double> any(0, 1e3);
  std::vector<double> values(10000);
  for (double& v : values) v = any(generator);
  const double forwards = sum(values);
  for (int k = 0; k < 5; ++k) {
    std::shuffle(values.begin(), values.end(), generator);
    EXPECT_EQ(forwards, sum(values));
  }
  double plain = 0;
  for (const double v : values) plain += v;
  EXPECT_NEAR(plain, forwards, 1e-7);
}

TEST(FixedPoint, LargestNumbersDoNotOverflow) {
  for (const double largest : {1.0, 1.999, 1e300, 1e-300}) {
    const std::vector<double> values(1000, largest);
    EXPECT_NEAR(1, sum(values) / (1000 * largest), 1e-12);
  }
}

TEST(FixedPoint, InfinityGivesNanAndAnEmptySumIsZero) {
  EXPECT_TRUE(std::isnan(sum({1, INFINITY})));
  EXPECT_EQ(0, sum({}));
}

}  // namespace
}  // namespace freshet

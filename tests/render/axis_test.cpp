// SPDX-License-Identifier: MIT
#include "render/axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

using Labels = std::vector<std::string>;

void expect_range(double min, double max, const std::vector<double>& numbers) {
  const Range r = range_of(numbers);
  EXPECT_DOUBLE_EQ(min, r.min);
  EXPECT_DOUBLE_EQ(max, r.max);
}

TEST(Range, IncludesAllFiniteNumbersAndANearbyZero) {
  expect_range(-2, 3, {3, -2, 1});
  expect_range(0, 3, {1, 3});
  expect_range(-3, 0, {-1, -3});
  expect_range(2, 3, {2, 3});
  expect_range(2, 3, {NAN, 2, INFINITY, 3, -INFINITY});
}

TEST(Range, IsNeverEmpty) {
  expect_range(0, 1, {});
  expect_range(0, 1, {NAN});
  expect_range(0, 1, {0, 0});
  expect_range(0.9, 1.1, {1});
  expect_range(-11, -9, {-10, -10});
}

TEST(Range, MarginDoesNotCrossZero) {
  EXPECT_EQ(0, with_margin({0, 10}).min);
  EXPECT_DOUBLE_EQ(10.5, with_margin({0, 10}).max);
  EXPECT_DOUBLE_EQ(-2.25, with_margin({-2, 3}).min);
  EXPECT_EQ(0, with_margin({-2, 0}).max);
}

TEST(Ticks, AreRoundNumbersInTheRange) {
  EXPECT_EQ((Labels{"0", "1", "2", "3"}), ticks_of({0, 3.1}, 5).labels);
  EXPECT_EQ((Labels{"0.0", "0.5", "1.0", "1.5", "2.0"}), ticks_of({0, 2.25}, 5).labels);
  EXPECT_EQ((Labels{"−4", "−2", "0", "2"}), ticks_of({-5, 3}, 5).labels);
  const Ticks ticks = ticks_of({0.1, 0.3}, 5);
  EXPECT_EQ((Labels{"0.10", "0.15", "0.20", "0.25", "0.30"}), ticks.labels);
  ASSERT_EQ(5u, ticks.values.size());
  EXPECT_NEAR(0.15, ticks.values[1], 1e-15);
}

TEST(Ticks, HaveAFactorIfNumbersAreLargeOrSmall) {
  const auto expect = [](const Range& range, const char* factor, const Labels& labels) {
    const Ticks ticks = ticks_of(range, 5);
    EXPECT_EQ(factor, ticks.factor);
    EXPECT_EQ(labels, ticks.labels);
  };
  expect({0, 21000}, "10³", {"0", "5", "10", "15", "20"});
  expect({0, 9000}, "", {"0", "2000", "4000", "6000", "8000"});
  expect({0, 0.00042}, "10⁻⁶", {"0", "100", "200", "300", "400"});
  expect({-3e13, 3e13}, "10¹²", {"−20", "0", "20"});
  expect({0, 0.02}, "", {"0.000", "0.005", "0.010", "0.015", "0.020"});
}

TEST(Label, ContainsItsFactor) {
  EXPECT_EQ("force [N]", with_factor("force [N]", ""));
  EXPECT_EQ("force on wall[1] [10³ N]", with_factor("force on wall[1] [N]", "10³"));
  EXPECT_EQ("count [10³]", with_factor("count", "10³"));
}

TEST(PlacesSeen, KeepAllOfAFewPoints) {
  EXPECT_EQ((std::vector<std::size_t>{0, 1, 2}), places_seen({0, 10, 20}, {5, NAN, 6}));
  EXPECT_TRUE(places_seen({}, {}).empty());
}

// A million points are thinned to fewer than 1000. A peak, a dip, a gap (NaN) and both ends must
// stay.
TEST(PlacesSeen, KeepPeaksGapsAndEnds) {
  std::vector<double> x, y;
  for (int k = 0; k < 1000000; ++k) {
    x.push_back(k * 1e-4);
    y.push_back(std::sin(k * 0.1));
  }
  y[123456] = 7;
  y[654321] = -7;
  y[777777] = NAN;
  const auto places = places_seen(x, y);
  EXPECT_LT(places.size(), 1000u);
  EXPECT_GT(places.size(), 400u);
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  for (const std::size_t place : {0, 123456, 654321, 777777, 999999})
    EXPECT_TRUE(std::binary_search(places.begin(), places.end(), place)) << place;
}

TEST(Axis, TitleHasTheUnitWithRaisedExponents) {
  EXPECT_EQ("density [kg/m³]", axis_title("density", "kg/m^3"));
  EXPECT_EQ("step", axis_title("step", ""));
  EXPECT_EQ("[m²/s]", axis_title("", "m^2/s"));
}

}  // namespace
}  // namespace freshet

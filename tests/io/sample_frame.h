// SPDX-License-Identifier: MIT
/// A frame for tests of data files, and a comparison of frames.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "freshet/frame.h"

namespace freshet::test {

/// The fields have different values.
inline Frame sample_frame(int dimension, std::size_t n, std::uint64_t first_id = 0) {
  Frame f;
  f.dimension = dimension;
  f.step = 1234;
  f.time = 0.1;  // not representable as a float
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < dimension; ++k) {
      const float a = float(3 * i + std::size_t(k));
      f.x.push_back(0.1f * a);
      f.v.push_back(std::sin(a));
    }
    f.density.push_back(1000.0f + 0.3f * float(i));
    f.pressure.push_back(-7.0f * float(i) + 0.001f);
    f.id.push_back(first_id + 2 * i);
  }
  return f;
}

inline void expect_same(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.dimension, b.dimension);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.pressure, b.pressure);
}

}  // namespace freshet::test

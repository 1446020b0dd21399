// SPDX-License-Identifier: MIT
#include "backend/copies.h"

#include <gtest/gtest.h>

#include <array>

namespace freshet {
namespace {

/// At most 64 particles and copies.
template <int D> struct Few {
  std::array<std::uint64_t, 64> id{};
  std::array<Vec<D>, 64> x{}, v{};
  Particles<D> particles(int n) {
    Particles<D> p;
    p.n = n;
    p.id.data = id.data(), p.x.data = x.data(), p.v.data = v.data();
    return p;
  }
};

CopyRule<2> mirror(Vec<2> point, Vec<2> normal, int axis, bool no_slip = false) {
  return {point, normal, {0, 0}, true, no_slip, axis};
}

TEST(Copies, MirrorAtEachSideAndInTheCorner) {
  Few<2> few;
  auto p = few.particles(2);
  few.x[0] = {0.1f, 0.2f};
  few.v[0] = {1, 2};
  few.x[1] = {5, 5};
  Copies<2> copies({mirror({0, 0}, {1, 0}, 0), mirror({0, 0}, {0, 1}, 1)});
  copies.make(p, 1);
  copies.place(p);
  ASSERT_EQ(3, p.copies);  // beyond each side, and beyond the corner
  const float x[3][2] = {{-0.1f, 0.2f}, {0.1f, -0.2f}, {-0.1f, -0.2f}};
  const float v[3][2] = {{-1, 2}, {1, -2}, {-1, -2}};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(x[k][0], few.x[std::size_t(2 + k)].x);
    EXPECT_EQ(x[k][1], few.x[std::size_t(2 + k)].y);
    EXPECT_EQ(v[k][0], few.v[std::size_t(2 + k)].x);
    EXPECT_EQ(v[k][1], few.v[std::size_t(2 + k)].y);
  }
  EXPECT_TRUE(copies.due_to(2, 0));  // the corner's image counts for the first side
  EXPECT_FALSE(copies.due_to(2, 1));
}

TEST(Copies, NoSlipNegatesVelocitiesAndMirrorsOtherVectors) {
  Few<2> few;
  auto p = few.particles(1);
  few.x[0] = {0.1f, 0};
  few.v[0] = {1, 2};
  std::array<Vec<2>, 64> gradient{};
  gradient[0] = {3, 4};
  Copies<2> copies({mirror({0, 0}, {1, 0}, 0, true)});
  copies.make(p, 1);
  copies.place(p);
  copies.share(p, Field<Vec<2>>{gradient.data()});
  EXPECT_EQ(-1, few.v[1].x);
  EXPECT_EQ(-2, few.v[1].y);
  EXPECT_EQ(-3, gradient[1].x);
  EXPECT_EQ(4, gradient[1].y);
}

TEST(Copies, PeriodicEndsMakeOneImageEach) {
  Few<3> few;
  auto p = few.particles(2);
  few.x[0] = {0, 0, 0};  // at the lower end
  few.x[1] = {9.5f, 5, 5};
  const CopyRule<3> low{{0, 0, 0}, {1, 0, 0}, {10, 0, 0}, false, false, 0};
  const CopyRule<3> high{{10, 0, 0}, {-1, 0, 0}, {-10, 0, 0}, false, false, 0};
  Copies<3> copies({low, high});
  copies.make(p, 1);
  copies.place(p);
  ASSERT_EQ(2, p.copies);
  EXPECT_EQ(10, few.x[2].x);
  EXPECT_EQ(-0.5f, few.x[3].x);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// Foam where vorticity varies, in flows with a closed form.
#include "pairs/bender2019.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace freshet {
namespace {

constexpr Real support = 1;

template <int D> using Places = std::vector<Vec<D>>;

/// A lattice within a box of `reach` sites to each side of 0 and `above` sites above it.
template <int D> Places<D> lattice(int reach, int above) {
  constexpr Real spacing = Real(0.125f);
  Places<D> all;
  const int deep = D == 3 ? reach : 0;
  for (int z = -deep; z <= deep; ++z)
    for (int y = -reach; y <= above; ++y)
      for (int x = -reach; x <= reach; ++x) {
        Vec<D> p{};
        p.x = spacing * Real(x), p.y = spacing * Real(y);
        if constexpr (D == 3) p.z = spacing * Real(z);
        all.push_back(p);
      }
  return all;
}

/// The mean of the turbulence at particle i; the spins of all are computed for it.
template <int D, class Flow> double turbulence(Places<D> x, Vec<D> at, Flow flow) {
  Places<D> v, spin;
  for (const Vec<D>& p : x) v.push_back(flow(p));
  const Bender2019Spin<D> moments{support, {v.data()}};
  for (int i = 0; i < int(x.size()); ++i) {
    Bender2019Moments<D, Real> sum{};
    const bool near = norm(x[std::size_t(i)] - at) <= support;  // spins elsewhere are not read
    for (int j = 0; near && j < int(x.size()); ++j)
      sum += moments(Pair<D, Real>(x[std::size_t(i)] - x[std::size_t(j)]), moments.at(i),
                     moments.neighbor(j));
    spin.push_back(bender2019_spin<D>(sum));
  }
  const Bender2019Turbulence<D> term{support, {spin.data()}};
  for (int i = 0; i < int(x.size()); ++i) {
    if (norm(x[std::size_t(i)] - at) > 0) continue;
    Ihmsen2012Mean<D, Real> sum{};
    for (int j = 0; j < int(x.size()); ++j)
      sum +=
          term(Pair<D, Real>(x[std::size_t(i)] - x[std::size_t(j)]), term.at(i), term.neighbor(j));
    return double(sum.mean());
  }
  return NAN;
}

Vec<2> turning(Vec<2> x) { return {-3 * x.y, 3 * x.x}; }
Vec<3> turning(Vec<3> x) { return cross(Vec<3>{1, -2, 3}, x); }

TEST(Bender2019, RigidRotationsHaveNoTurbulence) {
  EXPECT_NEAR(turbulence<2>(lattice<2>(16, 16), {}, [](auto x) { return turning(x); }), 0, 1e-4);
  EXPECT_NEAR(turbulence<2>(lattice<2>(16, 0), {}, [](auto x) { return turning(x); }), 0, 1e-4)
      << "at a surface";
  // a thousandth of the trace is added to the inertia, which is smaller at a surface
  EXPECT_NEAR(turbulence<3>(lattice<3>(8, 0), {}, [](auto x) { return turning(x); }), 0, 0.02);
}

template <int D> Vec<D> sheared(Vec<D> x) {
  Vec<D> v{};
  v.x = 5 * x.y;
  return v;
}
TEST(Bender2019, UniformShearHasNoTurbulence) {
  EXPECT_NEAR(turbulence<2>(lattice<2>(16, 16), {}, sheared<2>), 0, 1e-4);
}

// v_x = a y² has the vorticity -2 a y. The mean of |y_ij| with the weight 1 - r/h is h/pi in 2D and
// 0.3 h in 3D.
template <int D> Vec<D> curved(Vec<D> x) {
  Vec<D> v{};
  v.x = 2 * x.y * x.y;
  return v;
}
TEST(Bender2019, ShearThatVariesHasIt) {
  EXPECT_NEAR(turbulence<2>(lattice<2>(16, 16), {}, curved<2>), 4 / std::numbers::pi, 0.02);
  EXPECT_NEAR(turbulence<3>(lattice<3>(16, 16), {}, curved<3>), 1.2, 0.02);
}

TEST(Bender2019, LonelyParticlesDoNotSpin) {
  EXPECT_EQ(norm(bender2019_spin<3>({})), 0);
  EXPECT_EQ(norm(bender2019_spin<2>({})), 0);
  const Bender2019Moments<3, Real> line{{1, 0, 0}, {}, {}};  // all neighbours along x
  EXPECT_EQ(norm(bender2019_spin<3>(line)), 0);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// Mirror and periodic images exert the forces of real particles at their places.
#include <gtest/gtest.h>

#include <random>

#include "kernels/wendland.h"
#include "solvers/patch.h"

namespace freshet {
namespace {

/// A fluid whose set has images.
template <int D, class Solver> struct Fluid {
  using Backend = ReferenceBackend<D>;
  using Rules = typename Copies<D>::Rules;
  Solver solver;
  Backend backend;
  typename Solver::Fluid f;
  Walls<D> walls;

  Fluid(Solver s, const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& v, const Rules& rules)
      : solver(std::move(s)) {
    backend.add_set(f, int(x.size()), rules);
    backend.allocate(f, Keep::kept, f.id);
    backend.allocate(f, Keep::kept, f.x);
    backend.allocate(f, Keep::kept, f.v);
    solver.fields(f, [&](const char*, Keep keep, auto& a) { backend.allocate(f, keep, a); });
    backend.add_set(walls.akinci2012, 0);
    backend.add_set(walls.adami2012, 0);
    backend.add_set(walls.monaghan2009, 0);
    for (int i = 0; i < f.n; ++i) {
      f.id[i] = std::uint64_t(i);
      f.x[i] = x[std::size_t(i)];
      f.v[i] = v[std::size_t(i)];
      f.rho[i] = solver.c.rho0 * (1 + Real(0.01) * std::sin(7 * Real(i % 16)));
    }
  }
  /// A step of length 0 leaves the accelerations.
  std::vector<Vec<D>> accelerations() {
    solver.step(backend, f, walls, {0, 0});
    return {f.a.data, f.a.data + f.n};
  }
};

template <int D> double largest(const std::vector<Vec<D>>& a) {
  double most = 0;
  for (const Vec<D>& x : a) most = std::max(most, norm(x));
  return most;
}
template <int D>
double difference(const std::vector<Vec<D>>& a, const std::vector<Vec<D>>& b, std::size_t n) {
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) most = std::max(most, norm(a[i] - b[i]));
  return most / largest(b);
}

/// side^D points in [0, 1)^D with random velocities. Each is in a cell of its own, so that none
/// are too close.
template <int D> struct Stirred {
  std::vector<Vec<D>> x, v;
  explicit Stirred(int side) {
    std::mt19937 generator(9);
    std::uniform_real_distribution<double> any(-1, 1);
    int n = 1;
    for (int d = 0; d < D; ++d) n *= side;
    for (int i = 0; i < n; ++i) {
      Vec<D> at{}, speed{};
      for (int d = 0, k = i; d < D; ++d, k /= side) {
        component(at, d) = (k % side + 0.5 + 0.3 * any(generator)) / side;
        component(speed, d) = any(generator);
      }
      x.push_back(at);
      v.push_back(speed);
    }
  }
};

template <int D> WeaklyCompressibleParameters<D> parameters(int side) {
  auto c = weakly_compressible_patch<D>(Integrator::symplectic_euler);
  c.h = 1.2 / side;
  c.support = 2 * c.h;
  c.m = c.m_density = std::pow(1.0 / side, D);
  return c;
}
template <int D> auto wcsph(int side) {
  const auto c = parameters<D>(side);
  return Wcsph<D, ReferenceBackend<D>, WendlandC2>{c, WendlandC2<D>(c.support)};
}
template <int D> auto delta_sph(int side, bool antuono) {
  auto c = parameters<D>(side);
  c.antuono = antuono;
  return DeltaSph<D, ReferenceBackend<D>, WendlandC2>{c, WendlandC2<D>(c.support)};
}
template <int D> auto mueller2003(int side) {
  auto c = mueller2003_patch<D>(Integrator::symplectic_euler);
  c.h = 2.0 / side;
  c.m = c.m_density = std::pow(1.0 / side, D);
  return Mueller2003<D, ReferenceBackend<D>>{c};
}

template <int D> CopyRule<D> mirror(int axis, double at, double inward, bool no_slip) {
  CopyRule<D> rule{};
  rule.mirror = true;
  rule.no_slip = no_slip;
  rule.axis = axis;
  component(rule.point, axis) = at;
  component(rule.normal, axis) = inward;
  return rule;
}

template <int D, class Solver> void expect_mirror_images(const Solver& solver, int side) {
  for (const bool no_slip : {false, true}) {
    // Walls at x = 0 and y = 0: the corner has images of images.
    const Stirred<D> some(side);
    Fluid<D, Solver> with_ghosts(solver, some.x, some.v,
                                 {mirror<D>(0, 0, 1, no_slip), mirror<D>(1, 0, 1, no_slip)});
    auto x = some.x, v = some.v;
    for (int axis = 0; axis < 2; ++axis)
      for (std::size_t i = 0, n = x.size(); i < n; ++i) {
        Vec<D> image = x[i], speed = no_slip ? Real(-1) * v[i] : v[i];
        component(image, axis) *= -1;
        if (!no_slip) component(speed, axis) *= -1;
        x.push_back(image);
        v.push_back(speed);
      }
    Fluid<D, Solver> with_images(solver, x, v, {});
    for (int i = 0; i < with_images.f.n; ++i)  // an image has its particle's density
      with_images.f.rho[i] = with_ghosts.f.rho[i % with_ghosts.f.n];
    const auto ghosts = with_ghosts.accelerations(), images = with_images.accelerations();
    EXPECT_GT(with_ghosts.f.copies, 0);
    EXPECT_LT(difference<D>(ghosts, images, some.x.size()), 1e-11) << no_slip;
  }
}

TEST(Ghosts, GiveTheAccelerationsOfMirrorImages) {
  expect_mirror_images<2>(wcsph<2>(10), 10);
  expect_mirror_images<3>(wcsph<3>(6), 6);
  expect_mirror_images<2>(delta_sph<2>(10, false), 10);
  expect_mirror_images<3>(delta_sph<3>(6, true), 6);
  expect_mirror_images<2>(mueller2003<2>(10), 10);
}

TEST(Ghosts, FreeSlipKeepsAStreamAndNoSlipSlowsIt) {
  const auto push_along = [](bool no_slip) {
    auto solver = delta_sph<2>(10, false);
    Stirred<2> some(10);
    for (Vec<2>& v : some.v) v = {1, 0};
    Fluid fluid(solver, some.x, some.v, {mirror<2>(1, 0, 1, no_slip)});
    auto still = some.v;
    for (Vec<2>& v : still) v = {0, 0};
    Fluid at_rest(solver, some.x, still, {mirror<2>(1, 0, 1, no_slip)});
    const auto moving = fluid.accelerations(), resting = at_rest.accelerations();
    double sum = 0;
    for (std::size_t i = 0; i < moving.size(); ++i) sum += moving[i].x - resting[i].x;
    return sum / largest(resting);
  };
  EXPECT_LT(std::abs(push_along(false)), 1e-11);
  EXPECT_LT(push_along(true), -1e-3);

  const auto free_slip = mirror<3>(2, 1, -1, false), no_slip = mirror<3>(2, 1, -1, true);
  const Vec<3> v{1, 2, 3};
  const Vec<3> slips = free_slip.velocity(v), turns = no_slip.velocity(v);
  EXPECT_EQ((std::array<Real, 3>{1, 2, -3}), (std::array<Real, 3>{slips.x, slips.y, slips.z}));
  EXPECT_EQ((std::array<Real, 3>{-1, -2, -3}), (std::array<Real, 3>{turns.x, turns.y, turns.z}));
}

template <int D> typename Copies<D>::Rules periodic() {
  typename Copies<D>::Rules rules;
  for (int side = 0; side < 2 * D; ++side) {
    CopyRule<D> rule = mirror<D>(side / 2, side % 2, side % 2 ? -1 : 1, false);
    rule.mirror = false;
    component(rule.shift, side / 2) = side % 2 ? -1 : 1;
    rules.push_back(rule);
  }
  return rules;
}

template <int D, class Solver> void expect_no_place_is_special(Solver solver, int side) {
  for (int d = 0; d < D; ++d) {
    component(solver.c.confine.period, d) = 1;
    component(solver.c.confine.box.max, d) = 1;
  }
  const Stirred<D> some(side);
  auto moved = some.x;
  for (Vec<D>& x : moved)
    for (int d = 0; d < D; ++d) {
      Real& at = component(x, d);
      at += 0.37 + 0.21 * d;
      if (at >= 1) at -= 1;
    }
  Fluid<D, Solver> here(solver, some.x, some.v, periodic<D>());
  Fluid<D, Solver> there(solver, moved, some.v, periodic<D>());
  const auto a = here.accelerations(), b = there.accelerations();
  EXPECT_LT(difference<D>(a, b, a.size()), 1e-11);

  const auto momentum = [&] {
    Vec<D> sum{};
    for (int i = 0; i < here.f.n; ++i) sum += here.f.v[i];
    return sum;
  };
  const auto before = momentum();
  double pushed = 0;
  for (int k = 0; k < 50; ++k) {
    solver.step(here.backend, here.f, here.walls, {Real(2e-4), k});
    for (int i = 0; i < here.f.n; ++i) pushed += 2e-4 * norm(here.f.a[i]);
  }
  EXPECT_GT(pushed, 1);
  EXPECT_LT(norm(momentum() - before) / pushed, 1e-12);
  for (int i = 0; i < here.f.n; ++i)
    for (int d = 0; d < D; ++d) {
      EXPECT_GE(component(here.f.x[i], d), 0);
      EXPECT_LT(component(here.f.x[i], d), 1);
    }
}

TEST(PeriodicBox, DoesNotDependOnTheOriginAndConservesMomentum) {
  expect_no_place_is_special<2>(wcsph<2>(10), 10);
  expect_no_place_is_special<3>(wcsph<3>(6), 6);
  expect_no_place_is_special<2>(delta_sph<2>(10, true), 10);
  expect_no_place_is_special<3>(delta_sph<3>(6, false), 6);
  expect_no_place_is_special<3>(mueller2003<3>(6), 6);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// The cpu backend visits the reference backend's neighbours in the reference's order, wherever the
// particles are. Compiled once for every instruction set.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "backend/reference/reference_backend.h"
#include "backend/reference/reference_sets_impl.h"

namespace freshet {
inline namespace FRESHET_ISA {
namespace {

/// A sum whose bits depend on the neighbours and their order.
template <int D> struct Trace {
  Field<Real> value;
  template <class R> struct At { R value; };
  At<Real> at(int i) const { return {value[i]}; }
  template <class R> using Neighbor = At<R>;
  Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R> R operator()(const Pair<D, R>& ij, At<R>, At<R> j) const {
    return select(ij.r2 < R(h2), j.value, R(Real(0)));
  }
  Real h2 = 1;
};

/// Traces by id for a support radius of 1, in two searches; the particles move between them.
template <int D, class AnyBackend>
std::vector<Real> traces(AnyBackend backend, const std::vector<Vec<D>>& x) {
  Particles<D> p;
  Field<Real> value, trace;
  backend.add_set(p, int(x.size()));
  backend.allocate(p, Keep::kept, p.id);
  backend.allocate(p, Keep::kept, p.x);
  backend.allocate(p, Keep::kept, value);
  backend.allocate(p, Keep::scratch, trace);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < p.n; ++i) {
    p.id[i] = std::uint64_t(i);
    p.x[i] = x[std::size_t(i)];
    value[i] = Real(any(generator));
  }
  std::vector<Real> by_id(std::size_t(2 * p.n));
  for (int step = 0; step < 2; ++step) {
    backend.find_neighbors("neighbors", Real(1), p);
    const auto out = trace;
    backend.sum_pairs("trace", p, over(p, Trace<D>{value}), [=](int i, Real s) { out[i] = s; });
    for (int i = 0; i < p.n; ++i) by_id[2 * p.id[i] + std::size_t(step)] = trace[i];
    for (int i = 0; i < p.n; ++i) p.x[i].x += value[i] / 4;
  }
  return by_id;
}

template <int D> void expect_one_order(const std::vector<Vec<D>>& x) {
  const auto reference = traces<D>(ReferenceBackend<D>(), x);
  EXPECT_EQ(reference, traces<D>(ReferenceBackend<D>(Search::all_pairs), x));
  for (const int threads : {3, 1}) EXPECT_EQ(reference, traces<D>(CpuBackend<D>(threads), x));
}

/// Sparse particles, and a few clumps a hundred times as dense.
template <int D> std::vector<Vec<D>> clumps(double size) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> at(-size, size);
  std::normal_distribution<double> around(0, 0.4);
  std::vector<Vec<D>> x(900);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int d = 0; d < D; ++d)
      component(x[i], d) =
          i < 400 ? Real(at(generator)) : component(x[i % 5], d) + Real(around(generator));
  return x;
}

#define CONCATENATE(a, b) a##b
#define SUITE_OF(isa) CONCATENATE(SearchOrder_, isa)
#define SUITE SUITE_OF(FRESHET_ISA)

class SUITE : public ::testing::Test {
  void SetUp() override {
#if defined(__AVX512F__)
    if (!__builtin_cpu_supports("avx512f")) GTEST_SKIP() << "not on this machine";
#elif defined(__AVX2__)
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "not on this machine";
#elif defined(__SSE4_2__)
    if (!__builtin_cpu_supports("sse4.2")) GTEST_SKIP() << "not on this machine";
#endif
  }
};

TEST_F(SUITE, VisitsNeighborsInTheReferencesOrderInClumps) {
  expect_one_order(clumps<2>(8));
  expect_one_order(clumps<3>(4));
}

// Particles far away along one axis, then along all: the cells wrap there. 4e12 is past the last
// cell.
TEST_F(SUITE, VisitsNeighborsInTheReferencesOrderWhereCellsWrap) {
  for (const int axes : {1, 2, 4, 7})
    for (const double far : {20000.0, -3e5, 4e12}) {
      auto flat = clumps<2>(6);
      auto deep = clumps<3>(3);
      for (std::size_t i = 0; i < 6; ++i)
        for (int d = 0; d < 3; ++d) {
          if (!(axes >> d & 1)) continue;
          component(deep[i], d) += Real(far * double(i));
          if (d < 2) component(flat[i], d) += Real(far * double(i));
        }
      expect_one_order(flat);
      expect_one_order(deep);
    }
}

TEST_F(SUITE, VisitsNeighborsInTheReferencesOrderInACrowd) {
  std::vector<Vec<2>> x(1500);
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> at(0.01, 0.2);
  for (Vec<2>& p : x) p = {Real(at(generator)), Real(at(generator))};
  expect_one_order(x);
}

TEST_F(SUITE, VisitsNeighborsInTheReferencesOrderForFewAndNanParticles) {
  expect_one_order(std::vector<Vec<3>>{{1, 2, 3}});
  expect_one_order(std::vector<Vec<2>>{});
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinity = std::numeric_limits<Real>::infinity();
  auto x = clumps<3>(4);
  x[3].x = x[4].y = x[500].z = nan;
  x[7].x = x[70].y = infinity;
  x[700].z = -infinity;
  expect_one_order(x);
  expect_one_order(std::vector<Vec<2>>(50, Vec<2>{nan, nan}));
}

}  // namespace
}  // namespace FRESHET_ISA
}  // namespace freshet

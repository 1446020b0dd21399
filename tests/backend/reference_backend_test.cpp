// SPDX-License-Identifier: MIT
#include "backend/reference/reference_backend.h"
#include "backend/reference/reference_sets_impl.h"

#include <gtest/gtest.h>

#include "solvers/backend.h"

namespace freshet {
namespace {

static_assert(Backend<ReferenceBackend<2>, 2> && Backend<ReferenceBackend<3>, 3>);

/// Sums the neighbours' values.
struct SumOf {
  Field<Real> value;
  template <class R> struct At { R value; };
  At<Real> at(int i) const { return {value[i]}; }
  template <class R> using Neighbor = At<R>;
  Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R> R operator()(const Pair<2, R>&, At<R>, At<R> j) const { return j.value; }
};

class ThreeInARow : public ::testing::Test {
 protected:
  void SetUp() override {
    backend.add_set(particles, 3);
    backend.allocate(particles, Keep::kept, particles.x);
    backend.allocate(particles, Keep::scratch, value);
    for (int i = 0; i < 3; ++i) {
      particles.x[i].x = Real(i);
      value[i] = Real(i + 1);
    }
    backend.find_neighbors("neighbors", Real(1.5f), particles);
  }
  ReferenceBackend<2> backend;
  Particles<2> particles;
  Field<Real> value;
};

TEST_F(ThreeInARow, PassReadsFieldsAsTheyWereBeforeIt) {
  const auto v = value;
  backend.sum_pairs("sum", particles, over(particles, SumOf{value}),
                    [=](int i, Real sum) { v[i] = sum; });
  EXPECT_EQ(3, value[0]);  // 1 + 2: the particle itself and its neighbour
  EXPECT_EQ(6, value[1]);
  EXPECT_EQ(5, value[2]);
}

TEST_F(ThreeInARow, MaxCoversAllParticles) {
  const auto v = value;
  EXPECT_EQ(3, backend.max("max", particles, [=](int i) { return v[i]; }));
}

TEST_F(ThreeInARow, CallsAreCountedUnderTheirName) {
  backend.for_each("visit", particles, [](int) {});
  backend.for_each("visit", particles, [](int) {});
  const VerbTiming& visit = backend.timings().back();
  EXPECT_EQ("visit", visit.name);
  EXPECT_EQ(2, visit.calls);
  EXPECT_EQ(6, visit.targets);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// Lists of neighbours that serve several searches: complete, kept while nothing moved far, and of
// the same order on all backends.
#include <gtest/gtest.h>

#include <random>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "backend/reference/reference_backend.h"
#include "backend/reference/reference_sets_impl.h"
#include "kernels/poly6.h"
#include "pairs/density.h"

namespace freshet {
namespace {

constexpr Real h = Real(0.3f), skin = Real(0.06f);

/// The number of pairs closer than h.
struct Count {
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  At<Real> at(int) const { return {}; }
  Neighbor<Real> neighbor(int) const { return {}; }
  template <class R> R operator()(const Pair<3, R>& ij, At<R>, Neighbor<R>) const {
    return select(ij.r2 < R(h * h), R(1), R(0));
  }
};

/// A cloud in a periodic box, with the fields that a list with a skin needs.
template <class B> struct Cloud {
  B backend;
  Particles<3> p;
  Field<Real> sums;

  explicit Cloud(B b) : backend(std::move(b)) {
    const Vec<3> none{}, shift{Real(2), 0, 0};
    backend.add_set(p, 900,
                    {{none, {1, 0, 0}, shift, false, false, 0},
                     {shift, {-1, 0, 0}, {Real(-2), 0, 0}, false, false, 0}});
    backend.allocate(p, Keep::kept, p.id);
    backend.allocate(p, Keep::kept, p.x);
    backend.allocate(p, Keep::kept, p.v);
    backend.allocate(p, Keep::kept, p.x_listed);
    backend.allocate(p, Keep::scratch, sums);
    p.skin = skin;
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> at(0.06, 1.94);
    for (int i = 0; i < p.n; ++i) {
      p.id[i] = std::uint64_t(i);
      p.x[i] = {Real(at(generator)), Real(at(generator)), Real(at(generator))};
    }
  }
  int place_of(std::uint64_t id) const {
    int i = 0;
    while (p.id[i] != id) ++i;
    return i;
  }
  /// Moves every particle by `way` in a direction of its own; no long way along the periodic axis.
  void move(double way) {
    for (int i = 0; i < p.n; ++i) {
      const double angle = double(p.id[i]) * 2.4;
      const Real a = Real(way * std::cos(angle)), b = Real(way * std::sin(angle));
      p.x[i] += way < 0.1 ? Vec<3>{a, b, 0} : Vec<3>{0, a, b};
    }
  }
  /// The sum of a term over the neighbours, by id.
  template <class Term> std::vector<Real> sum(const Term& term) {
    backend.find_neighbors("", h, p);
    const auto to = sums;
    backend.sum_pairs("", p, over(p, term), [=](int i, Real one) { to[i] = one; });
    std::vector<Real> by_id(std::size_t(p.n));
    for (int i = 0; i < p.n; ++i) by_id[p.id[i]] = sums[i];
    return by_id;
  }
  std::vector<Real> brute_force() const {
    std::vector<Real> by_id(std::size_t(p.n));
    for (int i = 0; i < p.n; ++i)
      for (int j = 0; j < p.n; ++j)
        for (const int turn : {-1, 0, 1}) {
          const Vec<3> image = p.x[j] + Vec<3>{Real(2 * turn), 0, 0};
          by_id[p.id[i]] += norm2(p.x[i] - image) < h * h;
        }
    return by_id;
  }
};

template <class B> void expect_complete_lists(B backend) {
  Cloud<B> cloud(std::move(backend));
  for (const double way : {0.0, 0.014, 0.014, 0.014, -0.01, 0.2, 0.014}) {
    cloud.move(way);
    EXPECT_EQ(cloud.brute_force(), cloud.sum(Count{})) << "after a way of " << way;
  }
}

TEST(Skin, ListsMissNoNeighbor) {
  expect_complete_lists(ReferenceBackend<3>());
  for (const int threads : {3, 1}) expect_complete_lists(CpuBackend<3>(threads));
}

TEST(Skin, KeepsTheListsUntilAParticleLeavesThem) {
  Cloud cloud(CpuBackend<3>(2));
  cloud.sum(Count{});
  const Vec<3> before = cloud.p.x_listed[cloud.place_of(5)];
  cloud.move(0.029);
  cloud.sum(Count{});
  EXPECT_EQ(before.x, cloud.p.x_listed[cloud.place_of(5)].x);
  cloud.p.x[cloud.place_of(17)].z += Real(0.1f);
  cloud.sum(Count{});
  EXPECT_NE(before.x, cloud.p.x_listed[cloud.place_of(5)].x);
}

/// After an edit, and after a restart, lists follow from the kept positions: no other order.
TEST(Skin, HasTheOrderOfTheReference) {
  const Density term{Poly6<3>(h), Real(1)};
  const auto sums = [&](auto backend, bool edited) {
    Cloud cloud(std::move(backend));
    std::vector<std::vector<Real>> all;
    for (const double way : {0.0, 0.02, 0.005, 0.02}) {
      cloud.move(way);
      if (edited) cloud.backend.edit("", cloud.p, {}, 0);
      all.push_back(cloud.sum(term));
    }
    return all;
  };
  const auto reference = sums(ReferenceBackend<3>(), false);
  for (const bool edited : {false, true})
    for (const int threads : {3, 1}) EXPECT_EQ(reference, sums(CpuBackend<3>(threads), edited));
}

}  // namespace
}  // namespace freshet

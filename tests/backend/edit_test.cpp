// SPDX-License-Identifier: MIT
// Adds and removes particles on both backends and compares their fields with a map by id.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "backend/reference/reference_backend.h"
#include "backend/reference/reference_sets_impl.h"
#include "kernels/poly6.h"
#include "pairs/density.h"

namespace freshet {
namespace {

struct Made {
  Vec<3> x;
  double weight;
  int kind;
  Real scratch;
};

/// A set with a field of each element size besides x and id.
template <class B> class Cloud {
 public:
  explicit Cloud(B backend, typename Copies<3>::Rules rules = {}) : backend_(std::move(backend)) {
    backend_.add_set(p_, 0, std::move(rules));
    backend_.allocate(p_, Keep::kept, p_.id);
    backend_.allocate(p_, Keep::kept, p_.x);
    backend_.allocate(p_, Keep::kept, p_.v);
    backend_.allocate(p_, Keep::kept, weight_);
    backend_.allocate(p_, Keep::kept, kind_);
    backend_.allocate(p_, Keep::scratch, scratch_);
    backend_.allocate(p_, Keep::scratch, rho_);
  }
  /// Removes the particles that `goes` selects and appends `more` new ones.
  template <class Goes> void edit(const Goes& goes, int more) {
    std::vector<int> gone;
    for (int i = 0; i < p_.n; ++i)
      if (goes(p_.id[i])) {
        gone.push_back(i);
        model_.erase(p_.id[i]);
      }
    const int left = p_.n - int(gone.size());
    backend_.edit("edit", p_, gone, more);
    ASSERT_EQ(left + more, p_.n);
    for (int i = left; i < p_.n; ++i) {
      EXPECT_EQ(0u, p_.id[i]);
      EXPECT_EQ(0, p_.x[i].x);
      EXPECT_EQ(0, weight_[i]);
      EXPECT_EQ(0, kind_[i]);
      EXPECT_EQ(0, scratch_[i]);
      const Made m{{draw(), draw(), draw()}, double(draw()), int(next_id_ % 7), 0};
      p_.id[i] = next_id_;
      p_.x[i] = m.x;
      weight_[i] = m.weight;
      kind_[i] = m.kind;
      model_[next_id_++] = m;
    }
  }
  void search() {
    backend_.find_neighbors("neighbors", Real(0.3f), p_);
    const auto rho = rho_;
    backend_.sum_pairs("density", p_, over(p_, Density{Poly6<3>(Real(0.3f)), Real(1)}),
                       [=](int i, Real sum) { rho[i] = sum; });
    for (int i = 0; i < p_.n; ++i) {  // the search leaves scratch in disorder
      scratch_[i] = Real(p_.id[i]);
      model_[p_.id[i]].scratch = scratch_[i];
    }
  }
  void expect_as_the_model() const {
    ASSERT_EQ(model_.size(), std::size_t(p_.n));
    for (int i = 0; i < p_.n; ++i) {
      ASSERT_TRUE(model_.contains(p_.id[i]));
      const Made& m = model_.at(p_.id[i]);
      EXPECT_EQ(m.x.x, p_.x[i].x);
      EXPECT_EQ(m.x.z, p_.x[i].z);
      EXPECT_EQ(m.weight, weight_[i]);
      EXPECT_EQ(m.kind, kind_[i]);
      EXPECT_EQ(m.scratch, scratch_[i]);
    }
  }
  std::map<std::uint64_t, Real> densities() const {
    std::map<std::uint64_t, Real> all;
    for (int i = 0; i < p_.n; ++i) all[p_.id[i]] = rho_[i];
    return all;
  }
  B backend_;
  Particles<3> p_;

 private:
  Real draw() { return Real(std::uniform_real_distribution<double>(0.01, 0.99)(generator_)); }

  Field<double> weight_;
  Field<int> kind_;
  Field<Real> scratch_, rho_;
  std::map<std::uint64_t, Made> model_;
  std::mt19937 generator_{5};
  std::uint64_t next_id_ = 0;
};

/// Edits a set from no particles to thousands and back to none. Returns the densities after each
/// edit.
template <class B>
std::vector<std::map<std::uint64_t, Real>> come_and_go(B backend,
                                                       typename Copies<3>::Rules rules = {}) {
  Cloud<B> cloud(std::move(backend), std::move(rules));
  std::vector<std::map<std::uint64_t, Real>> all;
  const auto then = [&](const auto& goes, int more) {
    cloud.edit(goes, more);
    cloud.expect_as_the_model();
    cloud.search();
    cloud.expect_as_the_model();
    all.push_back(cloud.densities());
  };
  const auto none = [](std::uint64_t) { return false; };
  then(none, 0);
  then(none, 1);
  then(none, 700);
  then([](std::uint64_t id) { return id % 3 == 0; }, 0);
  then([](std::uint64_t id) { return id % 5 == 1; }, 900);
  then([](std::uint64_t id) { return id > 800 && id % 2; }, 3);
  then([](std::uint64_t id) { return id < 1500; }, 2500);
  then([](std::uint64_t) { return true; }, 0);
  then(none, 40);
  then([](std::uint64_t) { return true; }, 20);
  return all;
}

TEST(Edit, KeepsRemainingParticlesOnBothBackends) {
  const auto reference = come_and_go(ReferenceBackend<3>());
  EXPECT_EQ(0u, reference[0].size());
  EXPECT_EQ(2500u + 54u, reference[6].size());
  for (const int threads : {7, 2, 1}) EXPECT_EQ(reference, come_and_go(CpuBackend<3>(threads)));
}

TEST(Edit, KeepsRemainingParticlesBesideMirrorImages) {
  typename Copies<3>::Rules rules(2);
  for (int k = 0; k < 2; ++k) {
    rules[std::size_t(k)].mirror = true;
    rules[std::size_t(k)].axis = k;
    component(rules[std::size_t(k)].normal, k) = 1;
  }
  const auto reference = come_and_go(ReferenceBackend<3>(), rules);
  EXPECT_NE(reference, come_and_go(ReferenceBackend<3>()));
  for (const int threads : {2, 1}) EXPECT_EQ(reference, come_and_go(CpuBackend<3>(threads), rules));
}

TEST(Edit, ReallocatesOnlyWhenTheMemoryIsFull) {
  Cloud<CpuBackend<3>> cloud{CpuBackend<3>(1)};
  const auto none = [](std::uint64_t) { return false; };
  cloud.edit(none, 100);
  const void* before = cloud.p_.x.data;
  cloud.edit(none, 60);
  EXPECT_NE(before, cloud.p_.x.data);
  const void* then = cloud.p_.x.data;
  // 200 particles fit: 160 got room for half as many again
  cloud.edit([](std::uint64_t id) { return id < 50; }, 90);
  EXPECT_EQ(then, cloud.p_.x.data);
}

}  // namespace
}  // namespace freshet

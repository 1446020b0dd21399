// SPDX-License-Identifier: MIT
// Kernels on packs have the scalar kernel's bits in every lane, with every instruction set of this
// machine.
#include "kernels/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "freshet/error.h"
#include "freshet/simulation.h"

namespace freshet {
#if defined(LANES_avx2)
#define FRESHET_DECLARE(isa)                                           \
  namespace isa {                                                      \
  void evaluate_in_packs(const Real* const (&x)[3], int n, Real* out); \
  }
FRESHET_DECLARE(sse42)
FRESHET_DECLARE(avx2)
FRESHET_DECLARE(avx512)
#endif
namespace {

struct Points {
  static constexpr int n = 4096;
  std::vector<Real> x, y, z;

  Points() {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> at(-1.1, 1.1);
    for (int k = 0; k < n; ++k) add(at(generator), at(generator), at(generator));
    // The centre, points close to it, the kinks at half the support and at the support, points just
    // inside and outside, and the far particle that pads neighbour lists.
    int k = 0;
    for (const double r : {0.0, 1e-30, 1e-7, 0.5, 1 - 1e-7, 1.0, 1 + 2e-7, 1e9, -1e9}) {
      x[k] = Real(r);
      y[k] = z[k] = 0;
      k += 7;  // a step of 7 reaches every lane
    }
  }
  void add(double a, double b, double c) {
    x.push_back(Real(a));
    y.push_back(Real(b));
    z.push_back(Real(c));
  }
  template <class F> std::vector<Real> values(const F& f) const {
    std::vector<Real> out(std::size_t(n) * values_a_point);
    const Real* const points[3]{x.data(), y.data(), z.data()};
    f(points, n, out.data());
    return out;
  }
};

using Evaluate = void (*)(const Real* const (&)[3], int, Real*);

TEST(KernelLanes, HaveTheScalarsBits) {
  const Points points;
  const std::vector<Real> scalars = points.values(evaluate_all<Real>);
  for (const Real value : scalars) ASSERT_TRUE(std::isfinite(value));
  std::vector<std::pair<const char*, Evaluate>> all{{"plain", base::evaluate_in_packs}};
#if defined(LANES_avx2)
  all.insert(all.end(), {{"sse42", sse42::evaluate_in_packs},
                         {"avx2", avx2::evaluate_in_packs},
                         {"avx512", avx512::evaluate_in_packs}});
#endif
  for (const auto& [isa, evaluate] : all) {
    try {
      instruction_set(isa);
    } catch (const Error&) {
      continue;  // not on this machine
    }
    const std::vector<Real> packs = points.values(evaluate);
    for (std::size_t k = 0; k < packs.size(); ++k)
      ASSERT_EQ(0, std::memcmp(&scalars[k], &packs[k], sizeof(Real)))
          << isa << ": " << scalars[k] << " and " << packs[k] << ", value " << k / Points::n
          << " of point " << k % Points::n;
  }
}

}  // namespace
}  // namespace freshet

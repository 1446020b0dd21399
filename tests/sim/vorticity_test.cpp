// SPDX-License-Identifier: MIT
// A micropolar fluid: momentum, eddies and spin.
#include <gtest/gtest.h>

#include "sim/forced.h"

namespace freshet::test {
namespace {

constexpr double two_pi = 6.283185307179586;

/// Taylor-Green vortices in a periodic box, with or without spin.
Simulation vortices(const std::string& solver, bool spins) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1, 1]\ngravity = [0, 0]\nperiodic = \"xy\"\n[particles]\nspacing = 0.025\n"
      "support_radius = 0.075\n[fluid]\nmin = [0, 0]\nmax = [1, 1]\nviscosity = 2\n[solver]\nname "
      "= \"" +
      solver + "\"\nviscosity_method = \"morris1997\"\nkernel = \"wendland_c2\"\n" +
      (solver == "dfsph" ? "xsph = 0\n" : "sound_speed = 2.0\n") +
      (spins ? "vorticity_method = \"bender2017\"\nvorticity_transfer = 0.002\n"
               "vorticity_inertia = 1e-6\n"
             : "") +
      "[time]\nend = 10\nstep = 0.002\n[checks]\nwhen_wrong = \"warn\"\n");
  set_velocities(sim, [](const Real* x, Real* v) {
    const double a = two_pi * double(x[0]), b = two_pi * double(x[1]);
    v[0] = Real(0.05 + 0.1 * std::sin(a) * std::cos(b));
    v[1] = Real(-0.1 * std::cos(a) * std::sin(b));
  });
  return sim;
}

class Micropolar : public ::testing::TestWithParam<const char*> {};

TEST_P(Micropolar, ConservesMomentumAndPreservesEddies) {
  const std::string solver = GetParam();
  if (!compiled(solver)) GTEST_SKIP() << "not compiled in this build";
  Simulation plain = vortices(solver, false), spinning = vortices(solver, true);
  const auto before = spinning.statistics();
  for (int n = 0; n < 500; ++n) {
    plain.step();
    spinning.step();
  }
  const auto a = plain.statistics(), b = spinning.statistics();
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(before.momentum[std::size_t(k)], b.momentum[std::size_t(k)],
                1e-4 * before.momentum[0]);
  const auto eddies = [](const Statistics& s) {
    return s.kinetic_energy -
           (s.momentum[0] * s.momentum[0] + s.momentum[1] * s.momentum[1]) / 2000;
  };
  EXPECT_GT(eddies(b), 1.1 * eddies(a)) << "measured: 1.17, as with half of the viscosity";
  EXPECT_LT(eddies(b), eddies(before));
}
INSTANTIATE_TEST_SUITE_P(Solvers, Micropolar, ::testing::Values("wcsph", "delta_sph"));

// The spin must equal the angular velocity of a rigid rotation, and 0 in a fluid at rest.
TEST(MicropolarSpin, FollowsARigidRotation) {
  if (!compiled("wcsph")) GTEST_SKIP() << "not compiled in this build";
  for (const double omega : {0.0, 2.0}) {
    Simulation sim = simulation_of(
        "[domain]\nmax = [2, 2]\ngravity = [0, 0]\n[walls]\nmethod = \"open\"\n[particles]\n"
        "spacing = 0.05\n[fluid]\nshape = \"sphere\"\ncenter = [1, 1]\nradius = "
        "0.5\n[solver]\nname "
        "= \"wcsph\"\nsound_speed = 20\nvorticity_method = \"bender2017\"\n"
        "vorticity_transfer = 1e-3\nvorticity_inertia = 1e-9\n[time]\nend = 1\nstep = "
        "1e-7\n[checks]\nwhen_wrong = "
        "\"warn\"\n");
    set_velocities(sim, [&](const Real* x, Real* v) {
      v[0] = Real(-omega * (double(x[1]) - 1));
      v[1] = Real(omega * (double(x[0]) - 1));
    });
    for (int n = 0; n < 200; ++n) sim.step();
    const Checkpoint c = sim.checkpoint();
    int looked_at = 0;
    for (const auto& a : c.arrays) {
      if (a.name != "fluid/spin") continue;
      const Real* spin = reinterpret_cast<const Real*>(a.bytes.data());
      const ParticleView f = sim.fluid();
      for (std::size_t i = 0; i < f.size(); ++i) {
        const double dx = double(f.x[2 * i]) - 1, dy = double(f.x[2 * i + 1]) - 1;
        if (dx * dx + dy * dy < 0.3 * 0.3) {
          EXPECT_NEAR(omega, double(spin[i]), 1e-6 + 0.03 * omega);
          ++looked_at;
        }
      }
    }
    EXPECT_GT(looked_at, 50);
  }
}

}  // namespace
}  // namespace freshet::test

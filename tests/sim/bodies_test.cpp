// SPDX-License-Identifier: MIT
// Rigid bodies in a fluid: closed forms and conservation.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/select.h"
#include "io/checkpoint.h"
#include "scene/model/body_shape.h"
#include "scene/model/expressions.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

struct Words {
  const char* solver;
  const char* time = "step = \"adaptive\"\nstep_max = 0.002\n";
  const char* walls = "akinci2012";
};
const Words layered_wcsph{"wcsph", Words{}.time, "adami2012"};
const Words layered_delta_sph{"delta_sph", Words{}.time, "adami2012"};

class Bodies : public ::testing::TestWithParam<Words> {
 protected:
  void SetUp() override {
    const std::string name = "solver.name = \"" + std::string(GetParam().solver) + "\"";
    const Scene s = parse_scene("domain.max = [1, 1]\nparticles.spacing = 0.1\n" + name +
                                    "\ntime = { end = 1, step = 0.1 }\n"
                                    "fluid = { min = [0, 0], max = [1, 1] }",
                                "words.toml");
    if (!has_solver(s.solver.name)) GTEST_SKIP() << "not compiled in this build";
    if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  }
  static bool weakly() {
    const std::string name = GetParam().solver;
    return name == "wcsph" || name == "delta_sph";
  }
  static std::string with(const std::string& text, const std::string& end,
                          const std::string& solver = "") {
    const bool layered = GetParam().walls == std::string("adami2012");
    return text + (layered ? "[walls]\nmethod = \"adami2012\"\n" : "") + "[solver]\nname = \"" +
           GetParam().solver + "\"\n" + solver + "[time]\nend = " + end + "\n" + GetParam().time;
  }
};
void PrintTo(const Words& w, std::ostream* out) {
  *out << w.solver << " " << w.walls << " " << w.time;
}
INSTANTIATE_TEST_SUITE_P(
    Solvers, Bodies,
    ::testing::Values(Words{"wcsph"},
                      Words{"wcsph",
                            "step = \"adaptive\"\nstep_max = 0.002\nintegrator = \"leapfrog\"\n"},
                      layered_wcsph, Words{"delta_sph"}, layered_delta_sph, Words{"iisph"},
                      Words{"dfsph"}, Words{"pcisph"}, Words{"pbf"}));

const std::string pool =
    "[domain]\nmax = [1, 0.6]\n[particles]\nspacing = 0.02\n"
    "[fluid]\nmin = [0, 0]\nmax = [1, 0.3]\npressure = \"hydrostatic\"\n";

/// Without the weakly compressible solvers, whose runs would need too many steps.
class FloatingBodies : public Bodies {};
INSTANTIATE_TEST_SUITE_P(Solvers, FloatingBodies,
                         ::testing::Values(Words{"iisph"}, Words{"dfsph"}, Words{"pbf"}));

class ThinBodies : public Bodies {};
INSTANTIATE_TEST_SUITE_P(Solvers, ThinBodies,
                         ::testing::Values(Words{"wcsph"}, Words{"delta_sph"}, Words{"iisph"},
                                           Words{"dfsph"}, Words{"pcisph"}, Words{"pbf"}));

/// The mean of a quantity over the last seconds of a run.
template <class F> double mean_of(Simulation& sim, double seconds, F quantity) {
  double sum = 0, time = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() < sim.scene().time.end - seconds) continue;
    sum += sim.time_steps().last * quantity(sim);
    time += sim.time_steps().last;
  }
  return sum / time;
}

/// Height of the highest particle.
double level_of(const Simulation& sim) {
  double most = 0;
  const ParticleView f = sim.fluid();
  for (std::size_t i = 0; i < f.size(); ++i) most = std::max(most, double(f.x[2 * i + 1]));
  return most;
}

TEST_P(FloatingBodies, FloatAtTheDepthOfTheirDensity) {
  Simulation sim = simulation_of(
      with(pool + "[body]\nmin = [0.3, 0.2]\nmax = [0.7, 0.4]\nmotion = \"free\"\ndensity = 500\n",
           "3"));
  const double particles = double(sim.fluid().size()), spacing = 0.02;
  const double y = mean_of(sim, 1, [](Simulation& s) { return s.bodies()[0].position[1]; });
  // The volumes of the water and of half the box fill the pool up to its level.
  const double level = particles * spacing * spacing + 0.4 * 0.1;
  EXPECT_NEAR(level, y, 0.02 * 0.2) << "the centre of the box must be at the surface";
  EXPECT_NEAR(0, sim.bodies()[0].orientation[2], 0.02) << "it lies level";
}

TEST_P(FloatingBodies, SinkIfDenserThanWater) {
  const auto sunk = [](const std::string& density) {
    Simulation sim =
        simulation_of(with(pool +
                               "[body]\nmin = [0.4, 0.16]\nmax = [0.6, 0.26]\nmotion = \"free\"\n"
                               "restitution = 0\ndensity = " +
                               density + "\n",
                           "2"));
    while (!sim.finished()) sim.step();
    return sim.bodies()[0].position[1];
  };
  EXPECT_LT(sunk("1100"), 0.185) << "it sinks slowly: the box is five spacings high";
  EXPECT_LT(sunk("1500"), 0.08) << "it must be on the floor, or on a film of water";
}

TEST_P(Bodies, AreLiftedByTheWeightOfDisplacedWater) {
  Simulation sim = simulation_of(with(pool + "[body]\nmin = [0.4, 0.1]\nmax = [0.6, 0.2]\n", "1"));
  const double lift = mean_of(sim, 0.5, [](Simulation& s) { return s.bodies()[0].force[1]; });
  EXPECT_NEAR(9.81 * 1000 * 0.2 * 0.1, lift, 0.05 * 9.81 * 20);
  EXPECT_DOUBLE_EQ(0.15, sim.bodies()[0].position[1]) << "a fixed body moved";
}

/// Momentum of the fluid and of the free bodies.
std::array<double, 3> momentum_of(const Simulation& sim) {
  const Statistics s = sim.statistics();
  std::array<double, 3> p{};
  for (std::size_t d = 0; d < s.momentum.size(); ++d) p[d] = s.momentum[d];
  for (std::size_t k = 0; k < sim.bodies().size(); ++k) {
    const Scene::Body& b = sim.scene().body[k];
    const double mass = b.mass.value_or(b.density.value_or(0) * body_shape(b).volume);
    for (std::size_t d = 0; d < 3; ++d) p[d] += mass * sim.bodies()[k].velocity[d];
  }
  return p;
}

// A jet hits a box off its centre, across the ends of a periodic domain.
TEST_P(Bodies, ConserveMomentum) {
  Simulation sim = simulation_of(
      with("[domain]\nmax = [1, 1]\nperiodic = \"xy\"\ngravity = [0, 0]\n[particles]\n"
           "spacing = 0.025\n[fluid]\nmin = [0.6, 0.1]\nmax = [0.9, 0.5]\nvelocity = [1, 0.1]\n"
           "[body]\nmin = [-0.05, 0.3]\nmax = [0.1, 0.6]\nmotion = \"free\"\ndensity = 700\n"
           "velocity = [-0.5, 0]\n",
           "0.4", weakly() ? "sound_speed = 15\n" : ""));
  const auto before = momentum_of(sim);
  while (!sim.finished()) sim.step();
  const auto after = momentum_of(sim);
  EXPECT_GT(std::abs(sim.bodies()[0].velocity[0] + 0.5), 0.2) << "the jet must hit the box";
  EXPECT_GT(std::abs(sim.bodies()[0].angular_velocity[2]), 0.2) << "the jet must turn the box";
  const double most = std::abs(before[0]) + 31.5 * 0.5;
  // pbf corrects positions of particles, but the velocity of a body.
  const double share = GetParam().solver == std::string("pbf") ? 5e-3 : 2e-5;
  for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(before[d], after[d], share * most) << d;
}

TEST_P(ThinBodies, LetNoParticleThrough) {
  Simulation sim =
      simulation_of(with("[domain]\nmax = [1, 0.4]\n[particles]\nspacing = 0.02\n"
                         "[fluid]\nmin = [0.4, 0]\nmax = [0.8, 0.2]\n"
                         "[body]\nmin = [0.38, 0]\nmax = [0.4, 0.4]\nmotion = \"moved\"\n"
                         "interpolation = \"linear\"\n[[body.key]]\ntime = 0\n"
                         "[[body.key]]\ntime = 0.2\ntranslation = [0.2, 0]\n",
                         "0.4"));
  while (!sim.finished()) sim.step();
  const ParticleView f = sim.fluid();
  EXPECT_NEAR(0.59, sim.bodies()[0].position[0], 1e-9);
  for (std::size_t i = 0; i < f.size(); ++i)
    EXPECT_GT(double(f.x[2 * i]), 0.59) << "particle " << f.id[i];
  EXPECT_GT(level_of(sim), 0.25) << "the water rose";
}

/// Bodies of several layers of body particles.
class LayeredBodies : public Bodies {};
INSTANTIATE_TEST_SUITE_P(Solvers, LayeredBodies,
                         ::testing::Values(layered_wcsph, layered_delta_sph));

TEST_P(LayeredBodies, PushWaterAndLetNoParticleThrough) {
  Simulation sim =
      simulation_of(with("[domain]\nmax = [1, 0.4]\n[particles]\nspacing = 0.02\n"
                         "[fluid]\nmin = [0.4, 0]\nmax = [0.8, 0.2]\n"
                         "[body]\nmin = [0.34, 0]\nmax = [0.4, 0.4]\nmotion = \"moved\"\n"
                         "interpolation = \"linear\"\n[[body.key]]\ntime = 0\n"
                         "[[body.key]]\ntime = 0.2\ntranslation = [0.2, 0]\n",
                         "0.4"));
  double force = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() < 0.2) force = std::min(force, sim.bodies()[0].force[0]);
  }
  const ParticleView f = sim.fluid();
  EXPECT_NEAR(0.57, sim.bodies()[0].position[0], 1e-9);
  for (std::size_t i = 0; i < f.size(); ++i)
    EXPECT_GT(double(f.x[2 * i]), 0.6) << "particle " << f.id[i];
  EXPECT_GT(level_of(sim), 0.25) << "the water rose";
  EXPECT_LT(force, -200) << "the force must exceed the hydrostatic one of 0.2 m of water";
}

TEST_P(LayeredBodies, FloatAtTheDepthOfTheirDensity) {
  Simulation sim = simulation_of(with(
      pool + "[body]\nmin = [0.3, 0.22]\nmax = [0.7, 0.42]\nmotion = \"free\"\ndensity = 500\n",
      "1.5"));
  const double particles = double(sim.fluid().size()), spacing = 0.02;
  const double y = mean_of(sim, 0.8, [](Simulation& s) { return s.bodies()[0].position[1]; });
  EXPECT_NEAR(particles * spacing * spacing + 0.4 * 0.1, y, 0.02 * 0.2);
  EXPECT_NEAR(0, sim.bodies()[0].orientation[2], 0.02) << "it lies level";
}

// Body particles a support radius away from water see it with a tiny weight, (1 - r/support)^6.
TEST_P(LayeredBodies, StayStableWithWendlandC4) {
  Simulation sim = simulation_of(
      std::string(
          "[domain]\nmax = [1.2, 0.9]\n[particles]\nspacing = 0.02\nsupport_radius = 0.1\n"
          "[fluid]\nmin = [0, 0]\nmax = [1.2, 0.5]\npressure = \"hydrostatic\"\n"
          "[body]\nmin = [0.4, 0.42]\nmax = [0.8, 0.62]\nmotion = \"free\"\n"
          "density = 500\nslip = \"free_slip\"\n[walls]\nmethod = \"adami2012\"\nslip = "
          "\"free_slip\"\n[solver]\nkernel = \"wendland_c4\"\nsound_speed = 31\nname = \"") +
      GetParam().solver + "\"\n[time]\nend = 0.02\nstep = 3e-4\n");
  while (!sim.finished()) sim.step();
  for (const Real x : sim.fluid().x) ASSERT_TRUE(std::isfinite(double(x)));
  EXPECT_LT(sim.statistics().speed_max, 1);
}

// A tank under gravity and one without, accelerated upwards by g, are equivalent.
TEST_P(LayeredBodies, AcceleratedTankActsLikeGravity) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const double g = 9.81, end = 0.15;
  const auto water = [&](double gravity, const std::string& motion) {
    std::string text = "[domain]\nmax = [1, 1]\ngravity = [0, " + std::to_string(-gravity) +
                       "]\n[particles]\nspacing = 0.02\n"
                       "[fluid]\nmin = [0.3, 0.28]\nmax = [0.7, 0.42]\n";
    for (const char* corners :
         {"min = [0.3, 0.2]\nmax = [0.7, 0.28]\n", "min = [0.22, 0.2]\nmax = [0.3, 0.6]\n",
          "min = [0.7, 0.2]\nmax = [0.78, 0.6]\n"})
      text += "[[body]]\n" + (corners + motion);
    const std::string delta_sph = GetParam().solver == std::string("delta_sph")
                                      ? "density_diffusion = \"antuono2010\"\n"
                                      : "";
    return simulation_of(
        text + "[walls]\nmethod = \"adami2012\"\n[solver]\nsound_speed = 20\nname = \"" +
        GetParam().solver + "\"\n" + delta_sph + "[time]\nend = " + std::to_string(end) +
        "\nstep = 2e-4\nintegrator = \"leapfrog\"\n");
  };
  Simulation heavy = water(g, ""),
             lifted = water(0, "motion = \"moved\"\nposition = [\"0\", \"4.905*t^2\"]\n");
  while (!heavy.finished()) heavy.step();
  while (!lifted.finished()) lifted.step();
  std::vector<double> y(heavy.fluid().size());
  for (std::size_t i = 0; i < y.size(); ++i)
    y[heavy.fluid().id[i]] = double(heavy.fluid().x[2 * i + 1]);
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_NEAR(y[lifted.fluid().id[i]] + g * end * end / 2, double(lifted.fluid().x[2 * i + 1]),
                1e-3 * 0.02);
  const double weight = g * 1000 * 0.4 * 0.14;
  EXPECT_NEAR(heavy.bodies()[0].force[1], lifted.bodies()[0].force[1], 0.01 * weight);
}

/// Two boxes that collide, a wheel and a moving wall, across the ends of a periodic domain.
std::string crowd(bool flat) {
  const auto vector = [&](double x, double y) {
    return "[" + std::to_string(x) + ", " + std::to_string(y) + (flat ? "]" : ", 0.2]");
  };
  const auto corner = [&](double x, double y) {
    return "[" + std::to_string(x) + ", " + std::to_string(y) + (flat ? "]" : ", 0.35]");
  };
  std::string text = flat ? "[domain]\nmax = [1, 1]\n" : "[domain]\nmax = [1, 1, 0.6]\n";
  text += "periodic = \"x\"\n[particles]\nspacing = 0.05\njitter = 0.002\n[[fluid]]\nmin = ";
  text += flat ? "[0, 0]\nmax = [1, 0.5]\n" : "[0, 0, 0]\nmax = [1, 0.4, 0.6]\n";
  text += "[[body]]\nname = \"a\"\nmin = " + vector(0.2, 0.4) + "\nmax = " + corner(0.4, 0.55) +
          "\nmotion = \"free\"\ndensity = 600\nangular_velocity = 2\n";
  text += "[[body]]\nname = \"b\"\nmin = " + vector(0.22, 0.56) + "\nmax = " + corner(0.42, 0.7) +
          "\nmotion = \"free\"\ndensity = 400\nvelocity = " + (flat ? "[0, -1]" : "[0, -1, 0]") +
          "\n";
  text += "[[body]]\nname = \"wheel\"\nshape = \"sphere\"\ncenter = " + vector(0.7, 0.3) +
          "\nradius = 0.12\nmotion = \"free\"\ndensity = 800\n";
  text += "[[body]]\nname = \"wall\"\nmin = " + vector(0.95, 0.1) + "\nmax = " + corner(1.05, 0.8) +
          "\nmotion = \"moved\"\n[[body.key]]\ntime = 0\n[[body.key]]\ntime = 0.1\nangle = 9\n"
          "translation = " +
          (flat ? "[0.1, 0]\n" : "[0.1, 0, 0]\n");
  return text + "[joint]\nbody = \"wheel\"\npoint = " + vector(0.7, 0.3) +
         "\nmotor_speed = 5\nmotor_torque = 10\n";
}

TEST_P(Bodies, HaveTheSameBits) {
  for (const bool flat : {true, false}) expect_same_bits(with(crowd(flat), "1"), 20);
}

TEST_P(Bodies, ResumeFromACheckpointToTheSameBits) {
  expect_same_bits_after_restart(with(crowd(true), "1"), 9, 9);
}

// One box flies at another across the seam, and a third lies on the floor: the checkpoint falls
// between contacts.
TEST_P(Bodies, ResumeAmidContactsToTheSameBits) {
  expect_same_bits_after_restart(
      with("[domain]\nmax = [1, 1]\nperiodic = \"x\"\n[particles]\nspacing = 0.05\n"
           "[fluid]\nmin = [0.3, 0]\nmax = [0.6, 0.2]\n"
           "[[body]]\nmin = [0.78, 0.5]\nmax = [0.94, 0.65]\nmotion = \"free\"\ndensity = 600\n"
           "velocity = [10, 0]\n"
           "[[body]]\nmin = [0.01, 0.52]\nmax = [0.16, 0.67]\nmotion = \"free\"\n"
           "density = 400\n"
           "[[body]]\nmin = [0.7, 0.0]\nmax = [0.85, 0.15]\nmotion = \"free\"\n"
           "density = 2000\nangular_velocity = 1\n",
           "1"),
      9, 9);
}

// Couette flow between a wall and a moving plate: v = V y/H.
TEST(MovedBodies, DragTheFluidAlong) {
  if (!has_solver(SolverName::dfsph)) GTEST_SKIP() << "not compiled in this build";
  Simulation sim = simulation_of(
      "[domain]\nmax = [0.2, 0.3]\nperiodic = \"x\"\ngravity = [0, 0]\n[particles]\n"
      "spacing = 0.01\n[fluid]\nmin = [0, 0]\nmax = [0.2, 0.2]\n"
      "viscosity = 100\n"
      "[[body]]\nmin = [0, 0.2]\nmax = [0.2, 0.25]\nmotion = \"moved\"\n"
      "interpolation = \"linear\"\n[[body.key]]\ntime = 0\n"
      "[[body.key]]\ntime = 1\ntranslation = [1, 0]\n"
      "[solver]\nname = \"dfsph\"\nxsph = 0\n[time]\nend = 0.25\nstep = \"adaptive\"\n"
      "step_max = 0.001\n");
  while (!sim.finished()) sim.step();
  const ParticleView f = sim.fluid();
  double sum2 = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    sum2 += std::pow(double(f.x[2 * i + 1]) / 0.2 - double(f.v[2 * i]), 2);
  EXPECT_LT(std::sqrt(sum2 / double(f.size())), 0.25)
      << "0.577 without drag; 0.02 to 0.2 for starts that differ by 0.01 mm, since layers of "
         "particles slip over each other";
  const double drag = sim.bodies()[0].force[0];
  EXPECT_LT(drag, -60) << "exact: mu V/H times the length, 100 N/m; a lattice gives less";
}

// A body of a quarter of the water's density in a narrow well: its added mass is many times its
// own.
TEST_P(Bodies, StayCalmIfTheyAreLight) {
  Simulation sim = simulation_of(
      with("[domain]\nmax = [0.5, 0.8]\n[particles]\nspacing = 0.025\n"
           "[fluid]\nmin = [0, 0]\nmax = [0.5, 0.3]\npressure = \"hydrostatic\"\n"
           "[body]\nmin = [0.05, 0.25]\nmax = [0.45, 0.45]\nmotion = \"free\"\ndensity = 250\n",
           "1"));
  double most = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() > 0.1) most = std::max(most, std::abs(sim.bodies()[0].velocity[1]));
  }
  EXPECT_LT(most, 1);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Simulations that show a frame, to be measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "freshet/checkpoint.h"
#include "sim/forced.h"
#include "sim/surfaces.h"

namespace freshet::test {
namespace {

std::string basin(const std::string& solver, const std::string& walls,
                  const std::string& more = "") {
  return "[domain]\nmax = [1.0, 0.8]\n[particles]\nspacing = 0.05\n[[fluid]]\nmin = [0, 0]\nmax = "
         "[0.6, 0.5]\n" +
         more + "[walls]\nmethod = \"" + walls + "\"\n[solver]\nname = \"" + solver + "\"\n" +
         (solver == "delta_sph" || solver == "wcsph" ? "sound_speed = 30\n" : "") +
         "[time]\nend = 1\nstep = " +
         (solver == "wcsph" || solver == "delta_sph" ? "0.0005" : "0.002") + "\n";
}

double largest(const std::vector<Vector>& forces) {
  double most = 0;
  for (const Vector& force : forces)
    for (const double f : force) most = std::max(most, std::abs(f));
  return most;
}

void expect_near(const std::vector<Vector>& a, const std::vector<Vector>& b, double share) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t w = 0; w < a.size(); ++w)
    for (std::size_t d = 0; d < a[w].size(); ++d)
      EXPECT_NEAR(a[w][d], b[w][d], share * largest(a)) << "wall " << w << ", axis " << d;
}

/// The forces on walls after 100 steps, in the simulation and in one that shows its frame.
void expect_shown_forces(const std::string& scene, double share) {
  Simulation sim = simulation_of(scene), shown = simulation_of(scene);
  for (int k = 0; k < 100; ++k) sim.step();
  const std::vector<Vector> own = sim.wall_forces();
  shown.show(sim.frame());
  EXPECT_EQ(sim.time(), shown.time());
  EXPECT_EQ(sim.frame().density, shown.frame().density);
  EXPECT_EQ(sim.frame().pressure, shown.frame().pressure);
  EXPECT_EQ(sim.frame().x, shown.frame().x);
  EXPECT_GT(largest(own), 1);
  expect_near(own, shown.wall_forces(), share);
  if (shown.scene().side_method(0) == WallMethod::ghost) return;  // no boundary particles
  auto parts = forces_on_parts(shown.scene(), shown.boundary_forces());
  parts.resize(own.size());
  expect_near(shown.wall_forces(), parts, 1e-5);
}

struct Basin {
  const char *solver, *walls;
};
void PrintTo(const Basin& b, std::ostream* out) { *out << b.solver << ", " << b.walls; }
class ShownFrame : public ::testing::TestWithParam<Basin> {
  void SetUp() override {
    if (!compiled(GetParam().solver)) GTEST_SKIP() << "not compiled in this build";
  }
};

/// The run extrapolates the pressure of adami2012, and makes the images of ghost, within the step;
/// a frame has the places after it.
double tolerance(const Basin& b) {
  const std::string walls = b.walls;
  return walls == "adami2012" || walls == "ghost" ? 0.02 : 1e-5;
}

TEST_P(ShownFrame, HasTheForcesOfItsState) {
  expect_shown_forces(basin(GetParam().solver, GetParam().walls), tolerance(GetParam()));
}

TEST_P(ShownFrame, HasTheForcesOfSeveralLiquids) {
  expect_shown_forces(basin(GetParam().solver, GetParam().walls,
                            "[[fluid]]\nmin = [0.6, 0]\nmax = [1, 0.5]\nrest_density = 800\n"),
                      tolerance(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Solvers, ShownFrame,
                         ::testing::Values(Basin{"wcsph", "akinci2012"},
                                           Basin{"wcsph", "adami2012"},
                                           Basin{"delta_sph", "adami2012"},
                                           Basin{"delta_sph", "monaghan2009"},
                                           Basin{"dfsph", "akinci2012"}, Basin{"dfsph", "ghost"},
                                           Basin{"pbf", "akinci2012"}));

TEST(Show, ReplacesTheFluidAndTheBodies) {
  const std::string scene =
      basin("wcsph", "akinci2012",
            "[[body]]\nname = \"gate\"\nmin = [0.7, 0.0]\nmax = [0.75, 0.5]\nmotion = \"moved\"\n"
            "key = [{ time = 0, translation = [0, 0] }, { time = 1, translation = [0, 0.4] }]\n");
  Simulation sim = simulation_of(scene);
  Frame frame = sim.frame();
  frame.time = 0.5;
  frame.step = 7;
  frame.id.resize(10);
  for (auto* field : {&frame.density, &frame.pressure}) field->resize(10);
  for (auto* field : {&frame.x, &frame.v}) field->resize(20);
  frame.id[9] = 1000;
  frame.bodies[0].position[1] += 0.2;
  sim.show(frame);
  EXPECT_EQ(10u, sim.fluid().size());
  EXPECT_EQ(1000u, sim.frame().id.back());
  EXPECT_EQ(7, sim.steps_done());
  EXPECT_EQ(frame.bodies[0].position, sim.bodies()[0].position);
  const BoundaryForces boundary = sim.boundary_forces();
  double low = 1, count = 0;
  for (std::size_t k = 0; k < boundary.size(); ++k)
    if (boundary.part[k] == 4) low = std::min(low, boundary.x[2 * k + 1]), ++count;
  EXPECT_EQ(count, 10);
  EXPECT_NEAR(0.2, low, 0.06) << "the body particles must be where the frame has the body";
}

TEST(Show, TakesNoStepUntilItIsRestored) {
  const std::string scene = basin("wcsph", "akinci2012");
  Simulation sim = simulation_of(scene), plain = simulation_of(scene);
  for (int k = 0; k < 5; ++k) sim.step(), plain.step();
  const Checkpoint checkpoint = sim.checkpoint();
  Frame frame = sim.frame();
  frame.id.resize(3);
  for (auto* field : {&frame.density, &frame.pressure}) field->resize(3);
  for (auto* field : {&frame.x, &frame.v}) field->resize(6);
  sim.show(frame);
  EXPECT_THROW(sim.step(), Error);
  EXPECT_THROW(sim.checkpoint(), Error);
  sim.restore(checkpoint);
  for (int k = 0; k < 5; ++k) sim.step(), plain.step();
  EXPECT_EQ(plain.kept_sha256(), sim.kept_sha256());
}

TEST(Show, RejectsAFrameOfAnotherScene) {
  Simulation sim = simulation_of(basin("wcsph", "akinci2012"));
  const Frame good = sim.frame();
  const auto rejects = [&](auto change) {
    Frame frame = good;
    change(frame);
    EXPECT_THROW(sim.show(frame), Error);
  };
  rejects([](Frame& f) { f.dimension = 3; });
  rejects([](Frame& f) { f.x.pop_back(); });
  rejects([](Frame& f) { f.density.clear(); });
  rejects([](Frame& f) { f.bodies.emplace_back(); });
  rejects([](Frame& f) { f.liquid.assign(f.size(), 3); });
  sim.step();  // nothing has changed
}

}  // namespace
}  // namespace freshet::test

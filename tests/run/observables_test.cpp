// SPDX-License-Identifier: MIT
#include "run/observables.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// Two particles that move apart at rest density and do not interact.
constexpr const char* two_particles = R"(
[domain]
max = [2.0, 1.0]
gravity = [0.0, 0.0]
[particles]
spacing = 0.1
[[fluid]]
shape = "lattice"
from = [0.5, 0.5]
count = [1, 1]
velocity = [-1.0, 0.0]
[[fluid]]
shape = "lattice"
from = [1.5, 0.5]
count = [1, 1]
velocity = [2.0, 0.5]
[solver]
name = "mueller2003"
stiffness = 4.0
[time]
end = 0.01
step = 0.001
)";

TEST(Observables, NameEveryColumnWithItsUnit) {
  EXPECT_EQ(
      "step,time [s],time step [s],ruled by,least bound [s],kinetic energy [J/m],"
      "potential energy [J/m],momentum x [(kg m/s)/m],momentum y [(kg m/s)/m],"
      "angular momentum z [(kg m^2/s)/m],"
      "density mean [kg/m^3],density max [kg/m^3],density error mean [%],density error max "
      "[%],speed mean [m/s],"
      "speed max [m/s],fastest particle,force on x_min x [N/m],force on x_min y [N/m],"
      "force on x_max x [N/m],force on x_max y [N/m],force on y_min x [N/m],force on y_min y [N/m],"
      "force on y_max x [N/m],force on y_max y [N/m]\n",
      observables_header(simulation_of(two_particles).scene()));
}

TEST(Observables, NameThreeAxesAndQuoteWallNames) {
  Scene scene;
  scene.domain.max = {1, 1, 1};
  scene.wall.resize(1);
  scene.wall[0].name = "rock, \"big\"\nand wet";
  const std::string header = observables_header(scene);
  EXPECT_NE(std::string::npos, header.find(",momentum z [kg m/s],angular momentum x [kg m^2/s],"));
  EXPECT_NE(std::string::npos, header.find(",force on z_max z [N],"
                                           "\"force on rock, \"\"big\"\" and wet x [N]\","));
}

TEST(Observables, NameTheSolvesOfEachSolver) {
  Scene scene;
  scene.domain.max = {1, 1};
  const auto solves = [&](SolverName name) {
    scene.solver.name = name;
    const std::string header = observables_header(scene), front = ",least bound [s]",
                      back = ",kinetic energy [J/m]";
    const auto from = header.find(front) + front.size();
    return header.substr(from, header.find(back) - from);
  };
  for (const auto name : {SolverName::mueller2003, SolverName::wcsph, SolverName::delta_sph})
    EXPECT_EQ("", solves(name));
  for (const auto name : {SolverName::pcisph, SolverName::iisph, SolverName::pbf})
    EXPECT_EQ(",density iterations,density solve error [%]", solves(name));
  EXPECT_EQ(
      ",divergence iterations,divergence solve error [%],density iterations,"
      "density solve error [%]",
      solves(SolverName::dfsph));
}

TEST(Observables, HaveTheExpectedNumbers) {
  Simulation sim = simulation_of(two_particles);
  sim.step();
  const std::vector<Vector> forces{{1, 2}, {3, 4}, {0, 0}, {-0.5, 1e-9}};
  // Mass: 1000 kg/m^3 · 0.01 m^2 = 10 kg/m. Limit: 0.4 · 0.1 m/(2 m/s + √4.25 m/s). Density: 10
  // kg/m · Poly6(0) = 4/(π · 0.04 m^2), divided by the lattice sum 4/(π · 4) (1 + 4 · 0.75^3 + 4 ·
  // 0.5^3). Angular momentum: 10 kg/m (-0.5 · -1 + 1.5 · 0.5 - 0.5 · 2) m^2/s.
  EXPECT_EQ(
      "1,0.001,0.001,fixed,0.0098484502,26.25,0,10,5,2.4999994,"
      "313.725494,313.725494,0,0,1.53077641,2.06155281,1,1,2,3,4,0,0,"
      "-0.5,1e-09\n",
      observables_line(sim, forces));
}

TEST(Observables, ContainTheSolvesOfTheLastStep) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\n"
      "max = [0.5, 0.5]\n[solver]\nname = \"dfsph\"\n[time]\nend = 0.05\nstep = 0.0005\n");
  const auto fields = [](const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) all.push_back(field);
    return all;
  };
  const auto names = fields(observables_header(sim.scene()));
  const std::vector<Vector> forces(sim.scene().wall_names().size(), {0, 0});
  const auto solves_in = [&](const std::string& line) {
    const auto all = fields(line);
    EXPECT_EQ(names.size(), all.size());
    return std::vector(all.begin() + 5, all.begin() + 9);
  };
  EXPECT_EQ((std::vector<std::string>{"0", "0", "0", "0"}),
            solves_in(observables_line(sim, forces)));
  for (int k = 0; k < 3; ++k) sim.step();
  ASSERT_EQ(2u, sim.solves().size());
  std::vector<std::string> expected;
  for (const SolveStatistics& s : sim.solves()) {
    EXPECT_GT(s.last_iterations, 0);
    expected.push_back(std::to_string(s.last_iterations));
    expected.push_back(fmt::format("{:.9g}", 100 * s.last_error));
  }
  EXPECT_EQ(expected, solves_in(observables_line(sim, forces)));
}

TEST(Observables, NameTheLimitOfTheLastStep) {
  const std::string fixed(two_particles);
  const std::string adaptive =
      fixed.substr(0, fixed.find("end = ")) + "end = 1.0\nstep = \"adaptive\"\nstep_max = ";
  const auto ruled = [&](const std::string& step_max) {
    Simulation sim = simulation_of(adaptive + step_max);
    sim.step();
    return sim.time_steps().last_ruled;
  };
  EXPECT_EQ("step_max", ruled("0.001"));
  EXPECT_EQ("sound", ruled("0.1"));
  Simulation sim = simulation_of(fixed);
  EXPECT_EQ("", sim.time_steps().last_ruled);
  sim.step();
  EXPECT_EQ("fixed", sim.time_steps().last_ruled);
}

TEST(Statistics, DensityErrorsArePositiveErrorsOnly) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\n"
      "max = [0.5, 0.5]\n[solver]\nname = \"wcsph\"\nsound_speed = 30.0\n[time]\nend = 0.05\n"
      "step = 0.0003\n");
  while (!sim.finished()) sim.step();
  double sum = 0, most = 0;
  for (const Real density : sim.fluid().density) {
    sum += std::max(0.0, double(density) / 1000 - 1);
    most = std::max(most, double(density) / 1000 - 1);
  }
  const Statistics s = sim.statistics();
  EXPECT_GT(s.density_error_mean, 0);
  EXPECT_NEAR(sum / double(sim.fluid().size()), s.density_error_mean, 1e-15);
  EXPECT_EQ(most, s.density_error_max);
  EXPECT_LT(s.density_min, 1000);  // particles below rest density do not count
}

TEST(Statistics, NameTheFastestParticleOrTheLowestIdOfEquals) {
  Simulation sim = simulation_of(two_particles);
  EXPECT_EQ(1u, sim.statistics().fastest);
  std::string still = two_particles;
  still.replace(still.find("velocity = [2.0, 0.5]"), 21, "velocity = [0.0, 1.0]");
  EXPECT_EQ(0u, simulation_of(still).statistics().fastest);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Initial positions, velocities and densities of fluids.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/derived.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

constexpr const char* weakly_compressible = "solver.name = \"wcsph\"\nwalls.method = \"open\"\n";

std::size_t particles_of(const Scene& scene) { return sample(scene).density.size(); }

TEST(SampleFluid, FillsABoxIn3DWithXFastest) {
  const Sample s = sample(scene_with("[1, 1, 1]", 0.1,
                                     "[fluid]\nmin = [0, 0, 0]\nmax = [0.3, 0.2, 0.4]\n"
                                     "velocity = [1, 2, 3]\n"));
  ASSERT_EQ(3u * 2 * 4 * 3, s.x.size());
  EXPECT_NEAR(0.05, s.x[0], 1e-6);
  EXPECT_NEAR(0.15, s.x[3], 1e-6);              // x is fastest
  EXPECT_NEAR(0.15, s.x[3 * 3 + 1], 1e-6);      // then y
  EXPECT_NEAR(0.15, s.x[3 * 2 * 3 + 2], 1e-6);  // then z
  EXPECT_EQ(Real(3), s.v[5]);
  EXPECT_EQ(Real(1000), s.density[0]);
  EXPECT_EQ(0, s.outside + s.left_out);
}

TEST(SampleFluid, DrawsTheJitterOfTheLastAxisFirst) {
  const char* fluid = "[fluid]\nshape = \"lattice\"\nfrom = [0.5, 0.5, 0.5]\ncount = [1, 1, 1]\n";
  const Sample in_3d =
      sample(scene_with("[1, 1, 1]", 0.1, std::string("particles.jitter = 0.01\n") + fluid));
  const Sample in_2d = sample(scene_with("[1, 1]", 0.1,
                                         "particles.jitter = 0.01\n[fluid]\nshape = "
                                         "\"lattice\"\nfrom = [0.5, 0.5]\ncount = [1, 1]\n"));
  EXPECT_EQ(in_2d.x[1], in_3d.x[2]);  // drawn first
  EXPECT_EQ(in_2d.x[0], in_3d.x[1]);
}

TEST(SampleFluid, FillsABallAndItsOutside) {
  const std::string ball = "shape = \"sphere\"\ncenter = [0.5, 0.5, 0.5]\nradius = 0.4\n";
  const std::string rest = weakly_compressible;
  const Scene inside = scene_with("[1, 1, 1]", 0.05, rest + "[fluid]\n" + ball);
  const Sample s = sample(inside);
  const double volume = 4.0 / 3 * 3.14159265 * std::pow(0.4, 3);
  EXPECT_NEAR(volume, double(s.density.size()) * std::pow(0.05, 3), 0.02 * volume);
  for (std::size_t i = 0; i < s.x.size(); i += 3)
    EXPECT_LT(std::hypot(s.x[i] - 0.5, s.x[i + 1] - 0.5, s.x[i + 2] - 0.5), 0.4);
  const Scene outside =
      scene_with("[1, 1, 1]", 0.05, rest + "[fluid]\nside = \"outside\"\n" + ball);
  EXPECT_EQ(20u * 20 * 20, s.density.size() + particles_of(outside));
}

TEST(SampleFluid, FillsACylinderAlongItsAxis) {
  const Scene scene = scene_with("[1, 1, 1]", 0.05,
                                 "[fluid]\nshape = \"cylinder\"\ncenter = [0.5, 0.5, 0.5]\n"
                                 "radius = 0.2\nlength = 0.8\naxis = [3, 0, 0]\n");
  const Sample s = sample(scene);
  for (std::size_t i = 0; i < s.x.size(); i += 3) {
    EXPECT_LT(std::hypot(s.x[i + 1] - 0.5, s.x[i + 2] - 0.5), 0.2);
    EXPECT_LT(std::abs(s.x[i] - 0.5), 0.4);
  }
  EXPECT_NEAR(3.14159 * 0.04 * 0.8, double(s.density.size()) * std::pow(0.05, 3), 0.005);
}

TEST(SampleFluid, FillsTheDomainBelowAPlane) {
  const Scene level =
      scene_with("[1, 1]", 0.1, "[fluid]\nshape = \"plane\"\npoint = [0, 0.4]\nnormal = [0, 2]\n");
  EXPECT_EQ(40u, particles_of(level));
  const Scene slope = scene_with(
      "[1, 1]", 0.1, "[fluid]\nshape = \"plane\"\npoint = [0, 0.55]\nnormal = [-1, 2]\n");
  const Sample s = sample(slope);
  for (std::size_t i = 0; i < s.x.size(); i += 2) EXPECT_LT(s.x[i + 1], 0.55 + s.x[i] / 2);
  EXPECT_NEAR(80, double(s.density.size()), 5);
}

TEST(SampleFluid, ExcludesPlacesInAWall) {
  const Scene scene = scene_with("[1, 1]", 0.05,
                                 "[fluid]\nmin = [0, 0]\nmax = [1, 1]\n"
                                 "[wall]\nshape = \"sphere\"\ncenter = [0.5, 0.5]\nradius = 0.2\n");
  const Sample s = sample(scene);
  EXPECT_EQ(400u, s.density.size() + std::size_t(s.left_out));
  EXPECT_NEAR(3.14159 * 0.2 * 0.2 / 0.0025, double(s.left_out), 1);
  for (std::size_t i = 0; i < s.x.size(); i += 2)
    EXPECT_GT(std::hypot(s.x[i] - 0.5, s.x[i + 1] - 0.5), 0.2 + 0.29 * 0.05);
  const Derived d = derive(scene);
  EXPECT_EQ(double(s.density.size()), d.particles);
  EXPECT_EQ(s.left_out, d.left_out);
}

// A lattice that does not fit starts away from sampled sides. It fills 26.67 places of the box.
TEST(SampleFluid, ExcludesPlacesNearASampledSide) {
  const std::string held = "solver.name = \"wcsph\"\nwalls.method = \"akinci2012\"\n";
  const std::string box = "[fluid]\nmin = [0, 0]\nmax = [1, 0.6]\n";
  const Sample s = sample(scene_with("[1, 1]", 0.15, held + box));
  EXPECT_EQ(27u, s.density.size());  // one of seven columns is 0.17 spacings from the side
  EXPECT_EQ(1, s.left_out);
  EXPECT_EQ(7u * 4,
            particles_of(scene_with("[1, 1]", 0.15, held + "walls.x_max = \"open\"\n" + box)));
}

TEST(SampleFluid, ExcludesPlacesNearAWallOfPoints) {
  const TemporaryFolder folder;
  write_text(folder / "two.csv", "x,y\n0.25,0.26\n0.3,0.3\n");
  write_text(folder / "scene.toml",
             "domain.max = [1, 1]\nparticles.spacing = 0.1\ntime = { end = 0.01, step = 1e-4 }\n"
             "solver.name = \"wcsph\"\n[fluid]\nmin = [0, 0]\nmax = [1, 1]\n"
             "[wall]\nshape = \"points\"\nfile = \"two.csv\"\n");
  EXPECT_EQ(1, sample(load_scene(folder / "scene.toml")).left_out);
}

TEST(SampleFluid, KeepsPlacesHalfASpacingFromAWall) {
  const Scene scene = scene_with("[1, 1]", 0.1,
                                 "[fluid]\nmin = [0, 0.2]\nmax = [1, 0.6]\n"
                                 "[wall]\nshape = \"box\"\nmin = [0, 0]\nmax = [1, 0.2]\n");
  EXPECT_EQ(0, sample(scene).left_out);
}

/// A hydrostatic column is consistent: the sum of m/rho below a particle is its height.
void expect_equilibrium(const std::string& solver) {
  const double dx = 0.02;
  const Scene scene = scene_with("[1, 2]", dx,
                                 solver +
                                     "[fluid]\nmin = [0, 0]\nmax = [0.1, 1]\n"
                                     "pressure = \"hydrostatic\"\nrest_density = 800\n");
  const Derived d = derive(scene);
  const Sample s = sample(scene);
  double below = 0, top = 0;
  for (std::size_t i = 0; i < s.density.size(); i += 5) {  // the first column, upwards
    const double height = double(s.x[2 * i + 1]), rho = double(s.density[i]);
    const double depth = 1 - (double(i) / 5 + 0.5) * dx, p = 800 * 9.81 * depth;
    const double ratio = rho / 800;
    const bool mueller = scene.solver.name == SolverName::mueller2003;
    const double of_state = mueller
                                ? d.stiffness * (rho - 800)
                                : 800 * std::pow(d.sound_speed, 2) / 7 * (std::pow(ratio, 7) - 1);
    EXPECT_NEAR(p, of_state, 2e-3 * 800 * 9.81);
    EXPECT_NEAR(below + dx / ratio / 2, height, 1e-5);
    below += dx / ratio;
    top = height;
  }
  EXPECT_LT(top, 1 - dx / 2);
  EXPECT_GT(top, 0.9);
}
TEST(SampleFluid, HydrostaticColumnIsInEquilibrium) {
  expect_equilibrium("");
  expect_equilibrium("solver = { name = \"wcsph\", sound_speed = 20.0 }\n");
  expect_equilibrium("solver = { name = \"delta_sph\" }\n");
}

TEST(SampleFluid, HydrostaticColumnIsCompressedAlongGravity) {
  const Sample s =
      sample(scene_with("[1, 1]", 0.1,
                        "domain.gravity = [9.81, 0]\nsolver.stiffness = 50.0\n[fluid]\n"
                        "min = [0.5, 0]\nmax = [1, 0.5]\n"
                        "pressure = \"hydrostatic\"\n"));
  EXPECT_GT(s.x[0], 0.551);
  EXPECT_NEAR(1 - 0.05 / (1 + 9.81 * 0.475 / 50), s.x[8], 1e-4);  // the lowest particle
  EXPECT_EQ(Real(0.05), s.x[1]);
  EXPECT_GT(s.density[4], s.density[0]);
}

TEST(SampleFluid, UsesThePointsOfAFile) {
  const TemporaryFolder folder;
  write_text(folder / "drop.csv", "x,y,vx,vy\n0.5,0.5,1,0\n0.6,0.5,0,-1\n");
  write_text(folder / "scene.toml",
             "domain.max = [1, 1]\nparticles.spacing = 0.1\ntime = { end = 0.01, step = 1e-4 }\n"
             "[fluid]\nshape = \"points\"\nfile = \"drop.csv\"\n");
  const Sample s = sample(load_scene(folder / "scene.toml"));
  EXPECT_EQ((std::vector<Real>{Real(0.5), Real(0.5), Real(0.6), Real(0.5)}), s.x);
  EXPECT_EQ((std::vector<Real>{1, 0, 0, -1}), s.v);
}

/// A scene with points at distances from a wall, whose surface is at x = 0.5: in it, and before it.
Scene points_at_a_wall(const TemporaryFolder& folder) {
  write_text(folder / "state.csv", "x,y,id\n0.45,0.5,0\n0.501,0.5,1\n0.6,0.5,2\n0.7,0.5,3\n");
  write_text(folder / "scene.toml",
             "domain.max = [1, 1]\nparticles.spacing = 0.1\ntime = { end = 0.01, step = 1e-4 }\n"
             "[fluid]\nshape = \"points\"\nfile = \"state.csv\"\n"
             "[wall]\nshape = \"box\"\nmin = [0.3, 0]\nmax = [0.5, 1]\n");
  return load_scene(folder / "scene.toml");
}

// A state of a run has particles closer to walls than half a spacing.
TEST(SampleFluid, KeepsThePointsOfAFileBeforeAWall) {
  const TemporaryFolder folder;
  const Sample s = sample(points_at_a_wall(folder));
  EXPECT_EQ(3u, s.density.size());
  EXPECT_EQ(Real(0.501), s.x[0]);
  EXPECT_EQ(1, s.left_out);
}

TEST(Warnings, NameUnusedColumnsAndExcludedPointsOfAFile) {
  const TemporaryFolder folder;
  const std::string place = (folder / "scene.toml").string() + ":6:8: warning: ",
                    file = (folder / "state.csv").string();
  std::string text;
  for (const Diagnostic& d : scene_warnings(points_at_a_wall(folder))) text += d.text() + "\n";
  EXPECT_NE(std::string::npos,
            text.find(place + file +
                      " has columns that are not used: \"id\"; a fluid reads positions and "
                      "velocities\n"))
      << text;
  EXPECT_NE(std::string::npos,
            text.find(place + "1 of the 4 points of " + file +
                      " are inside walls, bodies or zones of inlets and are excluded; move them "
                      "out, or move what they are in\n"))
      << text;
  EXPECT_EQ(std::string::npos, text.find("apart")) << text;
}

TEST(Warnings, ReportPointsWithAnotherSpacing) {
  const TemporaryFolder folder;
  write_text(folder / "sparse.csv", "x,y\n0.2,0.5\n0.4,0.5\n0.6,0.5\n0.8,0.5\n");
  write_text(folder / "scene.toml",
             "domain.max = [1, 1]\nparticles.spacing = 0.1\ntime = { end = 0.01, step = 1e-4 }\n"
             "[fluid]\nshape = \"points\"\nfile = \"sparse.csv\"\n");
  std::string text;
  for (const Diagnostic& d : scene_warnings(load_scene(folder / "scene.toml")))
    text += d.text() + "\n";
  EXPECT_NE(std::string::npos,
            text.find("sparse.csv are 0.2 m apart (median distance of nearest neighbours), and "
                      "particles.spacing is 0.1 m; set particles.spacing = 0.2, or sample the "
                      "points at the spacing\n"))
      << text;
}

TEST(Resolution, ScalesLengthsAndTimeStepIn3D) {
  const Scene coarse = scene_with("[1, 1, 1]", 0.1,
                                  "particles.support_radius = 0.25\n[fluid]\nshape = \"lattice\"\n"
                                  "from = [0.05, 0.05, 0.05]\ncount = [5, 5, 5]\n");
  const auto overrides = at_resolution(coarse, 1000);
  const Scene fine = parse_scene(coarse.source, "test.toml", overrides);
  EXPECT_EQ(1000u, particles_of(fine));
  EXPECT_NEAR(0.05, fine.particles.spacing, 1e-12);
  EXPECT_NEAR(0.125, *fine.particles.support_radius, 1e-12);
  EXPECT_NEAR(0.025, fine.fluid[0].from[2], 1e-12);
  EXPECT_NEAR(0.5e-4, fine.time.step, 1e-12);
}

TEST(Resolution, ScalesStepMaxOfAdaptiveSteps) {
  const Scene coarse = parse_scene(
      "domain.max = [1, 1]\nparticles.spacing = 0.1\nfluid = { min = [0, 0], max = [1, 0.5] }\n"
      "time = { end = 1, step = \"adaptive\", step_max = 0.01 }\n",
      "test.toml");
  for (const auto& [key, value] : at_resolution(coarse, 200))
    EXPECT_NE("time.step", key) << value.value_or("");
  const Scene fine = parse_scene(coarse.source, "test.toml", at_resolution(coarse, 200));
  EXPECT_NEAR(0.005, *fine.time.step_max, 1e-12);
}

TEST(Derive, HasTheExpectedNumbersIn3D) {
  const Scene scene = scene_with("[2, 1, 1]", 0.1,
                                 "[solver]\nname = \"wcsph\"\nkernel = \"wendland_c2\"\n"
                                 "[fluid]\nmin = [0, 0, 0]\nmax = [1, 0.5, 1]\n");
  const Derived d = derive(scene);
  EXPECT_NEAR(1, d.mass, 1e-12);
  EXPECT_EQ(26, d.neighbors);
  EXPECT_NEAR(1.03, d.lattice_sum, 0.02);
  EXPECT_NEAR(10 * std::sqrt(2 * 9.81 * 0.5), d.sound_speed, 1e-9) << "of the water's height";
  EXPECT_NEAR(0.4 * 0.1 / d.sound_speed, d.acoustic_step, 1e-12);
  EXPECT_NEAR(0.125 * 0.1 * 10 / (0.05 * d.sound_speed), d.viscous_step, 1e-9);
  EXPECT_EQ(std::int64_t(sample(scene).adami2012.wall.size()), d.wall_particles);
}

TEST(Warnings, ReportALatticeThatDoesNotFitAPeriodicDomain) {
  const auto warnings_of = [](const char* domain) {
    return scene_warnings(scene_with(domain, 0.1,
                                     "particles.support_radius = 0.3\ndomain.periodic = \"x\"\n"
                                     "[fluid]\nmin = [0, 0]\nmax = [0.9, 0.5]\n"));
  };
  EXPECT_TRUE(warnings_of("[1, 1]").empty());
  ASSERT_EQ(1u, warnings_of("[1.04, 1]").size());
  EXPECT_NE(std::string::npos, warnings_of("[1.04, 1]")[0].message.find("10.4 spacings long in x"));
}

TEST(Defaults, FillASceneMadeInCode) {
  Scene scene;
  scene.domain.max = {1, 1, 1};
  scene.particles.spacing = 0.1;
  scene.time = {.end = 0.1, .step = 1e-4, .step_max = {}, .integrator = {}};
  scene.fluid.resize(1);
  scene.fluid[0].min = {0, 0, 0};
  scene.fluid[0].max = {0.5, 0.5, 0.5};
  EXPECT_EQ(125, derive(scene).particles);
  EXPECT_EQ((Vector{0, -9.81, 0}), with_defaults(scene).domain.gravity);
  EXPECT_EQ(Side::outside, Scene::Wall().side);
  scene.fluid[0].velocity = {1, 2};
  EXPECT_THROW(derive(scene), Error);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Fluids below a free surface that is a function of position, and their initial velocity and
// pressure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "freshet/derived.h"
#include "scene/model/expressions.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

class FreeSurfaces : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!reads_expressions()) GTEST_SKIP() << "needs muParser";
  }
};

/// A fluid below `surface` in a domain of 1.36 m × 0.5 m, periodic in x.
Scene wave_in_2d(const std::string& surface, const std::string& more = "", double spacing = 0.02,
                 const std::string& solver = "dfsph") {
  return scene_with("[1.36, 0.5]", spacing,
                    fmt::format("domain.periodic = \"x\"\nsolver.name = \"{}\"\n"
                                "[[fluid]]\nsurface = \"{}\"\n{}",
                                solver, surface, more));
}

void expect_volume(const Scene& scene, double volume) {
  const Derived d = derive(scene);
  ASSERT_TRUE(d.fluids[0].asked);
  EXPECT_NEAR(*d.fluids[0].asked, volume, 5e-4 * volume);
  EXPECT_NEAR(d.fluids[0].filled, *d.fluids[0].asked, std::pow(d.spacing, scene.dimension()));
}

/// The gap between the surface and the highest particle within 0.75 spacings of a column, in
/// spacings: minimum and maximum over all columns.
std::pair<double, double> gaps(const Scene& scene, const std::function<double(double)>& surface) {
  const Sample s = sample(scene);
  const double spacing = scene.particles.spacing, length = scene.domain.max[0];
  double least = INFINITY, most = -INFINITY;
  for (double x = spacing; x < length - spacing; x += spacing / 3) {
    double gap = INFINITY;
    for (std::size_t i = 0; i < s.x.size(); i += 2)
      if (std::abs(double(s.x[i]) - x) < 0.75 * spacing)
        gap = std::min(gap, surface(double(s.x[i])) - double(s.x[i + 1]));
    least = std::min(least, gap / spacing);
    most = std::max(most, gap / spacing);
  }
  return {least, most};
}

TEST_F(FreeSurfaces, FillTheVolumeBelowThem) {
  expect_volume(wave_in_2d("0.3 + 0.026*cos(2*pi*x/1.36)"), 1.36 * 0.3);
  expect_volume(wave_in_2d("0.3 + 0.026*cos(2*pi*x/1.36)", "", 0.01), 1.36 * 0.3);
  expect_volume(wave_in_2d("0.309"), 1.36 * 0.309);
  expect_volume(wave_in_2d("x < 0.5 ? 0.4 : 0.1"), 0.5 * 0.4 + 0.86 * 0.1);
  expect_volume(wave_in_2d("0.5*x - 0.3"), 0.76 * 0.76 * 0.5 / 2);  // a dry shore
  expect_volume(scene_with("[1, 0.6, 0.5]", 0.04,
                           "solver.name = \"dfsph\"\n[fluid]\n"
                           "surface = \"0.3 + 0.05*cos(pi*x)*cos(2*pi*z)\"\n"),
                1 * 0.3 * 0.5);
  expect_volume(scene_with("[1, 0.6, 0.5]", 0.04,
                           "solver.name = \"dfsph\"\n[fluid]\nsurface = \"0.2 + 0.4*z\"\n"
                           "min = [0.2, 0, 0]\nmax = [1, 0.6, 0.5]\n"),
                0.8 * 0.3 * 0.5);
}

TEST_F(FreeSurfaces, CutOtherShapesAndMeetWalls) {
  const Derived half = derive(scene_with("[1, 1]", 0.02,
                                         "solver.name = \"dfsph\"\n[fluid]\nshape = \"sphere\"\n"
                                         "center = [0.5, 0.5]\nradius = 0.3\nsurface = \"0.5\"\n"));
  const double volume = std::numbers::pi * 0.3 * 0.3 / 2;
  EXPECT_NEAR(*half.fluids[0].asked, volume, 5e-4 * volume);
  EXPECT_NEAR(half.fluids[0].filled, volume, 0.02 * volume) << "a lattice cuts the round side";
  expect_volume(scene_with("[1, 1]", 0.02,
                           "solver.name = \"dfsph\"\n[fluid]\nsurface = \"0.5 + 0.05*x\"\n"
                           "[[wall]]\nshape = \"plane\"\npoint = [0.5, 0]\nnormal = [-1, 2]\n"),
                0.525 - 0.5 * 0.5 * 0.25);
}

TEST_F(FreeSurfaces, HaveParticlesHalfASpacingBelowThem) {
  const auto wave = [](double x) {
    return 0.3 + 0.026 * std::cos(2 * std::numbers::pi * x / 1.36);
  };
  for (const double spacing : {0.02, 0.013}) {
    const auto [least, most] = gaps(wave_in_2d("0.3 + 0.026*cos(2*pi*x/1.36)", "", spacing), wave);
    EXPECT_GT(least, 0.25);
    EXPECT_LT(most, 0.85);
  }
  const auto [least, most] = gaps(wave_in_2d("0.309"), [](double) { return 0.309; });
  EXPECT_GT(least, 0.25);
  EXPECT_LT(most, 0.85);
}

TEST_F(FreeSurfaces, SpreadTheirParticlesEvenly) {
  const Sample s = sample(wave_in_2d("0.3 + 0.026*cos(2*pi*x/1.36)"));
  const auto [least, greatest] = nearest_distances(s.x, 2);
  EXPECT_GT(least, 0.7 * 0.02);
  EXPECT_LT(greatest, 1.2 * 0.02);
}

TEST_F(FreeSurfaces, ThatFitTheLatticeKeepIt) {
  EXPECT_EQ(sample(wave_in_2d("0.3")).x,
            sample(wave_in_2d("0.3", "min = [0, 0]\nmax = [1.36, 0.4]\n")).x);
  const Scene box = scene_with("[1.36, 0.5]", 0.02,
                               "domain.periodic = \"x\"\nsolver.name = \"dfsph\"\n"
                               "[[fluid]]\nmin = [0, 0]\nmax = [1.36, 0.3]\n");
  EXPECT_EQ(sample(wave_in_2d("0.3")).x, sample(box).x);
}

TEST_F(FreeSurfaces, AreHydrostaticBelow) {
  const std::string surface = "0.3 + 0.026*cos(2*pi*x/1.36)";
  const Scene rigid = wave_in_2d(surface, "pressure = \"hydrostatic\"\n");
  const Sample s = sample(rigid);
  ASSERT_EQ(2 * s.pressure.size(), s.x.size());
  for (std::size_t i = 0; i < s.pressure.size(); ++i) {
    const double x = double(s.x[2 * i]), y = double(s.x[2 * i + 1]);
    ASSERT_NEAR(double(s.pressure[i]),
                9810 * (0.3 + 0.026 * std::cos(2 * std::numbers::pi * x / 1.36) - y), 0.5);
  }
  const Scene soft = wave_in_2d(surface, "pressure = \"hydrostatic\"\n", 0.02, "delta_sph");
  const Sample t = sample(soft);
  double densest = 0;
  for (const Real rho : t.density) densest = std::max(densest, double(rho));
  const double c2 = std::pow(derive(soft).sound_speed, 2);
  EXPECT_NEAR(densest, 1000 * std::pow(1 + 7 * 9.81 * 0.316 / c2, 1.0 / 7), 0.1);
}

TEST_F(FreeSurfaces, GivePressuresOfAFunction) {
  const std::string field = "pressure_field = \"500 + 100*x\"\n";
  const Sample s = sample(wave_in_2d("0.3", field));
  ASSERT_EQ(2 * s.pressure.size(), s.x.size());
  for (std::size_t i = 0; i < s.pressure.size(); ++i)
    ASSERT_NEAR(double(s.pressure[i]), 500 + 100 * double(s.x[2 * i]), 1e-2);
  const Scene soft = wave_in_2d("0.3", field, 0.02, "delta_sph");
  const Sample t = sample(soft);
  const double c2 = std::pow(derive(soft).sound_speed, 2);
  for (std::size_t i = 0; i < t.density.size(); ++i)
    ASSERT_NEAR(double(t.density[i]),
                1000 * std::pow(1 + 7 * (0.5 + 0.1 * double(t.x[2 * i])) / c2, 1.0 / 7), 2e-3);
}

TEST_F(FreeSurfaces, DescribeASolitaryWave) {
  // Rayleigh's, H/d = 0.2, d = 0.3 m: k² = 3 H/(4 d² (d + H))
  const std::string wave = "0.06/cosh(1.17851*(x - 1.5))^2";
  const std::string u = "1.87926*" + wave + "/(0.3 + " + wave + ")";
  const std::string v =
      "2*1.17851*0.563778*y*" + wave + "*tanh(1.17851*(x - 1.5))/(0.3 + " + wave + ")^2";
  const Scene scene = scene_with("[7.5, 0.5]", 0.03,
                                 "[solver]\nname = \"dfsph\"\n[fluid]\nsurface = \"0.3 + " + wave +
                                     "\"\nvelocity_field = [\"" + u + "\", \"" + v +
                                     "\"]\npressure = \"hydrostatic\"\n");
  const double k = 1.17851;
  expect_volume(scene, 7.5 * 0.3 + 0.06 / k * (std::tanh(k * 6) + std::tanh(k * 1.5)));
  const Sample s = sample(scene);
  double fastest = 0;
  for (std::size_t i = 0; i < s.x.size(); i += 2) {
    const double eta = 0.06 / std::pow(std::cosh(k * (double(s.x[i]) - 1.5)), 2);
    ASSERT_NEAR(double(s.v[i]), 1.87926 * eta / (0.3 + eta), 1e-5);
    // no divergence: v = -y du/dx
    const double u_slope = -2 * k * std::tanh(k * (double(s.x[i]) - 1.5)) * eta * 1.87926 * 0.3 /
                           std::pow(0.3 + eta, 2);
    ASSERT_NEAR(double(s.v[i + 1]), -double(s.x[i + 1]) * u_slope, 1e-5);
    fastest = std::max(fastest, double(s.v[i]));
  }
  EXPECT_NEAR(fastest, 1.87926 * 0.06 / 0.36, 0.002);
}

}  // namespace
}  // namespace freshet::test

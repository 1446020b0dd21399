// SPDX-License-Identifier: MIT
// Positions of boundary and body particles.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scene/model/solid_of.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

constexpr double dx = 0.05;
const std::string fluid_2d = "[fluid]\nmin = [0, 0]\nmax = [0.1, 0.1]\n";
const std::string fluid_3d = "[fluid]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n";
const std::string high_2d = "[fluid]\nmin = [0.45, 0.8]\nmax = [0.55, 0.9]\n";
const std::string high_3d = "[fluid]\nmin = [0.45, 0.8, 0.45]\nmax = [0.55, 0.9, 0.55]\n";

std::string solver(const char* sides) {
  return std::string("solver.name = \"wcsph\"\nwalls.method = \"") + sides + "\"\n";
}

/// Number of boundary particles per wall.
std::map<int, int> counts_of(const WallSample& sample) {
  std::map<int, int> counts;
  for (const int wall : sample.wall) ++counts[wall];
  return counts;
}

TEST(SampleSides, HaveOneLayerAroundTheDomainAndItsCorners) {
  const Sample s = sample(scene_with("[1, 0.5]", dx, solver("monaghan2009") + fluid_2d));
  EXPECT_TRUE(s.adami2012.wall.empty() && s.akinci2012.wall.empty());
  const WallSample& w = s.monaghan2009;
  EXPECT_EQ((std::map<int, int>{{0, 12}, {1, 12}, {2, 20}, {3, 20}}), counts_of(w));
  const auto [least, greatest] = nearest_distances(w.x, 2);
  EXPECT_NEAR(dx, least, 1e-6);
  EXPECT_NEAR(dx, greatest, 1e-6);
  for (std::size_t i = 0; i < w.x.size(); i += 2) {
    const double x = double(w.x[i]), y = double(w.x[i + 1]);
    EXPECT_TRUE(x < 0 || x > 1 || y < 0 || y > 0.5);
    EXPECT_TRUE(std::abs(x + dx / 2) < 1e-6 || std::abs(x - 1 - dx / 2) < 1e-6 ||
                std::abs(y + dx / 2) < 1e-6 || std::abs(y - 0.5 - dx / 2) < 1e-6);
  }
}

TEST(SampleSides, HaveAsManyLayersAsTheSupportReaches) {
  const Sample two = sample(scene_with("[1, 0.5]", dx, solver("adami2012") + fluid_2d));
  EXPECT_EQ(24u * 14 - 20 * 10, two.adami2012.wall.size());
  const Sample three = sample(scene_with(
      "[1, 0.5, 0.5]", dx, solver("adami2012") + "particles.support_radius = 0.13\n" + fluid_3d));
  EXPECT_EQ(26u * 16 * 16 - 20 * 10 * 10, three.adami2012.wall.size());
}

TEST(SampleSides, AdaptTheirSpacingToTheDomain) {
  const Sample s = sample(scene_with("[0.98, 0.5]", dx, solver("monaghan2009") + fluid_2d));
  std::set<Real> x;
  for (std::size_t i = 0; i < s.monaghan2009.x.size(); i += 2) x.insert(s.monaghan2009.x[i]);
  EXPECT_EQ(22u, x.size());
  EXPECT_NEAR(-0.98 / 40, *x.begin(), 1e-6);
  EXPECT_NEAR(0.98 + 0.98 / 40, *x.rbegin(), 1e-6);
}

/// The distance gives water half a spacing from the wall its rest density, with any kernel.
/// tests/sim/rest_test.cpp checks the density of the first step.
TEST(SampleSides, OfAkinci2012AreAtTheSingleLayerDistance) {
  for (const char* kernel : {"cubic_spline", "wendland_c2"}) {
    const Scene scene = scene_with("[1, 0.5]", dx,
                                   solver("akinci2012") + "solver.kernel = \"" + kernel + "\"\n" +
                                       "particles.support_radius = 0.108\n" + fluid_2d);
    const double distance = single_layer_distance(scene);
    EXPECT_GT(distance, 1.05 * dx);
    EXPECT_LT(distance, 1.5 * dx);
    double nearest = -1;
    const WallSample w = sample(scene).akinci2012;
    for (std::size_t i = 0; i < w.x.size(); i += 2)
      if (w.x[i] < 0) nearest = std::max(nearest, double(w.x[i]));
    EXPECT_NEAR(dx / 2 - distance, nearest, 1e-6);
  }
}

TEST(SampleSides, CanHaveDifferentMethods) {
  const Sample s = sample(scene_with(
      "[1, 0.5]", dx,
      solver("adami2012") + "walls.y_max = \"open\"\nwalls.x_min = \"akinci2012\"\n" + fluid_2d));
  // corner of x_min and y_min: one place for the single layer of x_min, three for y_min
  EXPECT_EQ((std::map<int, int>{{0, 11 + 1}}), counts_of(s.akinci2012));
  EXPECT_EQ((std::map<int, int>{{1, 2 * 14}, {2, 2 * 20 + 3}}), counts_of(s.adami2012));
}

TEST(SampleSides, RepeatBeyondPeriodicEnds) {
  const Sample s = sample(
      scene_with("[1, 0.5]", dx, solver("akinci2012") + "domain.periodic = \"x\"\n" + fluid_2d));
  EXPECT_EQ((std::map<int, int>{{-1 - 3, 2 * 2}, {-1 - 2, 2 * 2}, {2, 20}, {3, 20}}),
            counts_of(s.akinci2012));
  const Sample none = sample(
      scene_with("[1, 0.5]", dx, "solver.name = \"wcsph\"\ndomain.periodic = \"xy\"\n" + fluid_2d));
  EXPECT_TRUE(none.akinci2012.wall.empty());
}

struct Shaped {
  std::string shape;
  double area;  ///< area half a spacing behind the surface [m^(D-1)]; 0: not checked
  bool three = true;
};

/// Expects layers (k + 1/2) spacings behind the surface, with points about one spacing apart.
void expect_layers(const Shaped& wall, const char* method, int layers) {
  const Scene scene = scene_with(wall.three ? "[1, 1, 1]" : "[1, 1]", dx,
                                 solver("open") + (wall.three ? high_3d : high_2d) + "[wall]\n" +
                                     wall.shape + "method = \"" + method + "\"\n");
  const Sample s = sample(scene);
  const WallSample& w = method == std::string("adami2012") ? s.adami2012 : s.akinci2012;
  const std::size_t d = wall.three ? 3 : 2;
  ASSERT_FALSE(w.wall.empty()) << wall.shape;
  const bool has_corners = scene.wall[0].shape == Shape::box && scene.wall[0].side == Side::inside;
  const double deepest = (layers - 0.29) * dx * (has_corners ? std::sqrt(double(d)) : 1);
  int first_layer = 0;
  for (std::size_t i = 0; i < w.x.size(); i += d) {
    EXPECT_EQ(int(2 * d), w.wall[i / d]);
    Vec<3, double> x{};
    for (int k = 0; k < int(d); ++k) component(x, k) = double(w.x[i + std::size_t(k)]);
    const double distance = d == 3 ? solid_of<3>(scene.wall[0]).distance(x)
                                   : solid_of<2>(scene.wall[0]).distance({x.x, x.y});
    EXPECT_LT(distance, -0.49 * dx) << wall.shape;
    EXPECT_GT(distance, -deepest) << wall.shape;
    first_layer += distance > -0.75 * dx;
  }
  const auto [least, greatest] = nearest_distances(w.x, d);
  EXPECT_GT(least, 0.7 * dx) << wall.shape;
  EXPECT_LT(greatest, 1.3 * dx) << wall.shape;
  const double covered = first_layer * std::pow(dx, d - 1);
  EXPECT_NEAR(wall.area > 0 ? wall.area : covered, covered, 0.1 * covered) << wall.shape;
}

constexpr double pi2 = 6.283185307;
const Shaped shapes[] = {
    {"shape = \"sphere\"\ncenter = [0.5, 0.5]\nradius = 0.2\n", pi2 * 0.175, false},
    {"shape = \"sphere\"\nside = \"inside\"\ncenter = [0.5, 0.5]\nradius = 0.4\n", pi2 * 0.425,
     false},
    {"shape = \"box\"\nmin = [0.3, 0.3]\nmax = [0.7, 0.6]\n", 1.2, false},
    {"shape = \"plane\"\npoint = [0.5, 0.2]\nnormal = [0, 1]\n", 0, false},
    {"shape = \"plane\"\npoint = [0.5, 0.2]\nnormal = [-1, 2]\n", 0, false},
    {"shape = \"sphere\"\ncenter = [0.5, 0.5, 0.5]\nradius = 0.3\n", 2 * pi2 * 0.275 * 0.275},
    {"shape = \"sphere\"\nside = \"inside\"\ncenter = [0.5, 0.5, 0.5]\nradius = 0.45\n",
     2 * pi2 * 0.475 * 0.475},
    {"shape = \"cylinder\"\ncenter = [0.5, 0.5, 0.5]\nradius = 0.2\nlength = 0.6\n",
     pi2 * 0.175 * (0.55 + 0.175)},
    {"shape = \"cylinder\"\naxis = [1, 1, 0]\ncenter = [0.5, 0.5, 0.5]\nradius = 0.2\n"
     "length = 0.6\n",
     pi2 * 0.175 * (0.55 + 0.175)},
    {"shape = \"box\"\nmin = [0.3, 0.3, 0.3]\nmax = [0.7, 0.6, 0.5]\n", 0},
    {"shape = \"box\"\nside = \"inside\"\nmin = [0.1, 0.1, 0.1]\nmax = [0.9, 0.9, 0.9]\n", 0},
    {"shape = \"plane\"\npoint = [0.5, 0.4, 0.5]\nnormal = [1, 2, -1]\n", 0},
};

TEST(SampleWalls, LieBehindTheSurfaceAboutASpacingApart) {
  for (const Shaped& shape : shapes) {
    expect_layers(shape, "akinci2012", 1);
    expect_layers(shape, "adami2012", 2);
  }
}

TEST(SampleWalls, EndNearTheDomain) {
  const Sample s = sample(scene_with("[1, 1, 1]", dx,
                                     solver("open") + fluid_3d +
                                         "[wall]\nshape = \"sphere\"\ncenter = [1, 0.5, 0.5]\n"
                                         "radius = 0.4\nmethod = \"akinci2012\"\n"));
  double farthest = 0;
  for (std::size_t i = 0; i < s.akinci2012.x.size(); i += 3)
    farthest = std::max(farthest, double(s.akinci2012.x[i]));
  EXPECT_LE(farthest, 1.1 + 1e-6);
  EXPECT_GT(farthest, 1.05);
}

TEST(SampleWalls, RepeatAtPeriodicEnds) {
  const Sample s = sample(scene_with("[1, 1]", dx,
                                     solver("open") + "domain.periodic = \"x\"\n" + fluid_2d +
                                         "[wall]\nshape = \"sphere\"\ncenter = [1, 0.5]\n"
                                         "radius = 0.2\nmethod = \"akinci2012\"\n"));
  const auto counts = counts_of(s.akinci2012);
  EXPECT_EQ(22, counts.at(4));  // the whole circle: half of it at each end
  EXPECT_GT(counts.at(-1 - 4), 0);
  for (std::size_t i = 0; i < s.akinci2012.wall.size(); ++i)
    EXPECT_EQ(s.akinci2012.wall[i] < 0, s.akinci2012.x[2 * i] < 0 || s.akinci2012.x[2 * i] >= 1);
}

TEST(SampleWalls, FillAnObstacleThatIsThinnerThanItsLayers) {
  const Sample s = sample(scene_with("[1, 1]", dx,
                                     solver("open") + fluid_2d +
                                         "[wall]\nmin = [0.5, 0]\nmax = [0.55, 0.5]\n"
                                         "method = \"adami2012\"\n"));
  EXPECT_EQ(10u, s.adami2012.wall.size());
}

/// A scene with this body, where all walls have this method.
Scene body_scene(const std::string& method, const std::string& body) {
  return scene_with("[1, 1]", dx, solver(method.c_str()) + fluid_2d + "[body]\n" + body);
}

TEST(SampleBodies, HaveLayersIfTheWallsAreOfAdami2012) {
  const std::string box = "min = [0.4, 0.4]\nmax = [0.7, 0.8]\n",
                    disc = "shape = \"sphere\"\ncenter = [0.5, 0.5]\nradius = 0.2\n";
  EXPECT_EQ(6u * 8 - 2 * 4, sample(body_scene("adami2012", box)).bodies.body.size());
  EXPECT_EQ(22u + 16, sample(body_scene("adami2012", disc)).bodies.body.size());
  for (const char* method : {"akinci2012", "monaghan2009", "open"})
    EXPECT_EQ(24u, sample(body_scene(method, box)).bodies.body.size()) << method;
  const Sample layered = sample(body_scene("adami2012", box));
  double shallowest = 1;
  for (std::size_t i = 0; i < layered.bodies.x.size(); i += 2)
    shallowest = std::min(shallowest, layered.bodies.x[i] - 0.4);
  EXPECT_NEAR(dx / 2, shallowest, 1e-12);
}

TEST(SampleBodies, WarnIfTooThinForTheirLayers) {
  const auto warnings_of = [](const char* method, const char* width) {
    return scene_warnings(
        body_scene(method, std::string("min = [0.4, 0.4]\nmax = [0.9, ") + width + "]\n"));
  };
  EXPECT_TRUE(warnings_of("adami2012", "0.5").empty());
  EXPECT_TRUE(warnings_of("akinci2012", "0.46").empty());
  const auto warnings = warnings_of("adami2012", "0.46");
  ASSERT_EQ(1u, warnings.size());
  EXPECT_NE(std::string::npos, warnings[0].message.find("is 0.06 m thick")) << warnings[0].message;
  EXPECT_NE(std::string::npos, warnings[0].message.find("make it thicker"));
}

TEST(WallNames, StartWithTheSides) {
  const Scene scene =
      scene_with("[1, 1]", dx,
                 fluid_2d +
                     "[[wall]]\nmin = [0.5, 0]\nmax = [0.6, 0.5]\n"
                     "[[wall]]\nname = \"post\"\nmin = [0.8, 0]\nmax = [0.9, 0.5]\n");
  EXPECT_EQ((std::vector<std::string>{"x_min", "x_max", "y_min", "y_max", "wall[0]", "post"}),
            scene.wall_names());
  EXPECT_EQ(WallMethod::reflection, scene.wall_method(0));
  EXPECT_EQ(WallMethod::reflection, scene.side_method(3));
}

}  // namespace
}  // namespace freshet::test

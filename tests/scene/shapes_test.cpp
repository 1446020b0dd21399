// SPDX-License-Identifier: MIT
// Turned boxes and polygons: distances and particles.
#include <gtest/gtest.h>

#include <algorithm>

#include "freshet/derived.h"
#include "scene/sample/region_surface.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

const std::string wcsph = "solver.name = \"wcsph\"\n";

/// A scene of one wall, with some fluid on its side.
Scene with_wall(const std::string& wall) {
  const bool tank = wall.find("inside") != std::string::npos;
  return with_defaults(scene_with(
      "[2, 2]", 0.05,
      wcsph +
          (tank ? "fluid = { min = [0.8, 0.7], max = [1, 0.9] }\n"
                : "fluid = { min = [0, 0], max = [0.1, 0.1] }\n") +
          "[[wall]]\n" + wall +
          (wall.find("method") == std::string::npos ? "method = \"akinci2012\"\n" : "")));
}

/// The boundary particles of the first wall.
std::vector<Vec<2, double>> particles_of_wall(const Scene& s) {
  const Sample all = sample(s);
  std::vector<Vec<2, double>> x;
  for (const WallSample* w : {&all.akinci2012, &all.adami2012})
    for (std::size_t k = 0; k < w->wall.size(); ++k)
      if (w->wall[k] == 4) x.push_back({double(w->x[2 * k]), double(w->x[2 * k + 1])});
  return x;
}

/// Whether each point has one of the others within 1e-6.
bool are_among(const std::vector<Vec<2, double>>& some, const std::vector<Vec<2, double>>& all) {
  return std::all_of(some.begin(), some.end(), [&](auto x) {
    return std::any_of(all.begin(), all.end(), [&](auto y) { return norm(x - y) < 1e-6; });
  });
}

Vec<2, double> turned(Vec<2, double> x, Vec<2, double> about, double degrees) {
  const double a = degrees * 3.14159265358979 / 180, c = std::cos(a), s = std::sin(a);
  const auto y = x - about;
  return about + Vec<2, double>{c * y.x - s * y.y, s * y.x + c * y.y};
}

TEST(TurnedBoxes, HaveTheDistancesOfTheBoxBeforeItsRotation) {
  const std::string box = "min = [0.5, 0.8]\nmax = [1.5, 1.2]\n";
  for (const char* side : {"", "side = \"inside\"\n"}) {
    const RegionSurface<2> plain(with_wall(box + side).wall[0], 0.05),
        turns(with_wall(box + side + "rotation = 25\n").wall[0], 0.05);
    for (const Vec<2, double> x :
         {Vec<2, double>{1, 1}, {0.6, 0.9}, {1.4, 1.5}, {1.52, 1.21}, {0.3, 0.2}}) {
      const double expected = plain.distance(x), found = turns.distance(turned(x, {1, 1}, 25));
      if (expected * (*side ? -1 : 1) > 0 && x.x > 1.5 && x.y > 1.2 && *side) continue;
      EXPECT_NEAR(expected, found, 1e-9) << x.x << " " << x.y << side;
    }
  }
}

TEST(TurnedBoxes, HaveTheParticlesOfTheBoxBeforeItsRotation) {
  for (const char* method : {"", "method = \"adami2012\"\n"}) {
    const std::string box = std::string("min = [0.5, 0.8]\nmax = [1.5, 1.2]\n") + method;
    const auto plain = particles_of_wall(with_wall(box)),
               turns = particles_of_wall(with_wall(box + "rotation = 25\n"));
    ASSERT_EQ(plain.size(), turns.size());
    std::vector<Vec<2, double>> expected;
    for (const auto& x : plain) expected.push_back(turned(x, {1, 1}, 25));
    EXPECT_TRUE(are_among(expected, turns));
  }
}

TEST(Polygons, HaveTheParticlesOfABox) {
  for (const char* rest : {"", "method = \"adami2012\"\n", "side = \"inside\"\n",
                           "side = \"inside\"\nmethod = \"adami2012\"\n"}) {
    const auto box =
        particles_of_wall(with_wall(std::string("min = [0.5, 0.8]\nmax = [1.5, 1.2]\n") + rest));
    const auto polygon = particles_of_wall(with_wall(
        std::string(
            "shape = \"polygon\"\npoints = [[0.5, 0.8], [0.5, 1.2], [1.5, 1.2], [1.5, 0.8]]\n") +
        rest));
    EXPECT_NEAR(double(box.size()), double(polygon.size()), 8) << rest;
    std::vector<Real> numbers;
    for (const auto& x : polygon) numbers.insert(numbers.end(), {Real(x.x), Real(x.y)});
    const auto [least, greatest] = nearest_distances(numbers, 2);
    EXPECT_GT(least, 0.7 * 0.05) << rest;
    EXPECT_LT(greatest, 0.055) << rest;
  }
}

// Sharp and reflex corners, and a part that is thinner than two layers.
TEST(Polygons, HaveTheirParticlesBehindTheirSurface) {
  const std::string arrow =
      "shape = \"polygon\"\n"
      "points = [[0.5, 0.5], [1.5, 0.6], [0.5, 1.6], [0.7, 0.8], [0.2, 0.75], [0.2, 0.67], [0.6, "
      "0.7]]\n";
  for (const char* side : {"", "side = \"inside\"\n"}) {
    const Scene s = with_wall(arrow + side);
    const RegionSurface<2> surface(s.wall[0], 0.05);
    const auto x = particles_of_wall(s);
    EXPECT_GT(x.size(), 60u);
    for (const auto& p : x) {
      EXPECT_LT(surface.distance(p), -0.3 * 0.05) << p.x << " " << p.y << side;
      EXPECT_GT(surface.distance(p), -0.08) << p.x << " " << p.y << side;
    }
  }
}

TEST(Polygons, AreFilledWithFluid) {
  const Scene s = scene_with("[2, 2]", 0.02,
                             wcsph +
                                 "[fluid]\nshape = \"polygon\"\n"
                                 "points = [[0.5, 0.5], [1.5, 0.5], [1, 1], [0.5, 1.5]]\n");
  const double area = 0.5 * 1 * 1;  // a triangle, with a corner on its longest side
  EXPECT_NEAR(area / (0.02 * 0.02), double(sample(s).density.size()), 45);
  const RegionSurface<2> shape(with_defaults(s).fluid[0], 0.02);
  EXPECT_NEAR(0.1, shape.distance({0.6, 0.9}), 1e-12);
  EXPECT_NEAR(-std::sqrt(0.02), shape.distance({1.1, 1.1}), 1e-12);
}

TEST(TurnedBoxes, AreFilledWithFluidIn3D) {
  const Scene s = scene_with("[2, 2, 2]", 0.05,
                             wcsph +
                                 "[fluid]\nmin = [0.5, 0.5, 0.5]\nmax = [1.5, 1.0, 1.2]\n"
                                 "rotation = [10, 20, 30]\n");
  EXPECT_NEAR(0.35 / std::pow(0.05, 3), double(sample(s).density.size()), 150);
}

TEST(TurnedBoxes, HaveTheirParticlesBehindTheirSurfaceIn3D) {
  for (const char* method : {"akinci2012", "adami2012"}) {
    const Scene s = with_defaults(scene_with(
        "[2, 2, 2]", 0.05,
        wcsph +
            "[fluid]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n[[wall]]\n"
            "min = [0.5, 0.5, 0.5]\nmax = [1.5, 1.0, 1.2]\nrotation = [10, 20, 30]\nmethod = \"" +
            method + "\"\n"));
    const RegionSurface<3> surface(s.wall[0], 0.05);
    const Sample all = sample(s);
    int found = 0;
    for (const WallSample* w : {&all.akinci2012, &all.adami2012})
      for (std::size_t k = 0; k < w->wall.size(); ++k) {
        if (w->wall[k] != 6) continue;
        ++found;
        const Real* x = &w->x[3 * k];
        const double d = surface.distance({double(x[0]), double(x[1]), double(x[2])});
        EXPECT_LT(d, -0.02);
        EXPECT_GT(d, -0.11);
      }
    EXPECT_GT(found, 1000);
  }
}

// A thin wall has its particles in its middle, with smaller volumes.
TEST(TurnedBoxes, HaveTheVolumesOfTheBoxBeforeItsRotation) {
  const std::string box = "min = [0.5, 0.8]\nmax = [1.5, 0.85]\n";
  std::vector<Real> volumes[2];
  for (const bool turns : {false, true}) {
    const WallSample all = sample(with_wall(box + (turns ? "rotation = 25\n" : ""))).akinci2012;
    for (std::size_t k = 0; k < all.wall.size(); ++k)
      if (all.wall[k] == 4) volumes[turns].push_back(all.volume_factor[k]);
    std::sort(volumes[turns].begin(), volumes[turns].end());
  }
  ASSERT_EQ(volumes[0].size(), volumes[1].size());
  EXPECT_LT(volumes[0][0], 0.95f);
  for (std::size_t k = 0; k < volumes[0].size(); ++k)
    EXPECT_NEAR(volumes[0][k], volumes[1][k], 1e-5);
}

TEST(Polygons, OfAThinWallHaveTheVolumesOfABox) {
  const auto least = [](const std::string& wall) {
    const std::vector<Real> volumes = sample(with_wall(wall)).akinci2012.volume_factor;
    return *std::min_element(volumes.begin(), volumes.end());
  };
  EXPECT_NEAR(least("min = [0.5, 0.8]\nmax = [1.5, 0.85]\n"),
              least("shape = \"polygon\"\n"
                    "points = [[0.5, 0.8], [1.5, 0.8], [1.5, 0.85], [0.5, 0.85]]\n"),
              1e-3);
}

// Positions are relative to the origin of the domain.
TEST(Shapes, AreSampledAlikeFarFromTheOrigin) {
  const auto sample_at = [](double x, double y) {
    const auto at = [&](double a, double b) {
      return "[" + std::to_string(x + a) + ", " + std::to_string(y + b) + "]";
    };
    return sample(parse_scene(
        wcsph +
            "particles.spacing = 0.0625\ntime = { end = 0.01, step = 1e-4 }\ndomain = { min = " +
            at(0, 0) + ", max = " + at(2, 2) + " }\n[[fluid]]\nshape = \"polygon\"\npoints = [" +
            at(0.25, 0.25) + ", " + at(1, 0.25) + ", " + at(0.5, 1) +
            "]\n[[fluid]]\nrotation = 30\nmin = " + at(1.25, 1.25) + "\nmax = " + at(1.5, 1.75) +
            "\n[[wall]]\nshape = \"polygon\"\npoints = [" + at(1.25, 0.25) + ", " + at(1.75, 0.25) +
            ", " + at(1.5, 1) + "]\n[[wall]]\nrotation = 40\nmin = " + at(0.25, 1.25) +
            "\nmax = " + at(0.75, 1.625) + "\n",
        "test.toml"));
  };
  const Sample near = sample_at(0, 0), far = sample_at(4096, -8192);
  const auto compare = [](const std::vector<Real>& a, const std::vector<Real>& b) {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-6);
  };
  compare(near.x, far.x);
  compare(near.adami2012.x, far.adami2012.x);
  EXPECT_EQ(near.akinci2012.wall, far.akinci2012.wall);
}

TEST(Shapes, OfFluidsAreFilledUpToTheirWalls) {
  for (const char* shape :
       {"min = [0.5, 0.6]\nmax = [1.5, 1.33]\nrotation = 25\n",
        "shape = \"polygon\"\npoints = [[0.3, 0.3], [1.7, 0.5], [0.9, 1.6]]\n"}) {
    const Scene s = with_defaults(scene_with(
        "[2, 2]", 0.05, wcsph + "[[fluid]]\n" + shape + "[[wall]]\nside = \"inside\"\n" + shape));
    EXPECT_NEAR(0, derive(s).fluids[0].error(), 0.01) << shape;
    const RegionSurface<2> surface(s.wall[0], 0.05);
    const std::vector<Real> x = sample(s).x;
    for (std::size_t k = 0; k < x.size(); k += 2)
      EXPECT_GT(surface.distance({double(x[k]), double(x[k + 1])}), 0.3 * 0.05) << shape;
  }
}

}  // namespace
}  // namespace freshet::test

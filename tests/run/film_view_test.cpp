// SPDX-License-Identifier: MIT
#include "run/film_view.h"

#include <gtest/gtest.h>

#include "freshet/simulation.h"

namespace freshet::test {
namespace {

Scene pool(const std::string& more = "") {
  return parse_scene(
      "domain.max = [4, 3, 2]\nparticles.spacing = 0.1\ntime = { end = 1, step = 1e-3 }\n"
      "fluid = { min = [0, 0, 0], max = [2, 0.5, 2] }\nsolver.name = \"wcsph\"\n" +
          more,
      "a test");
}

/// The pool, up to `right`, `drops` particles in the air.
Frame water(double time, float right, int drops = 0) {
  Frame frame;
  frame.dimension = 3;
  frame.time = time;
  for (float x = 0.05f; x < right; x += 0.1f)
    for (float y = 0.05f; y < 0.5f; y += 0.1f)
      for (float z = 0.05f; z < 2; z += 0.1f) frame.x.insert(frame.x.end(), {x, y, z});
  for (int k = 0; k < drops; ++k) frame.x.insert(frame.x.end(), {3.9f, 2.9f, 1});
  frame.id.resize(frame.x.size() / 3);
  return frame;
}

void expect_box(const Bounds& box, Point low, Point high) {
  EXPECT_NEAR(norm(box.low - low), 0, 1e-6) << box.low.x << " " << box.low.y << " " << box.low.z;
  EXPECT_NEAR(norm(box.high - high), 0, 1e-6)
      << box.high.x << " " << box.high.y << " " << box.high.z;
}

TEST(FilmView, IsAroundTheLiquidOfAllFramesWithoutAFewDrops) {
  const Scene scene = pool();
  FilmViewer viewer(scene);
  viewer.add(water(0, 2));
  viewer.add(water(0.1, 3, 4));
  const FilmView view = viewer.view();
  // The box is 12 spacings high at least.
  expect_box(view.seen, {0, -0.35, 0}, {3, 0.85, 2});
  EXPECT_EQ(view.touched, (std::array<bool, 6>{true, false, true, false, true, true}));
  EXPECT_NEAR(view.tank_top, 0.7, 1e-6);
}

TEST(FilmView, HasWallsOnlyNearTheLiquid) {
  const Scene scene = pool(
      "[[wall]]\nshape = \"cylinder\"\ncenter = [2.2, 1.5, 1]\naxis = [0, 1, 0]\nradius = 0.2\n"
      "length = 3\n[[wall]]\nshape = \"sphere\"\ncenter = [3.5, 2, 1]\nradius = 0.3\n");
  FilmViewer viewer(scene);
  viewer.add(water(0, 2));
  expect_box(viewer.view().seen, {0, -0.325, 0}, {2.4, 0.875, 2});
}

TEST(FilmView, ShowsTheDomainWithoutLiquid) {
  const Scene scene = pool();
  FilmViewer viewer(scene);
  viewer.add(water(0, 0));
  expect_box(viewer.view().seen, {0, 0, 0}, {4, 3, 2});
}

TEST(FilmView, OpensTheShutterForAQuarterOfTheShortestGap) {
  const Scene scene = pool();
  FilmViewer viewer(scene);
  EXPECT_EQ(viewer.view().shutter, 0.004);
  for (const double time : {0.0, 0.1, 0.104, 0.2}) viewer.add_time(time);
  EXPECT_NEAR(viewer.view().shutter, 0.001, 1e-12);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include "run/film_materials.h"

#include <gtest/gtest.h>

#include "freshet/simulation.h"

namespace freshet::test {
namespace {

Scene glasses(const std::string& fluid, const std::string& more = "") {
  return parse_scene(
      "domain.max = [2, 2, 2]\nparticles.spacing = 0.1\ntime = { end = 1, step = 1e-3 }\n"
      "solver.name = \"dfsph\"\n[[fluid]]\nmin = [0, 0, 0]\nmax = [1, 1, 1]\n" +
          fluid + more,
      "a test");
}

constexpr const char* two_bodies =
    "[[body]]\nname = \"ball\"\nshape = \"sphere\"\ncenter = [1.5, 0.5, 0.5]\nradius = 0.3\n"
    "[[body]]\nshape = \"sphere\"\ncenter = [1.5, 0.5, 1.5]\nradius = 0.3\n";

std::string error_of(const std::string& choice) {
  try {
    film_materials(glasses("", two_bodies), {choice});
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(FilmMaterials, FollowTheScene) {
  EXPECT_EQ(film_materials(glasses(""), {}).liquids[0].color, "#86cdea");
  const auto tinted = film_materials(glasses("color = \"#102030\"\n"), {}).liquids[0];
  EXPECT_EQ(tinted.color, "#102030");
  EXPECT_EQ(tinted.ior, 1.333);
  const auto thick = film_materials(glasses("color = \"#e6a23a\"\nviscosity = 5\n"), {}).liquids[0];
  EXPECT_EQ(thick.ior, 1.49);
  EXPECT_GT(thick.scattering, 0);
}

TEST(FilmMaterials, ArePresetsWithChanges) {
  const auto all = film_materials(glasses("", two_bodies),
                                  {"liquid=milk", "liquid0=oil,ior=1.4,color=#ffcc00", "body=wood",
                                   "ball=metal,roughness=0.5", "body1=plastic"});
  EXPECT_EQ(all.liquids[0].ior, 1.4);
  EXPECT_EQ(all.liquids[0].color, "#ffcc00");
  EXPECT_EQ(all.liquids[0].scattering, 0);
  EXPECT_EQ(all.bodies[0].kind, "metal");
  EXPECT_EQ(all.bodies[0].roughness, 0.5);
  EXPECT_EQ(all.bodies[1].kind, "plastic");
  EXPECT_EQ(all.bodies[1].color, "#969aa6");  // of a body that is not free
}

TEST(FilmMaterials, RejectUnknownNames) {
  const auto expect_error = [](const std::string& choice, const std::string& words) {
    EXPECT_NE(error_of(choice).find(words), std::string::npos) << error_of(choice);
  };
  expect_error("milk", "write TARGET=PRESET");
  expect_error("cup=milk", "this run has no \"cup\"; it has liquid, liquid0, body, ball, body1");
  expect_error("liquid=glas", "unknown material \"glas\"; those of liquids are water, sea");
  expect_error("ball=milk", "those of bodies are matte");
  expect_error("liquid=oil,ior=9", "ior must be a number from 1 to 3");
  expect_error("liquid=oil,ior", "write KEY=VALUE after the preset");
  expect_error("liquid=oil,color=red", "color must be #rrggbb");
  expect_error("ball=gold,absorption=2", "unknown key absorption; the keys are color");
}

}  // namespace
}  // namespace freshet::test

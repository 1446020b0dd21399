// SPDX-License-Identifier: MIT
// Whether solids leave the fluid room: gaps under moved bodies, closed volumes, zones of inlets.
#include <gtest/gtest.h>

#include "bodies/bodies.h"
#include "scene/model/setup.h"
#include "sim/room.h"

namespace freshet::test {
namespace {

/// A scene whose bodies are where they are at `time`.
struct Situation {
  explicit Situation(const std::string& text, double time = 0)
      : scene(with_defaults(parse_scene("[particles]\nspacing = 0.05\n[solver]\nname = \"wcsph\"\n"
                                        "[time]\nend = 1.0\nstep = 1e-4\n" +
                                            text,
                                        "room.toml"))),
        bodies(scene) {
    for (std::size_t k = 0; k < bodies.size(); ++k) bodies.states()[k] = bodies.at(k, time, 0);
    const Sample start = sample(scene);
    x = start.x;
    v.resize(x.size());
    density.assign(x.size() / 2, 1000);
    for (std::size_t k = 0; k < density.size(); ++k) id.push_back(k);
  }
  ParticleView fluid() const { return {2, id, x, v, density, density, {}}; }

  Scene scene;
  Bodies bodies;
  std::vector<Real> x, v, density;
  std::vector<std::uint64_t> id;
};

const std::string press =
    "[domain]\nmax = [1, 1]\n[fluid]\nmin = [0, 0]\nmax = [1, 0.05]\n[[body]]\nname = \"press\"\n"
    "min = [0.3, 0.2]\nmax = [0.7, 0.4]\nmotion = \"moved\"\n";

TEST(Room, FindsAPinchUnderABodyThatCloses) {
  const Situation wide(press + "position = [\"0\", \"-0.1*t\"]\n", 1),
      narrow(press + "position = [\"0\", \"-0.16*t\"]\n", 1),
      rising(press + "position = [\"0\", \"-0.64*t*(1.25-t)\"]\n", 1);
  EXPECT_FALSE(find_pinch(wide.scene, &wide.bodies, wide.fluid()));
  const auto pinch = find_pinch(narrow.scene, &narrow.bodies, narrow.fluid());
  ASSERT_TRUE(pinch);
  EXPECT_EQ("press", pinch->body);
  EXPECT_EQ("y_min", pinch->solid);
  EXPECT_NEAR(0.04, pinch->gap, 1e-6);
  EXPECT_NEAR(0.16, pinch->speed, 1e-6);
}

TEST(Room, FindsABodyThatTakesRoomAway) {
  const std::string box =
      "[domain]\nmax = [1, 0.5]\n[fluid]\nmin = [0.2, 0]\nmax = [1, 0.5]\n"
      "[[body]]\nname = \"piston\"\nmin = [0.1, 0]\nmax = [0.2, 0.5]\n"
      "motion = \"moved\"\nposition = [\"0.2*t\", \"0\"]\n";
  const Situation s(box, 0.5);
  const auto volume = fullest_closed_volume(s.scene, &s.bodies, s.fluid(), 0.5);
  ASSERT_TRUE(volume);
  EXPECT_EQ("piston", volume->body);
  EXPECT_NEAR(0.2, volume->speed, 1e-6);
  EXPECT_NEAR(14 * 10, volume->room, 0.5);
  EXPECT_EQ(14 * 10, volume->particles);  // those behind the piston do not count
  const Situation open(box + "[walls]\nx_max = \"open\"\n", 0.5);
  EXPECT_FALSE(fullest_closed_volume(open.scene, &open.bodies, open.fluid(), 0.5));
}

TEST(Room, ABodyThatTurnsTakesNoRoomAway) {
  const Situation s(
      "[domain]\nmax = [1, 1]\n[fluid]\nmin = [0, 0]\nmax = [1, 0.2]\n[[body]]\nname = "
      "\"stirrer\"\n"
      "min = [0.3, 0.45]\nmax = [0.7, 0.55]\nmotion = \"moved\"\nangle = \"90*t\"\n",
      0.3);
  const auto volume = fullest_closed_volume(s.scene, &s.bodies, s.fluid(), 0.3);
  ASSERT_TRUE(volume);
  EXPECT_EQ("", volume->body);
}

TEST(Room, CountsTheParticlesInTheZoneOfAnInlet) {
  Situation s(
      "[domain]\nmax = [1, 1]\n[fluid]\nmin = [0.5, 0]\nmax = [1, 0.2]\n[[inlet]]\n"
      "name = \"tap\"\ncenter = [0.2, 0.5]\ndirection = [1, 0]\nwidth = 0.1\nspeed = 1\n");
  for (std::size_t k = 0; k < 8; ++k) {  // two columns of four, in and beside the zone
    s.x[2 * k] = Real(k < 4 ? 0.175 : 0.125);
    s.x[2 * k + 1] = Real(0.425 + 0.05 * double(k % 4));
  }
  const auto inlet = most_crowded_inlet(s.scene, s.fluid(), 0);
  ASSERT_TRUE(inlet);
  EXPECT_EQ("tap", inlet->name);
  EXPECT_EQ(8, inlet->particles);
  EXPECT_EQ(6, inlet->room);
}

}  // namespace
}  // namespace freshet::test

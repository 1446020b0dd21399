// SPDX-License-Identifier: MIT
/// Bodies that move without a fluid.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bodies/bodies.h"
#include "scene/model/body_shape.h"
#include "scene/model/setup.h"

namespace freshet::test {

/// A scene of these bodies and perhaps of walls, without a fluid.
inline Scene scene_of(const std::string& bodies, bool flat = true, const std::string& domain = "") {
  return parse_scene((flat ? "[domain]\nmax = [10, 10]\n" : "[domain]\nmax = [10, 10, 10]\n") +
                         domain +
                         "[particles]\nspacing = 0.1\n[solver]\nname = \"wcsph\"\n"
                         "sound_speed = 10\n[time]\nend = 4\nstep = 0.001\n" +
                         bodies,
                     "test.toml");
}

class World {
 public:
  explicit World(const std::string& bodies, bool flat = true, const std::string& domain = "")
      : scene_(scene_of(bodies, flat, domain)), bodies_(scene_), nothing_(bodies_.size()) {}
  const BodyState& operator[](std::size_t k) const { return bodies_.states()[k]; }
  void run(double duration, double dt = 0.001) {
    for (const double end = time_ + duration - dt / 2; time_ < end; time_ += dt)
      bodies_.step(time_, dt, nothing_);
  }
  Bodies& bodies() { return bodies_; }

 private:
  Scene scene_;
  Bodies bodies_;
  std::vector<SixNumbers> nothing_;
  double time_ = 0;
};

inline double angle_of(const BodyState& b) {
  return 2 * std::atan2(b.orientation[2], b.orientation[3]);
}

/// Tests of free bodies, which need Bullet.
class FreeBodies : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  }
};

}  // namespace freshet::test

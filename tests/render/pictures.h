// SPDX-License-Identifier: MIT
/// Scenes and frames of a few particles, for tests of pictures.
#pragma once
#include <string>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/image.h"

namespace freshet::test {

/// A 2D scene with these tables: 200 × 100 px and a margin for a domain of 2 m × 1 m.
inline Scene flat_scene(const std::string& tables) {
  return parse_scene(
      "domain.max = [2, 1]\nparticles.spacing = 0.1\npicture.width = 210\npicture.height = 110\n"
      "time = { end = 2, step = 1e-3 }\nfluid = { min = [0, 0], max = [1, 0.5] }\n" +
          tables,
      "test.toml");
}

inline Frame two_dots() {
  Frame f;
  f.id = {0, 1};
  f.x = {0.5f, 0.5f, 1.5f, 0.5f};
  f.v = {0, 0, 0, 0};
  f.density = {1000, 1000};
  f.pressure = {0, 0};
  return f;
}

/// A 3D scene with these tables: a cube of 2 m around (0, 1, 0).
inline Scene deep_scene(const std::string& tables, const std::vector<Override>& changes = {}) {
  return parse_scene(
      "domain = { min = [-1, 0, -1], max = [1, 2, 1] }\nparticles.spacing = 0.2\n"
      "picture.width = 200\npicture.height = 200\ntime = { end = 2, step = 1e-3 }\n"
      "fluid = { min = [-1, 0, -1], max = [0, 1, 1] }\n" +
          tables,
      "test.toml", changes);
}

/// Balls at rest at these places.
inline Frame balls_at(std::vector<float> x) {
  Frame f;
  f.dimension = 3;
  f.x = std::move(x);
  f.v.assign(f.x.size(), 0);
  const std::size_t n = f.x.size() / 3;
  for (std::size_t i = 0; i < n; ++i) f.id.push_back(i);
  f.density.assign(n, 1000);
  f.pressure.assign(n, 0);
  return f;
}

inline int brightness_of(Color c) { return c.r + c.g + c.b; }

}  // namespace freshet::test

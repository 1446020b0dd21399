// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"
#include "freshet/simulation.h"

namespace freshet {

inline Scene article_scene(const std::vector<Override>& overrides = {}) {
  return load_scene(SOURCE_DIR "/scenes/article.toml", overrides);
}

inline Simulation after_steps(const Scene& scene, std::int64_t steps) {
  Simulation simulation(scene);
  for (std::int64_t k = 0; k < steps; ++k) simulation.step();
  return simulation;
}

}  // namespace freshet

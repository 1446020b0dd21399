// SPDX-License-Identifier: MIT
// A program that has Freshet inside: it runs a scene in memory and prints how the water's front moves.
// Build: cmake -S . -B build -DCMAKE_PREFIX_PATH=WHERE_FRESHET_IS_INSTALLED && cmake --build build
#include <freshet/simulation.h>

#include <algorithm>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: embed SCENE.toml\n");
    return 2;
  }
  try {
    freshet::Simulation sim(freshet::load_scene(argv[1], {{"time.end", "0.5"}}));
    while (!sim.finished()) {
      sim.step();
      if (sim.steps_done() % 100 != 0) continue;
      const freshet::ParticleView fluid = sim.fluid();
      freshet::Real front = 0;  // the largest x: two numbers a particle, x and y
      for (std::size_t i = 0; i < fluid.size(); ++i) front = std::max(front, fluid.x[2 * i]);
      std::printf("t = %.2f s   front at %.3f m\n", sim.time(), double(front));
    }
    std::printf("state %s\n", sim.state_sha256().c_str());
  } catch (const freshet::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

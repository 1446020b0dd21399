// SPDX-License-Identifier: MIT
// Steps a scene file in memory and prints the position of the water's front.
#include <freshet/simulation.h>

#include <algorithm>
#include <cstdio>

constexpr const char* dam_break = R"(
domain = { max = [1.0, 0.6] }
particles = { spacing = 0.02 }
fluid = { min = [0.0, 0.0], max = [0.3, 0.4] }
solver = { name = "dfsph" }
time = { end = 0.2, step = "adaptive", step_max = 0.002 }
)";

int main(int argc, char** argv) {
  try {
    freshet::Simulation sim(argc > 1 ? freshet::load_scene(argv[1])
                                     : freshet::parse_scene(dam_break, "dam_break"));
    while (!sim.finished()) {
      sim.step();
      if (sim.steps_done() % 20 != 0) continue;
      const freshet::ParticleView fluid = sim.fluid();
      const auto dimension = std::size_t(fluid.dimension);
      freshet::Real front = 0;
      for (std::size_t i = 0; i < fluid.size(); ++i)
        front = std::max(front, fluid.x[dimension * i]);
      std::printf("t = %.3f s   front at %.3f m\n", sim.time(), double(front));
    }
    std::printf("state %s\n", sim.state_sha256().c_str());
  } catch (const freshet::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

// SPDX-License-Identifier: MIT
// Runs the same scene with several viscosities, one thread each, and prints how far the liquid
// runs.
#include <freshet/simulation.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <vector>

constexpr const char* sheet = R"(
domain = { max = [1.0, 0.4] }
particles = { spacing = 0.02 }
fluid = { min = [0.0, 0.0], max = [0.2, 0.3] }
solver = { name = "dfsph", viscosity_method = "weiler2018" }
time = { end = 0.2, step = "adaptive", step_max = 0.002 }
)";

double front(double viscosity) {
  freshet::Scene scene = freshet::parse_scene(sheet, "sheet");
  scene.fluid[0].viscosity = viscosity;
  freshet::Simulation sim(scene, {.threads = 1, .isa = {}});
  while (!sim.finished()) sim.step();
  const freshet::ParticleView fluid = sim.fluid();
  freshet::Real front = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) front = std::max(front, fluid.x[2 * i]);
  return double(front);
}

int main() {
  try {
    const std::vector<double> viscosities{0.1, 1, 10};
    std::vector<std::future<double>> fronts;
    for (const double mu : viscosities) fronts.push_back(std::async(std::launch::async, front, mu));
    for (std::size_t k = 0; k < viscosities.size(); ++k)
      std::printf("viscosity %5.1f Pa s   front at %.3f m\n", viscosities[k], fronts[k].get());
  } catch (const freshet::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

// SPDX-License-Identifier: MIT
// Observes a simulation with a schedule and a file of its own: writes the height of the water's
// highest particle to height.csv, every 10 ms of simulated time.
#include <freshet/simulation.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

constexpr const char* column = R"(
domain = { max = [0.8, 0.6] }
particles = { spacing = 0.02 }
fluid = { min = [0.0, 0.0], max = [0.2, 0.4] }
solver = { name = "iisph" }
time = { end = 0.2, step = 0.001 }
)";

double height(const freshet::ParticleView& fluid) {
  freshet::Real top = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) top = std::max(top, fluid.x[2 * i + 1]);
  return double(top);
}

int main() {
  try {
    freshet::Simulation sim(freshet::parse_scene(column, "column"));
    std::ofstream out("height.csv");
    out << "time [s],height [m]\n";
    sim.observe({.seconds = 0.01}, [&](const freshet::Simulation& s) {
      out << s.time() << "," << height(s.fluid()) << "\n";
    });
    while (!sim.finished()) sim.step();
    if (!out.flush()) throw freshet::Error(freshet::Error::Kind::run, "height.csv", "not written");
    std::puts("wrote height.csv");
  } catch (const freshet::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

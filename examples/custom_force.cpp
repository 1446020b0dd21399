// SPDX-License-Identifier: MIT
// Adds a force of the caller: an attractor moves in a circle and pulls at weightless water.
#include <freshet/simulation.h>

#include <cmath>
#include <cstdio>

constexpr const char* pond = R"(
domain = { max = [1.0, 1.0], gravity = [0.0, 0.0] }
particles = { spacing = 0.025 }
fluid = { shape = "sphere", center = [0.5, 0.5], radius = 0.2 }
solver = { name = "wcsph", sound_speed = 20.0 }
time = { end = 0.2, step = 0.0005 }
)";

int main() {
  try {
    freshet::Simulation sim(freshet::parse_scene(pond, "pond"));
    sim.set_force([](const freshet::ParticleView& fluid, double time, std::span<double> a) {
      const double x = 0.5 + 0.3 * std::cos(5 * time), y = 0.5 + 0.3 * std::sin(5 * time);
      for (std::size_t i = 0; i < fluid.size(); ++i) {
        a[2 * i] += 10 * (x - double(fluid.x[2 * i]));
        a[2 * i + 1] += 10 * (y - double(fluid.x[2 * i + 1]));
      }
    });
    while (!sim.finished()) sim.step();
    const freshet::Statistics s = sim.statistics();
    std::printf("momentum after %.1f s: (%.2f, %.2f) (kg m/s)/m\n", sim.time(), s.momentum[0],
                s.momentum[1]);
  } catch (const freshet::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

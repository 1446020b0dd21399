// SPDX-License-Identifier: MIT
// Builds a scene in code, without a file: a drop falls into a pool. Prints its statistics.
#include <freshet/simulation.h>

#include <cstdio>

freshet::Scene drop_into_pool() {
  freshet::Scene scene;
  scene.domain.max = {0.6, 0.6};
  scene.particles.spacing = 0.02;
  freshet::Scene::Fluid pool, drop;
  pool.min = {0, 0};
  pool.max = {0.6, 0.2};
  drop.shape = freshet::Shape::sphere;
  drop.center = {0.3, 0.4};
  drop.radius = 0.08;
  drop.velocity = {0, -1};
  scene.fluid = {pool, drop};
  scene.solver.name = freshet::SolverName::dfsph;
  scene.time.end = 0.15;
  scene.time.adaptive = true;
  scene.time.step_max = 0.002;
  return scene;
}

int main() {
  try {
    freshet::Simulation sim(drop_into_pool());
    while (!sim.finished()) sim.step();
    const freshet::Statistics s = sim.statistics();
    std::printf("%lld particles after %lld steps, fastest %.2f m/s, density error %.4f %%\n",
                static_cast<long long>(s.particles), static_cast<long long>(sim.steps_done()),
                s.speed_max, 100 * s.density_error_mean);
  } catch (const freshet::Error& error) {  // an error in the scene names its key
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

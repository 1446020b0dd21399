// SPDX-License-Identifier: MIT
// The cpu backend has the reference backend's bits, with every instruction set of this machine and
// on any number of threads.
#include <gtest/gtest.h>

#include <random>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "backend/reference/reference_backend.h"
#include "backend/reference/reference_sets_impl.h"
#include "freshet/simulation.h"
#include "kernels/poly6.h"
#include "pairs/density.h"
#include "solvers/backend.h"

namespace freshet {
namespace {

static_assert(Backend<CpuBackend<2>, 2> && Backend<CpuBackend<3>, 3>);

std::vector<std::string> instruction_sets() {
  std::vector<std::string> all;
  for (const char* isa : {"plain", "sse42", "avx2", "avx512"}) {
    try {
      all.push_back(instruction_set(isa));
    } catch (const Error&) {  // not on this machine
    }
  }
  return all;
}

struct Digests {
  std::string state, kept;
  bool operator==(const Digests&) const = default;
};

Digests run(const char* scene, std::vector<Override> overrides, const char* backend, int steps,
            const Execution& execution = {}) {
  overrides.emplace_back("solver.backend", backend);
  Simulation sim(load_scene(std::string(SOURCE_DIR "/scenes/") + scene, overrides), execution);
  for (int k = 0; k < steps; ++k) sim.step();
  return {sim.state_sha256(), sim.kept_sha256()};
}

void expect_the_references_bits(const char* scene, const std::vector<Override>& overrides,
                                int steps) {
  const Digests reference = run(scene, overrides, "reference", steps);
  for (const std::string& isa : instruction_sets())
    for (const int threads : {7, 3, 2, 1})  // descending: clang's libomp leaks when a team grows
      EXPECT_EQ(reference, run(scene, overrides, "cpu", steps, {threads, isa}))
          << isa << " on " << threads << " threads";
}

TEST(CpuBackend, HasTheReferencesBitsInTheArticlesScheme) {
  expect_the_references_bits("article.toml", {{"solver.neighbor_order", "cell"}}, 300);
}

TEST(CpuBackend, HasTheReferencesBitsInThePapersScheme) {
  expect_the_references_bits("article_corrected.toml",
                             {{"particles.spacing", "0.03"},
                              {"particles.support_radius", "0.07"},
                              {"time.step", "0.0003"}},
                             120);
}

// A few particles, then a single one: packs and slices are not full.
TEST(CpuBackend, HasTheReferencesBitsForAFewParticles) {
  for (const char* corner : {"[0.2, 0.2]", "[0.04, 0.04]"})
    expect_the_references_bits("article_corrected.toml", {{"fluid.max", corner}}, 20);
}

// Two drops in opposite corners of a wide domain: the torus of cells wraps.
TEST(CpuBackend, HasTheReferencesBitsFarApart) {
  const std::string text = R"(
domain = { max = [5000.0, 5000.0] }
particles = { spacing = 0.5 }
solver = { stiffness = 1000.0 }
time = { end = 0.1, step = 0.001 }
fluid = [ { min = [0, 0], max = [5, 5], velocity = [1, 2] },
          { min = [4990, 4990], max = [4998, 4994], velocity = [-3, 1] } ]
)";
  const auto state = [&](const char* backend) {
    Simulation sim(parse_scene(text, "far apart", {{"solver.backend", backend}}));
    while (sim.steps_done() < 50) sim.step();
    return sim.state_sha256();
  };
  EXPECT_EQ(state("reference"), state("cpu"));
}

/// Densities by id of a fluid set, summed over the fluid and a wall set in 3D.
template <class AnyBackend> std::vector<Real> densities(AnyBackend backend) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> at(-1, 1);
  Particles<3> fluid, wall;
  Field<Real> rho;
  backend.add_set(fluid, 1003);
  backend.add_set(wall, 517);
  for (Particles<3>* set : {&fluid, &wall}) {
    backend.allocate(*set, Keep::kept, set->id);
    backend.allocate(*set, Keep::kept, set->x);
    for (int i = 0; i < set->n; ++i) {
      set->id[i] = std::uint64_t(i);
      set->x[i] = {Real(at(generator)), Real(at(generator)), Real(at(generator))};
    }
  }
  backend.allocate(fluid, Keep::scratch, rho);
  const Density near{Poly6<3>(Real(0.4f)), Real(1)}, far{Poly6<3>(Real(0.4f)), Real(3)};
  for (int step = 0; step < 2; ++step) {  // in the second step, the wall is sorted already
    backend.find_neighbors("neighbors", Real(0.4f), fluid, wall);
    const auto f = rho;
    backend.sum_pairs("density", fluid, over(fluid, near), over(wall, far),
                      [=](int i, Real sum) { f[i] = sum; });
  }
  std::vector<Real> by_id(std::size_t(fluid.n));
  for (int i = 0; i < fluid.n; ++i) by_id[fluid.id[i]] = rho[i];
  return by_id;
}

TEST(CpuBackend, HasTheReferencesBitsInASumOverTwoSets) {
  const auto reference = densities(ReferenceBackend<3>());
  EXPECT_GT(*std::max_element(reference.begin(), reference.end()), 0);
  for (const int threads : {3, 1}) EXPECT_EQ(reference, densities(CpuBackend<3>(threads)));
}

TEST(CpuCellGrid, HasAtMostEightCellsPerParticle) {
  const Threads threads(2);
  CpuBackend<3> backend(2);
  Particles<3> p;
  backend.add_set(p, 1000);
  backend.allocate(p, Keep::kept, p.id);
  backend.allocate(p, Keep::kept, p.x);
  for (int i = 0; i < p.n; ++i) {
    p.id[i] = std::uint64_t(i);
    p.x[i] = {Real(i % 10), Real(i / 10 % 10), Real(i / 100)};
  }
  CpuCellGrid<3> grid;
  grid.build(threads, Real(2), p);
  EXPECT_EQ(5 * 5 * 19, grid.cell_count());
  p.x[17] = {Real(1e4f), Real(-2e7f), Real(3e12f)};
  p.x[18].x = std::numeric_limits<Real>::quiet_NaN();
  grid.build(threads, Real(2), p);
  EXPECT_LE(grid.cell_count(), 8 * p.n);
  int crowded = 0;  // the other particles are still spread over the cells
  for (int c = 0; c < grid.cell_count(); ++c) crowded += grid.end(c) - grid.begin(c) > 64;
  EXPECT_EQ(0, crowded);
}

}  // namespace
}  // namespace freshet

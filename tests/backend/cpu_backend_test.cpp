// SPDX-License-Identifier: MIT
// The cpu backend has the reference's very bits, on every instruction set that this machine has and
// on any number of threads.
#include <gtest/gtest.h>

#include "backend/cpu/cpu_backend.h"
#include "freshet/simulation.h"
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

// A few particles, then a single one: packs and slices that are not full.
TEST(CpuBackend, HasTheReferencesBitsForAFewParticles) {
  for (const char* corner : {"[0.2, 0.2]", "[0.04, 0.04]"})
    expect_the_references_bits("article_corrected.toml", {{"fluid.max", corner}}, 20);
}

// Two drops in the far corners of a wide domain: the torus of cells wraps, and no bit changes.
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

TEST(CpuCellGrid, TakesNoMoreCellsForASplashFarAway) {
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
  EXPECT_EQ(125, grid.cell_count());
  p.x[17] = {Real(1e4f), Real(-2e7f), Real(3e12f)};
  p.x[18].x = std::numeric_limits<Real>::quiet_NaN();
  grid.build(threads, Real(2), p);
  EXPECT_LE(grid.cell_count(), 2 * p.n);
  int crowded = 0;  // the others did not all land in one cell
  for (int c = 0; c < grid.cell_count(); ++c) crowded += grid.end(c) - grid.begin(c) > 64;
  EXPECT_EQ(0, crowded);
}

}  // namespace
}  // namespace freshet

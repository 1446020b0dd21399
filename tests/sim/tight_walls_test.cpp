// SPDX-License-Identifier: MIT
// Sheets and walls of points, hit by a jet.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/files.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

constexpr double dx = 0.04, height = 0.2;

struct Jet {
  const char *name, *shape, *method, *solver;
  int dimension;
};
void PrintTo(const Jet& jet, std::ostream* out) { *out << jet.name; }

class TightWallsUnderAJet : public ::testing::TestWithParam<Jet> {
 protected:
  /// A square across the tank as a sheet of two triangles, or its points.
  void SetUp() override {
    const int n = 12;
    std::string line = "x,y\n", plane = "x,y,z\n";
    for (int k = 0; k < n; ++k) {
      const std::string x = std::to_string((k - 0.5) * dx);
      line += x + "," + std::to_string(height) + "\n";
      for (int j = 0; j < n; ++j)
        plane += x + "," + std::to_string(height) + "," + std::to_string((j - 0.5) * dx) + "\n";
    }
    write_text(folder_ / "line.csv", line);
    write_text(folder_ / "plane.csv", plane);
    write_text(folder_ / "sheet.ply",
               "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
               "end_header\n-0.04 0.2 -0.04\n0.44 0.2 -0.04\n0.44 0.2 0.44\n-0.04 0.2 0.44\n"
               "3 0 1 2\n3 0 2 3\n");
  }
  std::string scene() const {
    const Jet& jet = GetParam();
    const bool flat = jet.dimension == 2, mesh = jet.shape == std::string("mesh");
    const char* file = mesh ? "sheet.ply" : flat ? "line.csv" : "plane.csv";
    return std::string("[domain]\nmax = ") + (flat ? "[0.4, 0.8]" : "[0.4, 0.8, 0.4]") +
           "\n[particles]\nspacing = 0.04\n[fluid]\nmin = " +
           (flat ? "[0.08, 0.28]\nmax = [0.32, 0.52]\nvelocity = [0.3, -4]"
                 : "[0.08, 0.28, 0.08]\nmax = [0.32, 0.52, 0.32]\nvelocity = [0.3, -4, 0.2]") +
           "\n[[wall]]\nshape = \"" + jet.shape + "\"\nfile = \"" + (folder_ / file).string() +
           "\"\nmethod = \"" + jet.method + "\"\n[solver]\nname = \"" + jet.solver +
           "\"\n[time]\nend = 0.15\nstep = \"adaptive\"\nstep_max = 0.002\n";
  }
  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(
    Walls, TightWallsUnderAJet,
    ::testing::Values(Jet{"line_wcsph", "points", "monaghan2009", "wcsph", 2},
                      Jet{"line_delta_sph", "points", "monaghan2009", "delta_sph", 2},
                      Jet{"line_dfsph", "points", "monaghan2009", "dfsph", 2},
                      Jet{"points_dfsph", "points", "monaghan2009", "dfsph", 3},
                      Jet{"points_wcsph", "points", "monaghan2009", "wcsph", 3},
                      Jet{"sheet_iisph", "mesh", "akinci2012", "iisph", 3},
                      Jet{"sheet_pbf", "mesh", "akinci2012", "pbf", 3},
                      Jet{"sheet_pcisph", "mesh", "akinci2012", "pcisph", 3}),
    [](const auto& jet) { return std::string(jet.param.name); });

/// Between boundary particles 1 to 8 of 36 or 216 particles went through.
TEST_P(TightWallsUnderAJet, LetNoParticleThrough) {
  Simulation sim = simulation_of(scene(), "cpu");
  double lowest = 1;
  while (!sim.finished()) {
    sim.step();
    const ParticleView f = sim.fluid();
    for (std::size_t i = 0; i < f.size(); ++i) lowest = std::min(lowest, f.position(i, 1));
  }
  EXPECT_GT(lowest, height);
  EXPECT_LT(lowest, height + dx) << "the jet must reach the wall";
}

}  // namespace
}  // namespace freshet::test

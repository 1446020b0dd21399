// SPDX-License-Identifier: MIT
// Sheets, walls of points and thin solids, hit by a jet.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/files.h"
#include "sim/forced.h"

namespace freshet::test {
namespace {

constexpr double dx = 0.04, height = 0.2;

struct Jet {
  const char *name, *solid, *solver;  // `solid` is a table of the scene
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
    const bool flat = jet.dimension == 2;
    std::string solid = jet.solid;
    if (const auto at = solid.find("FOLDER"); at != std::string::npos)
      solid.replace(at, 6, folder_.path().string());
    return std::string("[domain]\nmax = ") + (flat ? "[0.4, 0.8]" : "[0.4, 0.8, 0.4]") +
           "\n[particles]\nspacing = 0.04\n[fluid]\nmin = " +
           (flat ? "[0.08, 0.28]\nmax = [0.32, 0.52]\nvelocity = [0.3, -4]"
                 : "[0.08, 0.28, 0.08]\nmax = [0.32, 0.52, 0.32]\nvelocity = [0.3, -4, 0.2]") +
           "\n" + solid + "\n[solver]\nname = \"" + jet.solver +
           "\"\n[walls]\nmethod = \"akinci2012\"\n[time]\nend = 0.15\nstep = \"adaptive\"\n" +
           "step_max = 0.002\n";
  }
  TemporaryFolder folder_;
};

const char* const line =
    "[[wall]]\nshape = \"points\"\nfile = \"FOLDER/line.csv\"\nmethod = \"monaghan2009\"";
const char* const points =
    "[[wall]]\nshape = \"points\"\nfile = \"FOLDER/plane.csv\"\nmethod = \"monaghan2009\"";
const char* const sheet = "[[wall]]\nshape = \"mesh\"\nfile = \"FOLDER/sheet.ply\"";
const char* const box_2d =
    "[[wall]]\nmin = [-0.04, 0.16]\nmax = [0.44, 0.2]\nmethod = \"monaghan2009\"";
const char* const polygon =
    "[[wall]]\nshape = \"polygon\"\npoints = [[-0.04, 0.19], [0.44, 0.19], [0.44, 0.2], "
    "[-0.04, 0.2]]\nmethod = \"monaghan2009\"";
const char* const box_3d = "[[wall]]\nmin = [-0.04, 0.16, -0.04]\nmax = [0.44, 0.2, 0.44]";
const char* const plate =
    "[[body]]\nmin = [0, 0.16, 0]\nmax = [0.4, 0.2, 0.4]\nmotion = \"moved\"\n"
    "position = [\"0\", \"0.02*(cos(40*t)-1)\", \"0\"]";

INSTANTIATE_TEST_SUITE_P(
    Walls, TightWallsUnderAJet,
    ::testing::Values(
        Jet{"line_wcsph", line, "wcsph", 2}, Jet{"line_delta_sph", line, "delta_sph", 2},
        Jet{"line_dfsph", line, "dfsph", 2}, Jet{"points_dfsph", points, "dfsph", 3},
        Jet{"points_wcsph", points, "wcsph", 3}, Jet{"sheet_iisph", sheet, "iisph", 3},
        Jet{"sheet_pbf", sheet, "pbf", 3}, Jet{"sheet_pcisph", sheet, "pcisph", 3},
        Jet{"box_wcsph", box_2d, "wcsph", 2}, Jet{"polygon_dfsph", polygon, "dfsph", 2},
        Jet{"box_pbf", box_3d, "pbf", 3}, Jet{"box_pcisph", box_3d, "pcisph", 3},
        Jet{"moved_plate_pcisph", plate, "pcisph", 3}, Jet{"moved_plate_wcsph", plate, "wcsph", 3}),
    [](const auto& jet) { return std::string(jet.param.name); });

/// Between boundary particles, 1 to 17 of 36 or 216 particles went through.
TEST_P(TightWallsUnderAJet, LetNoParticleThrough) {
  if (!compiled(GetParam().solver)) GTEST_SKIP() << "not compiled in this build";
  Simulation sim = simulation_of(scene(), "cpu");
  double lowest = 1;
  while (!sim.finished()) {
    sim.step();
    const ParticleView f = sim.fluid();
    const double moved = sim.bodies().empty() ? 0 : sim.bodies()[0].position[1] - height + dx / 2;
    for (std::size_t i = 0; i < f.size(); ++i) lowest = std::min(lowest, f.position(i, 1) - moved);
  }
  EXPECT_GT(lowest, height - 1e-6);
  EXPECT_LT(lowest, height + dx) << "the jet must reach the wall";
}

/// A free plate in a jet takes up the impulse of the particles that it stops.
TEST(TightWalls, KeepTheMomentumOfFluidAndBody) {
  if (!compiled("pcisph")) GTEST_SKIP() << "not compiled in this build";
  Simulation sim = simulation_of(
      "[domain]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\ngravity = [0, 0, 0]\n[particles]\n"
      "spacing = 0.04\n[fluid]\nmin = [-0.08, 0.08, -0.12]\nmax = [0.16, 0.28, 0.12]\n"
      "velocity = [0.3, -4, 0.2]\n[[body]]\nmin = [-0.2, 0, -0.2]\nmax = [0.2, 0.04, 0.2]\n"
      "motion = \"free\"\ndensity = 800\n[solver]\nname = \"pcisph\"\n[walls]\n"
      "method = \"open\"\n[time]\nend = 0.1\nstep = \"adaptive\"\nstep_max = 0.002\n");
  const double body_mass = 0.4 * 0.04 * 0.4 * 800;
  const auto momentum = [&] {
    Vector all = sim.statistics().momentum;
    for (std::size_t k = 0; k < 3; ++k) all[k] += body_mass * sim.bodies()[0].velocity[k];
    return all;
  };
  const Vector before = momentum();
  while (!sim.finished()) sim.step();
  const Vector after = momentum();
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(before[k], after[k], 1e-4 * std::abs(before[1])) << k;
}

}  // namespace
}  // namespace freshet::test

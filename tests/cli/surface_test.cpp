// SPDX-License-Identifier: MIT
/// `freshet surface` makes meshes of a finished run.
#include <gtest/gtest.h>

#include "cli/cubes.h"
#include "cli/process.h"
#include "mesh/triangle_mesh.h"

namespace freshet::test {
namespace {

class SurfaceCommand : public testing::Test {
 protected:
  SurfaceCommand() { make_cubes(run); }
  ProcessResult surface(std::vector<std::string> more = {}, const ProcessOptions& how = {}) {
    more.insert(more.begin(), {"surface", run.string()});
    return freshet(more, how);
  }
  void expect_refused(const ProcessResult& r, const std::string& words) {
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, words)) << r.err;
  }
  std::set<std::string> surfaces() { return files_below(run / "surface"); }
  TemporaryFolder folder;
  fs::path run = folder / "run";
};

TEST_F(SurfaceCommand, MakesAMeshOfEveryFrame) {
  const auto r = surface();
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "3 surfaces in ")) << r.out;
  EXPECT_EQ(surfaces(),
            (std::set<std::string>{"surface_0000.ply", "surface_0001.ply", "surface_0002.ply"}));
  TriangleMesh mesh = read_mesh(run / "surface/surface_0001.ply");
  const std::size_t points = mesh.points.size();
  const MeshCondition condition = mend_mesh(mesh);
  EXPECT_TRUE(condition.closed());
  EXPECT_EQ(condition.crowded + condition.degenerate + condition.doubled + condition.turned, 0);
  EXPECT_EQ(mesh.points.size(), points);
  double volume = 0, low = 1e9, high = -1e9;
  for (int t = 0; t < int(mesh.triangles.size()); ++t) {
    const auto [a, b, c] = mesh.corners(t);
    volume += dot(a, cross(b, c)) / 6;
  }
  for (const auto& p : mesh.points) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  EXPECT_NEAR(volume, 0.512, 0.015);  // its edges are round
  EXPECT_NEAR(low, 0.6, 0.02);
  EXPECT_NEAR(high, 1.4, 0.02);
  EXPECT_TRUE(contains(read_text(run / "surface/surface_0002.ply"), "element vertex 0\n"));
}

TEST_F(SurfaceCommand, TakesChosenFramesAndFormats) {
  ASSERT_EQ(surface({"--from", "1", "--to", "1", "--format", "glb", "--quiet"}).out, "");
  EXPECT_EQ(surfaces(), (std::set<std::string>{"surface_0001.glb"}));
  EXPECT_EQ(read_text(run / "surface/surface_0001.glb").substr(0, 4), "glTF");
  ASSERT_EQ(surface({"--every", "2", "--format", "vtp", "--output", (folder / "v").string()}).code,
            0);
  EXPECT_EQ(files_below(folder / "v"),
            (std::set<std::string>{"surface_0000.vtp", "surface_0002.vtp", "surfaces.pvd"}));
  EXPECT_TRUE(contains(read_text(folder / "v/surfaces.pvd"),
                       "timestep=\"0.2\" part=\"0\" file=\"surface_0002.vtp\""));
  ASSERT_EQ(surface({"--to", "0", "--format", "vdb", "--output", (folder / "g").string()}).code, 0);
  EXPECT_EQ(read_text(folder / "g/surface_0000.vdb").substr(0, 4), " BDV");
  ASSERT_EQ(surface({"--to", "0", "--format", "obj", "--output", (folder / "o").string()}).code, 0);
  EXPECT_TRUE(contains(read_text(folder / "o/surface_0000.obj"), "\nvn "));
  expect_refused(surface({"--from", "7"}),
                 "the numbers of the data files are 0 to 2; change --from");
}

TEST_F(SurfaceCommand, MakesAMeshForEachLiquid) {
  ASSERT_EQ(surface({"--phases", "--to", "0"}).code, 0);
  EXPECT_EQ(surfaces(),
            (std::set<std::string>{"surface_liquid0_0000.ply", "surface_liquid1_0000.ply"}));
  const auto lower = read_mesh(run / "surface/surface_liquid0_0000.ply");
  for (const auto& p : lower.points) EXPECT_LT(p.z, 0.95);
}

TEST_F(SurfaceCommand, HasTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "4"})
    ASSERT_EQ(surface({"--threads", threads, "--output", (folder / threads).string()}).code, 0);
  EXPECT_EQ(read_text(folder / "1/surface_0000.ply"), read_text(folder / "4/surface_0000.ply"));
}

TEST_F(SurfaceCommand, ReplacesSurfacesOnlyWithOverwrite) {
  EXPECT_EQ(surface().code, 0);
  expect_refused(surface(), "this folder holds surfaces; --overwrite replaces them");
  EXPECT_EQ(surface({"--overwrite", "--cell", "1"}).code, 0);
}

TEST_F(SurfaceCommand, WarnsOfMissingFrames) {
  fs::remove(run / data_file(DataFormat::vtp, 1));
  const auto r = surface();
  EXPECT_EQ(r.code, 0);
  EXPECT_TRUE(contains(r.err, "warning: data files are missing: 0001; they get no surface"))
      << r.err;
  EXPECT_EQ(surface({"--every", "2", "--overwrite"}).err, "");
}

TEST_F(SurfaceCommand, RejectsWhatHasNoSurface) {
  expect_refused(surface({"--cell", "0"}), "--cell");
  expect_refused(surface({"--threads", "100000"}), "--threads 100000: error: at most ");
  std::string bytes = read_text(run / data_file(DataFormat::vtp, 1));
  const float nan = std::nanf(""), x = 0.55f;  // the x of the first particle
  const std::string good(reinterpret_cast<const char*>(&x), 4);
  bytes.replace(bytes.find(good, bytes.find("<AppendedData")), 4,
                reinterpret_cast<const char*>(&nan), 4);
  write_text(run / data_file(DataFormat::vtp, 1), bytes);
  expect_refused(surface(), "frame_0001.vtp: error: array \"points\" is nan at point 0");
  fs::remove_all(run / "data");
  expect_refused(surface(), "this run wrote no data to make surfaces of");
  fs::remove(run / "scene.toml");
  expect_refused(surface(), "no run is in this folder");
  make_cubes(run, true);
  expect_refused(surface(), "scene.toml: error: this run is in 2D; a surface needs a run in 3D");
}

TEST_F(SurfaceCommand, LeavesNoPartOfAFileThatDoesNotFit) {
  const auto r = surface({"--threads", "1"}, {.file_limit = 2000});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "surface_0000.ply: error: cannot write: ")) << r.err;
  EXPECT_TRUE(contains(r.err, "limit on file sizes")) << r.err;
  EXPECT_TRUE(surfaces().empty());
}

TEST_F(SurfaceCommand, WritesNothingThroughALinkInTheRun) {
  fs::create_directories(folder / "outside");
  fs::create_directory_symlink("../outside", run / "surface");
  const auto r = surface({"--overwrite"});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "a symbolic link is in the way")) << r.err;
  EXPECT_TRUE(fs::is_empty(folder / "outside"));
}

}  // namespace
}  // namespace freshet::test

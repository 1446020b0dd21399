// SPDX-License-Identifier: MIT
/// A run whose scene has [surface] writes meshes while it runs.
#include <gtest/gtest.h>

#include <csignal>

#include "cli/resume.h"

namespace freshet::test {
namespace {

constexpr const char* column_in_3d = R"([domain]
max = [0.8, 0.6, 0.3]
[particles]
spacing = 0.05
[[fluid]]
min = [0.0, 0.0, 0.0]
max = [0.3, 0.4, 0.3]
[[fluid]]
min = [0.5, 0.0, 0.0]
max = [0.7, 0.2, 0.3]
rest_density = 800
[solver]
name = "wcsph"
[time]
end = 0.1
step = 0.0005
[output]
frame_every = 0.03
checkpoint_every_steps = 20
[picture]
width = 64
height = 64
[surface]
)";

class SurfaceOfRun : public Resume {
 protected:
  SurfaceOfRun() { write_text(folder / "scene.toml", column_in_3d); }
  std::set<std::string> surfaces(const std::string& run) const {
    return files_below(folder / run / "surface");
  }
  void expect_refused(const ProcessResult& r, const std::string& words) const {
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, words)) << r.err;
  }
};

TEST_F(SurfaceOfRun, HasTheMeshesOfItsDataFiles) {
  ASSERT_EQ(freshet(arguments("run", {"--threads", "1"})).code, 0);
  EXPECT_EQ(surfaces("run"),
            (std::set<std::string>{"surface_0000.ply", "surface_0001.ply", "surface_0002.ply",
                                   "surface_0003.ply", "surface_0004.ply"}));
  expect_whole_run(folder / "run");
  const std::string again = (folder / "again").string();
  ASSERT_EQ(freshet({"surface", (folder / "run").string(), "--output", again}).code, 0);
  for (const std::string& file : surfaces("run"))
    EXPECT_EQ(read_text(folder / "run/surface" / file), read_text(folder / "again" / file)) << file;
  ASSERT_EQ(freshet(arguments("threads", {"--threads", "3"})).code, 0);
  expect_same_run("run", "threads");
}

TEST_F(SurfaceOfRun, HasItsOwnTimesAndSettings) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "surface.every=0.05", "--set", "surface.format=vtp",
                                      "--set", "surface.phases=true", "--set", "output.data=[]"}))
                .code,
            0);
  std::set<std::string> expected;
  for (const std::string liquid : {"liquid0", "liquid1"}) {
    for (const char* number : {"0000", "0001", "0002"})
      expected.insert("surface_" + liquid + "_" + number + ".vtp");
    expected.insert("surfaces_" + liquid + ".pvd");
  }
  EXPECT_EQ(surfaces("run"), expected);
  const std::string times = read_text(folder / "run/surface/surfaces_liquid1.pvd");
  EXPECT_TRUE(contains(times, "timestep=\"0.05\" part=\"0\" file=\"surface_liquid1_0001.vtp\""))
      << times;
  EXPECT_TRUE(contains(times, "timestep=\"0.1\" part=\"0\" file=\"surface_liquid1_0002.vtp\""))
      << times;
  ASSERT_EQ(
      freshet(arguments("data", {"--set", "output.data_every=0.05", "--set", "output.data=[]"}))
          .code,
      0);
  EXPECT_EQ(surfaces("data").size(), 3u);
}

TEST_F(SurfaceOfRun, IsTheSameAfterAKill) {
  const std::vector<std::string> slow{
      "--set", "surface.cell=0.2", "--set", "surface.format=vtp", "--threads", "1"};
  ASSERT_EQ(freshet(arguments("whole", slow)).code, 0);
  Process killed(freshet_command(arguments("killed", slow)));
  const double limit = now() + 60 * slowdown;
  while (checkpoints("killed").size() < 2 && now() < limit) usleep(1000);
  killed.send(SIGKILL);
  killed.finish();
  ASSERT_FALSE(fs::exists(folder / "killed/report.json"));
  const auto r = resume("killed");
  ASSERT_EQ(r.code, 0) << r.err;
  expect_same_run("whole", "killed");
}

TEST_F(SurfaceOfRun, ReplacesItsOwnMeshesOnly) {
  ASSERT_EQ(freshet(arguments("run")).code, 0);
  expect_refused(freshet(arguments("run")), "--overwrite");
  expect_refused(
      freshet({"surface", (folder / "run").string(), "--overwrite"}),
      "run/surface: error: the run itself wrote these surfaces; choose another --output");
  ASSERT_EQ(freshet(arguments("run", {"--overwrite", "--unset", "surface"})).code, 0);
  EXPECT_FALSE(fs::exists(folder / "run/surface/surface_0000.ply"));
  write_text(folder / "run/surface/surface_0003.ply", "mine");
  expect_refused(freshet(arguments("run", {"--overwrite"})),
                 "surface_0003.ply: error: this file was not written by a run");
  EXPECT_EQ(read_text(folder / "run/surface/surface_0003.ply"), "mine");
}

TEST_F(SurfaceOfRun, FailsWhereAMeshDoesNotFit) {
  const auto r = freshet(arguments("run", {"--set", "surface.cell=0.1"}), {.file_limit = 600'000});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "surface_0000.ply: error: cannot write: ")) << r.err;
  EXPECT_TRUE(contains(read_text(folder / "run/manifest.json"), "failed"));
  EXPECT_FALSE(fs::exists(folder / "run/surface/surface_0000.ply"));
}

TEST_F(SurfaceOfRun, HasItsSizeInInfo) {
  const auto r = freshet({"info", (folder / "scene.toml").string()});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "B for the surfaces of 5, if their area stays")) << r.out;
}

}  // namespace
}  // namespace freshet::test

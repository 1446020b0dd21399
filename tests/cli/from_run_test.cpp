// SPDX-License-Identifier: MIT
// Fluids that start from a frame of another run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cli/files.h"
#include "cli/process.h"
#include "freshet/run_frames.h"
#include "scene/model/setup.h"

namespace freshet::test {
namespace {

std::string scene_of(const std::string& fluid, const std::string& solver = "delta_sph",
                     const std::string& more = "", double spacing = 0.05) {
  return fmt::format(
      "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = {}\n{}\n[solver]\nname = "
      "\"{}\"\n{}[time]\n"
      "end = 0.1\nstep = 0.0005\n[output]\nframe_every = 0.02\ncheckpoint_every_steps = 20\n"
      "[picture]\nwidth = 64\nheight = 64\n{}",
      spacing, fluid, solver, solver == "delta_sph" ? "sound_speed = 40.0\n" : "", more);
}

constexpr const char* first_column = "[[fluid]]\nmin = [0.0, 0.0]\nmax = [0.4, 0.6]\n";
constexpr const char* two_layers =
    "[[fluid]]\nmin = [0, 0]\nmax = [1, 0.2]\n"
    "[[fluid]]\nmin = [0, 0.2]\nmax = [1, 0.4]\nrest_density = 800\n";

class FromRun : public ::testing::Test {
 protected:
  ProcessResult run(const std::string& name, const std::string& text,
                    const std::vector<std::string>& more = {}) const {
    write_text(folder / (name + ".toml"), text);
    std::vector<std::string> all{"run", (folder / (name + ".toml")).string(), "--output",
                                 (folder / name).string(), "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return freshet(all);
  }
  ProcessResult check(const std::string& text) const {
    write_text(folder / "checked.toml", text);
    return freshet({"check", (folder / "checked.toml").string()});
  }
  void run_first(const std::string& fluid = first_column,
                 const std::string& solver = "delta_sph") const {
    const ProcessResult r = run("first", scene_of(fluid, solver));
    ASSERT_EQ(r.code, 0) << r.err;
  }
  std::string state(const std::string& name) const {
    return report_of(folder / name).at("state_sha256").get<std::string>();
  }
  const TemporaryFolder folder;
};

TEST_F(FromRun, StartsAsTheLastFrame) {
  run_first();
  ASSERT_EQ(run("second", scene_of("[fluid]\nfrom_run = \"first\"\n")).code, 0);
  const RunFrames first(folder / "first"), second(folder / "second");
  const Frame end = first.read(first.size() - 1), start = second.read(0);
  EXPECT_EQ(start.time, 0);
  EXPECT_EQ(end.x, start.x);
  EXPECT_EQ(end.v, start.v);
  ASSERT_EQ(end.density.size(), start.density.size());
  for (std::size_t i = 0; i < end.density.size(); ++i)  // the first frame has those after a step
    EXPECT_NEAR(end.density[i], start.density[i], 0.1) << i;
  // the fluid goes on moving from there
  double fastest = 0;
  for (const float v : start.v) fastest = std::max(fastest, std::abs(double(v)));
  EXPECT_GT(fastest, 0.3);
}

TEST_F(FromRun, ChoosesAFrameByTimeNumberOrFile) {
  run_first();
  const RunFrames first(folder / "first");
  const auto x_of = [&](const std::string& keys) {
    const Sample s =
        sample(parse_scene(scene_of("[fluid]\n" + keys), (folder / "a.toml").string()));
    return std::vector<float>(s.x.begin(), s.x.end());
  };
  const Frame third = first.read(2);
  EXPECT_EQ(x_of("from_run = \"first\"\ntime = 0.04\n"), third.x);
  EXPECT_EQ(x_of("from_run = \"first\"\nframe = 2\n"), third.x);
  EXPECT_EQ(x_of("from_run = \"first/data/frame_0002.vtp\"\n"), third.x);
  EXPECT_NE(x_of("from_run = \"first\"\nframe = 3\n"), third.x);
}

TEST_F(FromRun, IsResumedToTheSameBitsWithoutTheFirstRun) {
  run_first();
  const std::string text = scene_of("[fluid]\nfrom_run = \"first\"\nframe = 3\n");
  ASSERT_EQ(run("whole", text).code, 0);
  ASSERT_EQ(run("part", text, {"--set", "time.end=0.06"}).code, 0);
  fs::remove_all(folder / "first");
  const ProcessResult r =
      freshet({"resume", (folder / "part").string(), "--set", "time.end=0.1", "--quiet"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(state("part"), state("whole"));
}

TEST_F(FromRun, TakesOneLiquidEach) {
  run_first(two_layers, "wcsph");
  const std::string both =
      "[[fluid]]\nfrom_run = \"first\"\nliquid = 0\n"
      "[[fluid]]\nfrom_run = \"first\"\nliquid = 1\nrest_density = 800\n";
  const ProcessResult r = run("second", scene_of(both, "wcsph"));
  ASSERT_EQ(r.code, 0) << r.err;
  const RunFrames first(folder / "first"), second(folder / "second");
  EXPECT_EQ(first.read(first.size() - 1).x, second.read(0).x);
  EXPECT_EQ(first.read(0).liquid, second.read(0).liquid);
  const ProcessResult none = check(scene_of("[fluid]\nfrom_run = \"first\"\n", "wcsph"));
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err,
                       "the run has the liquids 0, 1; write a [[fluid]] for each, and "
                       "choose its liquid by fluid.liquid"))
      << none.err;
}

TEST_F(FromRun, RejectsWhatDoesNotFit) {
  run_first();
  const auto expect = [&](const std::string& text, const std::string& part) {
    const ProcessResult r = check(text);
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, part)) << r.err;
  };
  const std::string from = "[fluid]\nfrom_run = \"first\"\n";
  expect(
      scene_of(from, "delta_sph", "", 0.04),
      "fluid.from_run is a run with particles.spacing = 0.05, and it is 0.04 here: the masses of "
      "the particles would differ; set particles.spacing = 0.05");
  std::string in_3d = scene_of(from);
  in_3d.replace(in_3d.find("[1.0, 1.0]"), 10, "[1.0, 1.0, 1.0]");
  expect(in_3d, "fluid.from_run is a run in 2D, and this scene is in 3D; choose a run in 3D");
  expect(scene_of(from + "time = 0.05\n"),
         "this run has no data file at 0.05 s; the nearest are at 0.04 s (frame 2) and 0.06 s "
         "(frame 3); choose one by fluid.frame");
  expect(scene_of(from + "frame = 9\n"),
         "this run has no frame 9; its 6 data files have the numbers 0 to 5");
  expect(scene_of("[fluid]\nfrom_run = \"nowhere\"\n"), "no such run folder or data file");
  expect(scene_of(from + "min = [0, 0]\n"),
         "fluid.min is not used; fluid.from_run sets the particles; remove one of them");
  expect(scene_of(from + "liquid = 2\n"), "fluid.liquid is 2, and the run has the liquids 0;");
  expect(scene_of("[fluid]\nmin = [0, 0]\nmax = [1, 0.5]\nframe = 2\n"),
         "fluid.frame is not used; set fluid.from_run, or remove it");
  write_text(folder / "first/data/frame_0005.vtp", "damaged");
  expect(scene_of(from), "frame_0005.vtp");
}

}  // namespace
}  // namespace freshet::test

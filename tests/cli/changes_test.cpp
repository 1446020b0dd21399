// SPDX-License-Identifier: MIT
/// What a command line changes in a scene: --unset and --solver; and scenes that `new` copies.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

const std::string plain = (source_dir / "tests/scenes/good/plain.toml").string();

std::string error_of(const std::vector<std::string>& arguments) {
  const auto r = freshet(arguments);
  EXPECT_EQ(r.code, 2) << r.err;
  return r.err;
}

TEST(Unset, RemovesAKeyAndIsRecorded) {
  const TemporaryFolder folder;
  const auto r = freshet(short_run(
      folder / "run", {"--unset", "checks.height_mean_max", "--unset", "picture", "--quiet"}));
  EXPECT_EQ(r.code, 0) << r.err;
  const std::string text = read_text(folder / "run/scene.toml");
  EXPECT_TRUE(contains(text, "#   checks.height_mean_max (removed)")) << text;
  EXPECT_FALSE(contains(text, "\nheight_mean_max")) << text;
  EXPECT_FALSE(contains(text, "[picture]")) << text;
  EXPECT_EQ(freshet({"check", (folder / "run/scene.toml").string()}).code, 0);
}

TEST(Unset, WorksInEveryCommandThatSets) {
  const std::vector<std::string> unset{"--unset", "checks.density_mean_min"};
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"check", article}, {"info", article}, {"bench", article, "--steps", "1"}}) {
    auto all = command;
    all.insert(all.end(), unset.begin(), unset.end());
    EXPECT_EQ(freshet(all).code, 0) << command.front();
  }
  const TemporaryFolder folder;
  freshet(short_run(folder.path(), {"--quiet"}));
  const auto resumed =
      freshet({"resume", folder.path().string(), "--set", "time.end=0.06", "--unset", "checks"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_TRUE(contains(error_of({"resume", folder.path().string(), "--unset", "fluid.viscosity"}),
                       "--unset fluid.viscosity: error: this changes what has been simulated"));
}

TEST(Unset, IsBeforeSet) {
  EXPECT_EQ(freshet({"check", article, "--set", "time.end=1", "--unset", "time.end"}).code, 0);
}

TEST(Unset, ErrorsNameTheirKey) {
  const std::pair<const char*, const char*> cases[] = {{"time.ende", "did you mean end?"},
                                                       {"tme.end", "did you mean time?"},
                                                       {"air.velocity", "cannot be removed"},
                                                       {"fluid[7].count", "no fluid[7]"},
                                                       {"fluid[0]", "one table of several"},
                                                       {"domain.max.x", "not a table"},
                                                       {"", "not a key"},
                                                       {"time.end=1", "without a value"}};
  for (const auto& [key, words] : cases) {
    const std::string line = error_of({"check", article, "--unset", key});
    EXPECT_TRUE(line.starts_with(std::string("--unset ") + key + ": error: ")) << line;
    EXPECT_TRUE(contains(line, words)) << line;
  }
  EXPECT_TRUE(contains(error_of({"check", article, "--unset", "time.end"}), "time.end is missing"));
}

TEST(Solver, DropsTheKeysThatTheNewOneDoesNotUse) {
  const auto r = freshet({"check", article, "--solver", "wcsph"});
  EXPECT_EQ(r.code, 0) << r.err;
  for (const char* key : {"solver.scheme", "solver.stiffness", "solver.speed_limit",
                          "particles.mass", "walls.restitution"})
    EXPECT_TRUE(contains(r.err, std::string(": warning: dropped: ") + key + " is not used"))
        << key << " in\n"
        << r.err;
  EXPECT_EQ(freshet({"check", article, "--solver", "mueller2003"}).err,
            freshet({"check", article}).err);
}

TEST(Solver, DropsValuesThatTheNewOneDoesNotSupport) {
  const auto r = freshet({"check", "dam_break_2d", "--solver", "dfsph"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.err, "warning: dropped: walls.method is \"adami2012\"")) << r.err;
}

TEST(Solver, KeepsWhatTheCommandLineSetsAndWhatWasWrongBefore) {
  EXPECT_TRUE(
      contains(error_of({"check", plain, "--solver", "dfsph", "--set", "solver.stiffness=3"}),
               "--set solver.stiffness: error: solver.stiffness is not used"));
  const TemporaryFolder folder;
  write_text(folder / "wrong.toml", read_text(article) + "\n[air]\nvelocity = [1.0, 0.0]\n");
  EXPECT_TRUE(contains(error_of({"check", (folder / "wrong.toml").string(), "--solver", "dfsph"}),
                       "error: air.velocity is not used"));
}

TEST(Solver, IsRecordedInTheRun) {
  const TemporaryFolder folder;
  const auto r = freshet({"run", "article_corrected", "--solver", "dfsph", "--set",
                          "time.end=0.002", "--unset", "checks", "--output", folder.path()});
  EXPECT_EQ(r.code, 0) << r.err;
  const std::string text = read_text(folder / "scene.toml");
  EXPECT_TRUE(contains(text, "#   solver.stiffness (removed)")) << text;
  EXPECT_EQ(report_of(folder.path()).at("solver"), "dfsph");
}

TEST(New, CopiesASceneWithTheFilesThatItReads) {
  const TemporaryFolder folder;
  const std::string file = (folder / "mine/scene.toml").string();
  const auto r = freshet({"new", "knot", file});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(read_text(file), read_text(source_dir / "scenes/knot.toml"));
  EXPECT_EQ(read_text(folder / "mine/meshes/knot.obj"),
            read_text(source_dir / "scenes/meshes/knot.obj"));
  EXPECT_EQ(files_below(folder.path()).size(), 2u);
  EXPECT_TRUE(contains(error_of({"new", "knot", file}), file + ": error: exists already"));
  // the mesh is there already, and is the same
  EXPECT_EQ(freshet({"new", "knot", (folder / "mine/other.toml").string()}).code, 0);
  write_text(folder / "victim", "precious");
  std::filesystem::create_symlink(folder / "victim", folder / "mine/linked.toml.part");
  EXPECT_EQ(freshet({"new", "knot", (folder / "mine/linked.toml").string()}).code, 0);
  EXPECT_EQ(read_text(folder / "victim"), "precious");
  write_text(folder / "mine/meshes/knot.obj", "mine");
  EXPECT_TRUE(contains(error_of({"new", "knot", (folder / "mine/third.toml").string()}),
                       "knot.obj: error: exists already"));
  EXPECT_FALSE(fs::exists(folder / "mine/third.toml"));
  EXPECT_TRUE(contains(error_of({"new", "knto", file}), "did you mean knot?"));
}

// `new` can copy only what lies below the folder of a scene.
TEST(New, CopiesEveryBundledScene) {
  const TemporaryFolder folder;
  for (const std::string& name : lines_of(freshet({"scenes", "--names"}).out)) {
    const std::string file = (folder / name / "scene.toml").string();
    if (freshet({"check", name}).code != 0) continue;  // a build without Assimp, for example
    EXPECT_EQ(freshet({"new", name, file}).code, 0) << name;
    EXPECT_EQ(freshet({"check", file}).code, 0) << name;
  }
}

TEST(DefaultOutput, IsNumberedIfItHoldsARun) {
  const TemporaryFolder folder;
  const std::vector<std::string> command{"run",     article, "--set", "time.end=0.002",
                                         "--unset", "checks"};
  const auto start = [&](std::vector<std::string> more) {
    more.insert(more.begin(), command.begin(), command.end());
    return freshet(more, {.directory = folder.path()});
  };
  EXPECT_EQ(start({}).code, 0);
  const std::string first = read_text(folder / "runs/article/manifest.json");
  const auto second = start({});
  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_TRUE(contains(second.err, "runs/article holds a run")) << second.err;
  EXPECT_TRUE(contains(second.out, "wrote runs/article-2/result.png")) << second.out;
  const auto third = start({"--log", "json"});
  EXPECT_TRUE(contains(third.out, R"({"event":"output","output":"runs/article-3"})")) << third.out;
  EXPECT_EQ(read_text(folder / "runs/article/manifest.json"), first);
  EXPECT_EQ(start({"--overwrite"}).code, 0);
  EXPECT_FALSE(fs::exists(folder / "runs/article-4"));
  EXPECT_EQ(start({"--output", "runs/article"}).code, 2);
}

TEST(Unset, IsOfferedForKeysThatOtherChangesLeaveUnused) {
  const std::string tank =
      "domain.max = [1, 1]\nparticles.spacing = 0.1\nfluid = { min = [0, 0], max = [0.5, 0.5] }\n"
      "solver.name = \"wcsph\"\ntime = { end = 0.1, step = 1e-3 }\n"
      "walls = { method = \"reflection\", restitution = 0.2 }\n";
  const TemporaryFolder folder;
  write_text(folder / "tank.toml", tank);
  const std::string scene = (folder / "tank.toml").string();
  EXPECT_TRUE(contains(error_of({"check", scene, "--set", "walls.method=akinci2012"}),
                       "remove it, or choose that method; --unset walls.restitution removes it "
                       "for this run"));
  EXPECT_EQ(
      freshet({"check", scene, "--set", "walls.method=akinci2012", "--unset", "walls.restitution"})
          .code,
      0);
  const auto other =
      freshet({"check", scene, "--solver", "dfsph", "--set", "walls.method=akinci2012"});
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_TRUE(contains(other.err, "dropped: walls.restitution")) << other.err;
}

}  // namespace
}  // namespace freshet::test

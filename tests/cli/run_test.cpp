// SPDX-License-Identifier: MIT
/// Exit codes, output and logs of runs.
#include <gtest/gtest.h>

#include <csignal>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

const std::vector<std::string> no_height_check{"--set", "checks.height_mean_max=3"};

std::vector<std::string> good_run(const fs::path& output, std::vector<std::string> more = {}) {
  more.insert(more.end(), no_height_check.begin(), no_height_check.end());
  return short_run(output, more);
}

TEST(Run, PrintsPlainLinesToAPipe) {
  const TemporaryFolder folder;
  const auto r = freshet(good_run(folder.path()));
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "600 particles, 50 steps")) << r.out;
  EXPECT_TRUE(contains(r.out, "100 %")) << r.out;
  EXPECT_TRUE(contains(r.out, (folder / "result.png").string())) << r.out;
  for (const char control : {'\x1b', '\r', '\b'})
    EXPECT_EQ(r.out.find(control), std::string::npos) << r.out;
  EXPECT_TRUE(r.out.ends_with('\n'));
}

TEST(Run, LogsJsonEvents) {
  const TemporaryFolder folder;
  const auto r = freshet(good_run(folder.path(), {"--log", "json"}));
  EXPECT_EQ(r.code, 0) << r.err;
  std::vector<std::string> events;
  for (const std::string& line : lines_of(r.out)) {
    const Json json = Json::parse(line, nullptr, false);
    ASSERT_TRUE(json.is_object()) << line;
    if (json.at("event") != "warning") events.push_back(json.at("event"));
  }
  ASSERT_GE(events.size(), 3u);
  EXPECT_EQ(events.front(), "start");
  EXPECT_EQ(events[1], "progress");
  EXPECT_EQ(events.back(), "done");
}

std::vector<std::string> run_of_dfsph(const fs::path& output, std::vector<std::string> more = {}) {
  std::vector<std::string> all{"run",      (source_dir / "tests/scenes/good/plain.toml").string(),
                               "--output", output.string(),
                               "--set",    "solver.name=dfsph",
                               "--set",    "time.step=0.0005"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(Run, PrintsSolveStatistics) {
  const TemporaryFolder folder;
  const auto r = freshet(run_of_dfsph(folder.path()));
  EXPECT_EQ(r.code, 0) << r.err;
  for (const char* words : {" iterations  density ", "\n  divergence solve ", "\n  density solve ",
                            " did not converge\n", "\n  steps halved "})
    EXPECT_TRUE(contains(r.out, words)) << words << " in " << r.out;
  const Json solves = report_of(folder.path()).at("solves");
  ASSERT_EQ(solves.size(), 2u);
  EXPECT_EQ(solves[0].at("name"), "divergence");
  EXPECT_EQ(solves[1].at("name"), "density");
  EXPECT_GE(solves[1].at("solves"), 20);  // one per step, and more if steps were halved
}

TEST(Run, LogsSolveStatistics) {
  const TemporaryFolder folder;
  const auto r = freshet(run_of_dfsph(folder.path(), {"--log", "json"}));
  EXPECT_EQ(r.code, 0) << r.err;
  Json progress, done;
  for (const std::string& line : lines_of(r.out)) {
    const Json json = Json::parse(line, nullptr, false);
    if (json.at("event") == "progress") progress = json;
    if (json.at("event") == "done") done = json;
  }
  for (const Json& json : {progress, done}) {
    ASSERT_EQ(json.at("solves").size(), 2u) << json;
    EXPECT_EQ(json.at("solves")[1].at("name"), "density");
    EXPECT_TRUE(json.at("solves")[1].at("error").is_number());
    EXPECT_TRUE(json.at("retried").is_number());
  }
  EXPECT_GE(progress.at("solves")[1].at("iterations"), 1);
  const Json solves = report_of(folder.path()).at("solves");
  EXPECT_EQ(done.at("solves")[1].at("mean_iterations"), solves[1].at("mean_iterations"));
  EXPECT_EQ(done.at("solves")[1].at("worst_error"), solves[1].at("worst_error"));
}

TEST(Run, PrintsNothingWithQuiet) {
  const TemporaryFolder folder;
  const auto r = freshet(good_run(folder.path(), {"--quiet"}));
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err, "");
  expect_whole_run(folder.path());
}

TEST(Run, IsCompleteWithoutAReaderOfItsOutput) {
  const TemporaryFolder folder;
  const auto gone =
      freshet(good_run(folder / "gone", {"--set", "time.end=1"}), {.close_stdout_early = true});
  EXPECT_EQ(gone.code, 0) << gone.err << gone.ended_by;
  expect_whole_run(folder / "gone");
  const auto full = freshet(good_run(folder / "full"), {.stdout_file = "/dev/full"});
  EXPECT_EQ(full.ended_by, 0);
  expect_whole_run(folder / "full");
}

TEST(Run, PrintsTheUnitsOfItsDimension) {
  const TemporaryFolder folder;
  const auto printed = [&](const std::string& third) {
    write_text(folder / "scene.toml",
               "domain.max = [1, 1" + third + "]\nparticles.spacing = 0.2\nfluid = { min = [0, 0" +
                   third.substr(0, third.find('1')) + (third.empty() ? "" : "0") +
                   "], max = [1, 0.4" + third +
                   "] }\nsolver = { name = \"wcsph\", sound_speed = 30.0 }\n"
                   "time = { end = 0.002, step = 1e-3 }\nchecks.density_mean_min = 1\n");
    const auto r = freshet({"run", (folder / "scene.toml").string(), "--output",
                            (folder / "run").string(), "--overwrite"});
    EXPECT_EQ(r.code, 0) << r.err;
    return r.out;
  };
  const std::string slice = printed(""), solid = printed(", 1");
  for (const std::string& out : {slice, solid}) EXPECT_TRUE(contains(out, " kg/m³ ")) << out;
  EXPECT_TRUE(contains(slice, " J/m kinetic, ") && contains(slice, ") N/m\n")) << slice;
  EXPECT_TRUE(contains(solid, " J kinetic, ") && contains(solid, ") N\n")) << solid;
}

TEST(Run, FailsIfACheckFails) {
  const TemporaryFolder folder;
  const auto r = freshet(good_run(folder.path(), {"--set", "checks.density_mean_min=100"}));
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "error: check failed: density mean is ")) << r.err;
  EXPECT_TRUE(contains(r.err, "> 100")) << r.err;
  const Json report = report_of(folder.path());
  EXPECT_EQ(report.at("state"), "check failed");
  expect_whole_run(folder.path());
}

TEST(Run, IsCompleteWhenInterrupted) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    const auto r = freshet(long_run(folder.path(), {"--set", "checks.speed_mean_max=1e-9"}),
                           {.signal = signal, .signal_after = "particles"});
    EXPECT_EQ(r.code, 130) << r.err << r.ended_by;
    EXPECT_TRUE(contains(r.out, "interrupted after")) << r.out;
    EXPECT_TRUE(contains(r.out, "< 1e-09  at the end")) << r.out;
    EXPECT_FALSE(contains(r.out, "FAILED")) << r.out;
    EXPECT_FALSE(contains(r.err, "check failed")) << r.err;
    expect_whole_run(folder.path());
    const Json report = report_of(folder.path());
    EXPECT_EQ(report.at("state"), "interrupted");
    EXPECT_LT(report.at("steps"), 500000);
    EXPECT_GT(report.at("steps"), 0);
    EXPECT_TRUE(fs::exists(folder / "result.png"));
  }
}

TEST(Run, LogsAnInterruption) {
  const TemporaryFolder folder;
  const auto r = freshet(long_run(folder.path(), {"--log", "json"}),
                         {.signal = SIGINT, .signal_after = "progress"});
  EXPECT_EQ(r.code, 130);
  EXPECT_EQ(Json::parse(lines_of(r.out).back()).at("event"), "interrupted");
}

TEST(Run, ReportsALostParticle) {
  const TemporaryFolder folder;
  const std::string scene = (source_dir / "tests/scenes/good/plain.toml").string();
  const auto r = freshet({"run", scene, "--output", folder.path().string(), "--quiet",  //
                          "--set", "domain.gravity=[0, -1e15]", "--set", "time.step=1e12", "--set",
                          "time.end=1e14"});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(r.err.starts_with("error: particle ")) << r.err;
  for (const char* words : {"at step ", "1e+12 s", "time.step", "over its bound", "smaller"})
    EXPECT_TRUE(contains(r.err, words)) << words << " in " << r.err;
  EXPECT_EQ(lines_of(r.err).size(), 1u) << r.err;
  EXPECT_EQ(Json::parse(read_text(folder / "manifest.json")).at("state"), "failed");
  expect_whole_run(folder.path());
}

TEST(Run, HasTheSameBitsOnOneAndThreeThreads) {
  const TemporaryFolder folder;
  freshet(good_run(folder / "one", {"--threads", "1"}));
  freshet(good_run(folder / "three", {"--threads", "3"}));
  EXPECT_EQ(report_of(folder / "one").at("state_sha256"),
            report_of(folder / "three").at("state_sha256"));
}

TEST(Run, NamesItsFolderAfterTheScene) {
  const TemporaryFolder folder;
  fs::copy_file(article, folder / "pond.toml");
  const auto r = freshet({"run", "pond.toml", "--quiet", "--set", "time.end=0.01", "--set",
                          "checks.height_mean_max=3"},
                         {.directory = folder.path()});
  EXPECT_EQ(r.code, 0) << r.err;
  expect_whole_run(folder / "runs/pond");
}

TEST(Video, NeedsFfmpeg) {
  const TemporaryFolder folder;
  const auto r = freshet(good_run(folder / "run", {"--video", (folder / "water.mp4").string()}),
                         {.environment = {"PATH=/nowhere"}});
  EXPECT_EQ(r.code, 2);
  EXPECT_TRUE(contains(r.err, "ffmpeg")) << r.err;
  EXPECT_TRUE(contains(r.err, "apt-get install ffmpeg")) << r.err;
  EXPECT_FALSE(fs::exists(folder / "water.mp4"));
  const auto after = freshet(good_run(folder / "run"));  // the rejected run left nothing behind
  EXPECT_EQ(after.code, 0) << after.err;
}

TEST(Video, RejectsAnUnknownSuffix) {
  const TemporaryFolder folder;
  const auto r = freshet(good_run(folder / "run", {"--video", (folder / "water.avi").string()}));
  EXPECT_EQ(r.code, 2);
  EXPECT_TRUE(contains(r.err, ".mp4, .gif or .webp")) << r.err;
  EXPECT_FALSE(fs::exists(folder / "run/manifest.json"));
}

TEST(Video, RejectsAMissingFolderAndTooManyPictures) {
  const TemporaryFolder folder;
  const auto rejected = [&](const std::vector<std::string>& more) {
    const auto r = freshet(good_run(folder / "run", more));
    EXPECT_EQ(r.code, 2) << r.err;
    EXPECT_FALSE(fs::exists(folder / "run/manifest.json"));
    return r.err;
  };
  EXPECT_TRUE(contains(rejected({"--video", (folder / "no/a.gif").string()}),
                       "the folder of this file does not exist"));
  EXPECT_TRUE(contains(
      rejected({"--video", (folder / "a.webp").string(), "--fps", "1e6", "--speed", "1e-3"}),
      "at most 100000 are allowed"));
}

// Built without giflib or libwebp, the message names the package instead.
TEST(Video, GifAndWebpNeedNoFfmpeg) {
  const TemporaryFolder folder;
  for (const std::string kind : {"gif", "webp"}) {
    const fs::path film = folder / ("water." + kind);
    const auto r = freshet(good_run(folder / kind, {"--video", film.string()}),
                           {.environment = {"PATH=/nowhere"}});
    if (r.code == 2) {
      EXPECT_TRUE(contains(r.err, kind == "gif" ? "libgif-dev" : "libwebp-dev")) << r.err;
      EXPECT_FALSE(fs::exists(folder / kind / "manifest.json"));
      continue;
    }
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string bytes = read_text(film);
    EXPECT_EQ(kind == "gif" ? bytes.substr(0, 6) : bytes.substr(8, 4),
              kind == "gif" ? "GIF89a" : "WEBP");
    expect_whole_run(folder / kind);
  }
}

TEST(Video, SlowMotionHasMorePictures) {
  const TemporaryFolder folder;
  const auto pictures = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> all{"--video", (folder / (name + ".gif")).string(), "--fps", "50"};
    all.insert(all.end(), more.begin(), more.end());
    const auto r = freshet(good_run(folder / name, all));
    EXPECT_EQ(r.code, 0) << r.err;
    return files_below(folder / name / "video").size();
  };
  if (run_process({"ffmpeg", "-version"}).code != 0 &&
      freshet(good_run(folder / "try", {"--video", (folder / "try.gif").string()})).code == 2)
    GTEST_SKIP() << "neither giflib nor ffmpeg is installed";
  const std::size_t usual = pictures("usual", {});
  EXPECT_NEAR(4.0 * double(usual - 1), double(pictures("slow", {"--speed", "0.25"}) - 1), 3);
}

TEST(Video, IsWrittenAndNotReplaced) {
  if (run_process({"ffmpeg", "-version"}).code != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  for (const std::string kind : {"mp4", "gif"}) {
    const fs::path film = folder / ("water." + kind);
    const auto r = freshet(good_run(folder / kind, {"--video", film.string(), "--fps", "100"}));
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string bytes = read_text(film);
    EXPECT_GT(bytes.size(), 1000u);
    EXPECT_EQ(kind == "gif" ? bytes.substr(0, 4) : bytes.substr(4, 4),
              kind == "gif" ? "GIF8" : "ftyp");
    EXPECT_FALSE(fs::exists(film.string() + ".part"));
    expect_whole_run(folder / kind);

    const auto again = freshet(good_run(folder / "other", {"--video", film.string()}));
    EXPECT_EQ(again.code, 2);
    EXPECT_TRUE(contains(again.err, "exists")) << again.err;
    EXPECT_EQ(read_text(film), bytes);
  }
}

TEST(Run, CallsAWallProbeThatStaysDryDry) {
  const TemporaryFolder folder;
  write_text(
      folder / "tank.toml",
      "domain.max = [1, 1]\nparticles.spacing = 0.1\nfluid = { min = [0, 0], max = [1, 0.4] }\n"
      "solver = { name = \"wcsph\", sound_speed = 20 }\nwalls.method = \"akinci2012\"\n"
      "time = { end = 0.002, step = 1e-3 }\npicture.width = 40\n"
      "[[probe]]\nname = \"high\"\nkind = \"wall\"\nfrom = [1, 0.8]\nto = [1, 0.9]\n");
  const auto r =
      freshet({"run", (folder / "tank.toml").string(), "--output", (folder / "run").string()});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "peak at high          dry\n")) << r.out;
}

TEST(Run, NamesParticlesThatStartOnItsWalls) {
  const TemporaryFolder folder;
  const auto r = freshet(
      {"run", article, "--solver", "dfsph", "--quiet", "--output", (folder / "run").string()});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err,
                       "particles started outside the domain, and fluid.outside = \"clamp\" "
                       "put them onto its walls"))
      << r.err;
}

}  // namespace
}  // namespace freshet::test

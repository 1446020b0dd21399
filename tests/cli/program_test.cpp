// SPDX-License-Identifier: MIT
/// The program apart from runs: help, lists, messages about wrong arguments, benchmarks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

using testing::Test;
using testing::TestWithParam;

/// Expects exit code 2, nothing on stdout and one line on stderr; returns the line.
std::string usage_error(const std::vector<std::string>& arguments) {
  const auto r = freshet(arguments);
  EXPECT_EQ(r.code, 2) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(lines_of(r.err).size(), 1u) << r.err;
  EXPECT_TRUE(contains(r.err, "error: ")) << r.err;
  return r.err;
}

class Help : public TestWithParam<const char*> {};

TEST_P(Help, HasAnExample) {
  const std::string command = GetParam();
  const auto r = command.empty() ? freshet({"--help"}) : freshet({command, "--help"});
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.err, "");
  EXPECT_TRUE(contains(r.out, "Example")) << r.out;
  EXPECT_TRUE(contains(r.out, "\n  freshet " + command) || contains(r.out, "<(freshet " + command))
      << r.out;
}

INSTANTIATE_TEST_SUITE_P(Commands, Help,
                         testing::Values("", "run", "new", "check", "info", "scenes", "bench",
                                         "plot", "schema", "completion", "complete", "manual"));

TEST(Program, PrintsItsVersion) {
  const auto r = freshet({"--version"});
  EXPECT_EQ(r.code, 0);
  EXPECT_TRUE(r.out.starts_with("freshet ")) << r.out;
  EXPECT_EQ(lines_of(r.out).size(), 1u);
}

TEST(Program, RejectsWrongArguments) {
  EXPECT_TRUE(contains(usage_error({}), "--help"));
  EXPECT_TRUE(contains(usage_error({"frobnicate"}), "frobnicate"));
  EXPECT_TRUE(contains(usage_error({"--frobnicate"}), "--frobnicate"));
  EXPECT_TRUE(contains(usage_error({"run"}), "SCENE"));
  EXPECT_TRUE(contains(usage_error({"run", article, "--frobnicate"}), "--frobnicate"));
  EXPECT_TRUE(contains(usage_error({"run", article, "--log", "xml"}), "--log"));
  EXPECT_TRUE(contains(usage_error({"run", article, "--threads", "0"}), "--threads"));
  EXPECT_TRUE(contains(usage_error({"run", article, "--threads", "many"}), "--threads"));
  EXPECT_TRUE(contains(usage_error({"completion", "tcsh"}), "tcsh"));
  EXPECT_TRUE(contains(usage_error({"bench", article, "--compare", ""}), "an empty value"));
  EXPECT_TRUE(contains(usage_error({"measure", "no_run", "--probes", ""}), "an empty value"));
  // 2^63, which CLI11 replaces by 2^63 - 1
  const std::string huge = "9223372036854775808";
  EXPECT_TRUE(contains(usage_error({"surface", "no_run", "--every", huge}), huge));
  EXPECT_TRUE(contains(usage_error({"surface", "no_run", "--to", huge}), huge));
}

TEST(Program, ViewIgnoresNoChange) {
  const TemporaryFolder run;
  const std::string folder = run.path().string();
  EXPECT_TRUE(contains(usage_error({"view", folder, "--set", "time.end=1"}),
                       "--set, --unset: error: these change a scene, not a finished run"));
  EXPECT_TRUE(contains(usage_error({"view", folder, "--solver", "dfsph"}), "not a finished run"));
  EXPECT_TRUE(contains(usage_error({"view", "--replay", "log.toml", "--set", "time.end=1"}),
                       "not a log of actions"));
  EXPECT_TRUE(contains(usage_error({"view", article, "--replay", "log.toml"}), "--replay"));
}

TEST(Program, ListsBundledScenes) {
  const auto r = freshet({"scenes"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "article")) << r.out;
  const auto names = freshet({"scenes", "--names"});
  EXPECT_TRUE(contains("\n" + names.out, "\narticle\n")) << names.out;
}

TEST(Program, FindsBundledScenesAndRejectsOthers) {
  EXPECT_EQ(freshet({"check", "article"}).code, 0);
  const std::string unknown = usage_error({"check", "artcle"});
  EXPECT_TRUE(contains(unknown, "artcle: error: ")) << unknown;
  EXPECT_TRUE(contains(unknown, "article")) << unknown;
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(usage_error({"check", folder.path().string()}), "folder"));
  EXPECT_TRUE(contains(usage_error({"check", "/dev/null"}), "not a regular file but a device"));
}

TEST(Program, CheckAcceptsTheArticle) {
  const auto r = freshet({"check", article});
  EXPECT_EQ(r.code, 0);
  EXPECT_TRUE(contains(r.out, "valid, with 4 warnings")) << r.out;
  for (const std::string& line : lines_of(r.err))
    EXPECT_TRUE(line.starts_with(article + ":") && contains(line, ": warning: ")) << line;
}

TEST(Program, InfoPrintsEveryRow) {
  const auto r = freshet({"info", article, "--set", "time.end=0.05"});
  EXPECT_EQ(r.code, 0) << r.err;
  for (const char* row :
       {"particles", "spacing", "support radius", "neighbours expected", "lattice errors", "mass",
        "speed of sound", "time step", "steps", "run time", "memory", "disk"})
    EXPECT_TRUE(contains(r.out, std::string("\n  ") + row + " ")) << row << " in\n" << r.out;
  EXPECT_TRUE(contains(r.out, "600 fluid, 154 of them outside")) << r.out;
  EXPECT_TRUE(contains(r.out, "50 for 0.05 s")) << r.out;
}

TEST(Program, InfoEstimatesTheSizeOfDataFiles) {
  const auto disk = [](const std::string& data) {
    const auto r = freshet({"info", article, "--set", "time.end=0.05", "--set", data});
    EXPECT_EQ(r.code, 0) << r.err;
    return r.out.substr(std::min(r.out.find("\n  disk "), r.out.size()));
  };
  EXPECT_TRUE(contains(disk("output.data=['ply']"), "; about 43.9 kB for the data of 2"))
      << disk("output.data=['ply']");
  EXPECT_FALSE(contains(disk("output.data=[]"), "data of"));
}

TEST(Overrides, ErrorsNameTheirKey) {
  const auto error = [](const std::string& pair) {
    return usage_error({"check", article, "--set", pair});
  };
  const std::pair<const char*, const char*> cases[] = {{"time.ende=1", "did you mean time.end?"},
                                                       {"time.end=-1", "> 0"},
                                                       {"time.end=soon", "the string \"soon\""},
                                                       {"time.end=", "the string \"\""},
                                                       {"time.end=1\ntime.step=2", "the string"},
                                                       {"time.=1", "not a key"},
                                                       {"=1", "not a key"},
                                                       {"fluid[=1", "not a key"},
                                                       {"fluid[].viscosity=1", "not a key"},
                                                       {"fluid[7].viscosity=1", "no fluid[7]"},
                                                       {"domain.max.x=1", "not a table"},
                                                       {"domain=1", "[domain]"},
                                                       {"title=\xff", "UTF-8"},
                                                       {"solver.search=Grid", "\"all_pairs\""}};
  for (const auto& [pair, words] : cases) {
    const std::string key = std::string(pair).substr(0, std::string(pair).find('='));
    const std::string line = error(pair);
    EXPECT_TRUE(line.starts_with("--set " + key + ": error: ")) << line;
    EXPECT_TRUE(contains(line, words)) << line;
  }
  EXPECT_TRUE(error("time.end").starts_with("--set time.end: error: write KEY=VALUE"));
}

TEST(Overrides, ValuesThatAreNotTomlAreStrings) {
  EXPECT_EQ(freshet({"check", article, "--set", "title=Water, falling"}).code, 0);
  EXPECT_EQ(freshet({"check", article, "--set", "solver.search=all_pairs"}).code, 0);
  EXPECT_EQ(freshet({"check", article, "--set", "fluid[0].velocity=[1, 0]"}).code, 0);
}

TEST(Completion, IsParsedByItsShell) {
  const TemporaryFolder folder;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const auto r = freshet({"completion", shell});
    EXPECT_EQ(r.code, 0);
    EXPECT_TRUE(contains(r.out, "freshet")) << shell;
    EXPECT_TRUE(contains(r.out, "freshet complete -- ")) << shell;
    const std::string script = (folder / shell).string();
    write_text(script, r.out);
    const auto parsed = run_process({shell, "-n", script});
    if (parsed.code != 127) {  // 127: the shell is not installed
      EXPECT_EQ(parsed.code, 0) << parsed.err;
    }
  }
}

TEST(Completion, OffersCommandsOptionsAndScenes) {
  const TemporaryFolder folder;
  write_text(folder / "bash", freshet({"completion", "bash"}).out);
  const std::string script = "source " + (folder / "bash").string() +
                             "; freshet() { " FRESHET_PROGRAM
                             " \"$@\"; }; COMP_WORDS=(freshet "
                             "\"$1\" \"$2\"); COMP_CWORD=$3; _freshet; echo \"${COMPREPLY[@]}\"";
  const auto offers = [&](const char* a, const char* b, const char* at) {
    return run_process({"bash", "-c", script, "bash", a, b, at}, {.directory = folder.path()}).out;
  };
  EXPECT_EQ(offers("inf", "", "1"), "info\n");
  EXPECT_TRUE(contains(offers("run", "artic", "2"), "article"));
  EXPECT_EQ(offers("bench", "--comp", "2"), "--compare\n");
  EXPECT_EQ(offers("plot", "--agai", "2"), "--against\n");
  EXPECT_EQ(offers("plot", "artic", "2"), "\n");  // offers folders only, and there is none
}

Json bench(std::vector<std::string> more) {
  std::vector<std::string> all{"bench", article, "--steps", "20", "--repeats", "1", "--json"};
  all.insert(all.end(), more.begin(), more.end());
  const auto r = freshet(all);
  EXPECT_EQ(r.code, 0) << r.err;
  return Json::parse(r.out, nullptr, false);
}

void expect_measurement(const Json& run) {
  for (const char* key : {"seconds", "particle_steps_per_second", "all_particle_steps_per_second",
                          "bytes_per_particle"})
    EXPECT_TRUE(run.value(key, Json()).is_number()) << key << " in " << run;
  EXPECT_EQ(run.at("fluid_particles"), 600);
  EXPECT_EQ(run.at("wall_particles"), 0);
  EXPECT_EQ(run.at("steps"), 20);
  EXPECT_GT(run.at("seconds"), 0);
  EXPECT_FALSE(run.at("verbs").empty());
  for (const Json& ns : run.at("verbs")) EXPECT_GT(ns, 0);
}

TEST(Bench, MeasuresAScene) {
  const Json json = bench({});
  ASSERT_TRUE(json.is_object());
  expect_measurement(json);
  EXPECT_FALSE(json.at("ceilings").empty());
}

TEST(Bench, ComparesValuesOfAKey) {
  const Json json = bench({"--compare", "solver.search=grid,all_pairs"});
  ASSERT_TRUE(json.is_object());
  const Json& runs = json.at("runs");
  ASSERT_EQ(runs.size(), 2u);
  for (const Json& run : runs) expect_measurement(run);
  EXPECT_EQ(runs[0].at("value"), "grid");
  EXPECT_EQ(runs[1].at("value"), "all_pairs");
  EXPECT_EQ(runs[0].at("state_sha256"), runs[1].at("state_sha256"));
}

TEST(Bench, PrintsAMarkdownTable) {
  const auto r = freshet({"bench", article, "--steps", "20", "--repeats", "1", "--compare",
                          "solver.search=grid,all_pairs", "--markdown"});
  EXPECT_EQ(r.code, 0) << r.err;
  const auto lines = lines_of(r.out);
  ASSERT_EQ(lines.size(), 4u) << r.out;
  EXPECT_TRUE(lines[0].starts_with("| `solver.search` | time step [ms] | iterations a step |"));
  EXPECT_EQ(lines[1], "|---|---|---|---|---|---|---|---|");
  EXPECT_TRUE(lines[2].starts_with("| `grid` | 1 |  | ")) << lines[2];  // steps of 1 ms
  EXPECT_TRUE(lines[3].starts_with("| `all_pairs` | 1 |  | ")) << lines[3];
  for (const std::string& line : lines)
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 9) << line;
}

TEST(Bench, RunsAdaptiveStepsToTheEnd) {
  const std::string scene = (source_dir / "tests/scenes/good/plain.toml").string();
  const auto r =
      freshet({"bench", scene, "--repeats", "1", "--json", "--set", "solver.name=wcsph", "--set",
               "time.step=adaptive", "--set", "time.step_max=0.01", "--set", "time.end=0.02"});
  ASSERT_EQ(r.code, 0) << r.err;
  const Json json = Json::parse(r.out);
  EXPECT_GE(json.at("time"), 0.02 * (1 - 1e-12));
  EXPECT_GT(json.at("steps"), 20) << "steps of step_max would be two";
  EXPECT_FALSE(json.contains("iterations")) << "wcsph does not iterate";
}

TEST(Bench, ReportsIterationsAndSolveErrors) {
  const std::string scene = (source_dir / "tests/scenes/good/plain.toml").string();
  const std::vector<std::string> compare{
      "bench", scene, "--steps", "5", "--repeats", "1", "--compare", "solver.name=wcsph,dfsph"};
  auto with = [&](const char* flag) {
    auto all = compare;
    all.push_back(flag);
    const auto r = freshet(all);
    EXPECT_EQ(r.code, 0) << r.err;
    return r.out;
  };
  const Json runs = Json::parse(with("--json")).at("runs"), &dfsph = runs.at(1);
  EXPECT_FALSE(runs.at(0).contains("iterations"));
  const double iterations = dfsph.at("iterations");
  EXPECT_DOUBLE_EQ(iterations, dfsph.at("divergence_iterations").get<double>() +
                                   dfsph.at("density_iterations").get<double>());
  EXPECT_NEAR(dfsph.at("particle_iterations_per_second").get<double>(),
              iterations * dfsph.at("particle_steps_per_second").get<double>(), 1);
  EXPECT_GT(dfsph.at("solve_particle_iterations_per_second"),
            dfsph.at("particle_iterations_per_second"));
  for (const char* key : {"density_error", "divergence_error", "density_error_worst", "retried"})
    EXPECT_TRUE(dfsph.at(key).is_number()) << key;
  const auto lines = lines_of(with("--markdown"));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(contains(lines[2], "| `wcsph` | 0.1 |  | ")) << lines[2];
  EXPECT_TRUE(lines[3].starts_with(fmt::format("| `dfsph` | 0.1 | {:.3g} | ", iterations)))
      << lines[3];
}

TEST(Bench, RejectsWrongComparisons) {
  EXPECT_TRUE(contains(usage_error({"bench", article, "--compare", "grid"}), "KEY=A,B"));
  EXPECT_TRUE(contains(usage_error({"bench", article, "--compare", "=a,b"}), "KEY=A,B"));
  EXPECT_TRUE(contains(usage_error({"bench", article, "--compare", "solver.search=grid,fast"}),
                       "--set solver.search: error: "));
  for (const char* wrong : {"0", "-5", "nan", "-nan", "inf", "many"})
    EXPECT_TRUE(contains(usage_error({"bench", article, "--particles", wrong}), "--particles"))
        << wrong;
  EXPECT_TRUE(contains(usage_error({"bench", article, "--markdown"}), "--compare"));
  EXPECT_TRUE(contains(usage_error({"bench", article, "--compare", "solver.search=grid,all_pairs",
                                    "--markdown", "--json"}),
                       "--json"));
}

}  // namespace
}  // namespace freshet::test

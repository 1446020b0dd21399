// SPDX-License-Identifier: MIT
/// The completions of shells, the manual page, and hints to the help.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

/// The candidates for the last word, without their descriptions.
std::set<std::string> candidates(const std::vector<std::string>& words,
                                 const fs::path& directory = ".") {
  std::vector<std::string> all{"complete", "--"};
  all.insert(all.end(), words.begin(), words.end());
  const auto r = freshet(all, {.directory = directory});
  EXPECT_EQ(r.code, 0) << r.err;
  std::set<std::string> found;
  for (const std::string& line : lines_of(r.out)) found.insert(line.substr(0, line.find('\t')));
  return found;
}

using Set = std::set<std::string>;

TEST(Completion, OffersWhatAnArgumentCanBe) {
  EXPECT_EQ(candidates({"ru"}), (Set{"run"}));
  EXPECT_EQ(candidates({"run", "art"}), (Set{"article", "article_corrected", "<files>"}));
  EXPECT_EQ(candidates({"run", "article", "--solver", "d"}), (Set{"delta_sph", "dfsph"}));
  EXPECT_EQ(candidates({"run", "article", "--solver=d"}),
            (Set{"--solver=delta_sph", "--solver=dfsph"}));
  EXPECT_EQ(candidates({"run", "article", "--isa", "avx"}), (Set{"avx2", "avx512"}));
  EXPECT_EQ(candidates({"run", "article", "--set", "time.st"}),
            (Set{"time.step=", "time.step_max="}));
  EXPECT_EQ(candidates({"bench", "article", "--unset", "fluid.vi"}), (Set{"fluid.viscosity"}));
  EXPECT_EQ(candidates({"run", "article", "--un"}), (Set{"--unset"}));
  EXPECT_EQ(candidates({"run", "article", "--output", ""}), (Set{"<files>"}));
  EXPECT_EQ(candidates({"completion", ""}), (Set{"bash", "fish", "zsh"}));
  EXPECT_TRUE(candidates({"validate", "dam_break"}).contains("dam_break_front"));
  EXPECT_TRUE(candidates({""}).contains("--version"));
  EXPECT_TRUE(candidates({"run", "article", ""}).contains("--overwrite"));
  EXPECT_EQ(candidates({"no_command", ""}), Set{});
}

// bash splits words at "=".
TEST(Completion, KnowsTheEqualsSignsOfBash) {
  EXPECT_EQ(candidates({"run", "article", "--solver", "=", "df"}), (Set{"dfsph"}));
  EXPECT_EQ(candidates({"run", "article", "--solver", "="}),
            candidates({"run", "article", "--solver", ""}));
  EXPECT_EQ(candidates({"run", "article", "--set", "time.end", "="}), Set{});
  EXPECT_EQ(candidates({"run", "article", "--set", "time.end", "=", "2"}), Set{});
  EXPECT_EQ(candidates({"run", "article", "--set", "time.end", "=", "2", "--qu"}),
            (Set{"--quiet"}));
}

TEST(Completion, OffersRuns) {
  const TemporaryFolder folder;
  for (const char* run : {"runs/a", "runs/bench/b", "runs/a/inner"})
    write_text(folder / run / "manifest.json", "");
  fs::create_directories(folder / "runs/empty");
  EXPECT_EQ(candidates({"resume", "runs/"}, folder.path()),
            (Set{"runs/a", "runs/bench/b", "<files>"}));
}

TEST(Completion, WorksInBash) {
  const TemporaryFolder folder;
  write_text(folder / "complete.sh", freshet({"completion", "bash"}).out + R"(
freshet() { ")" FRESHET_PROGRAM R"(" "$@"; }
COMP_WORDS=(freshet run article --set time.st); COMP_CWORD=4
_freshet 2>/dev/null
printf '%s\n' "${COMPREPLY[@]}"
COMP_WORDS=(freshet ch); COMP_CWORD=1
_freshet 2>/dev/null
printf '%s\n' "${COMPREPLY[@]}"
)");
  const auto r = run_process({"bash", (folder / "complete.sh").string()});
  EXPECT_EQ(r.out, "time.step=\ntime.step_max=\ncheck\n") << r.err;
}

TEST(Manual, HasEveryCommandAndOption) {
  const auto r = freshet({"manual"});
  EXPECT_EQ(r.code, 0);
  EXPECT_TRUE(r.out.starts_with(".TH FRESHET 1 ")) << r.out;
  for (const std::string& command : candidates({""})) {
    if (command.starts_with('-')) continue;
    EXPECT_TRUE(contains(r.out, "\n.SS freshet " + command + " ")) << command;
  }
  for (const char* words : {"\\fB\\-\\-unset\\fR \\fIKEY\\fR", "\\fISCENE\\fR", "EXIT STATUS"})
    EXPECT_TRUE(contains(r.out, words)) << words;
}

TEST(CommandLine, ErrorsPointToTheHelpOfTheCommand) {
  const auto error = [](const std::vector<std::string>& arguments) {
    const auto r = freshet(arguments);
    EXPECT_EQ(r.code, 2);
    return r.err;
  };
  EXPECT_TRUE(contains(error({"run"}), "; see freshet run --help"));
  EXPECT_TRUE(contains(error({"bench", article, "--steps", "0"}), "; see freshet bench --help"));
  EXPECT_EQ(error({"run", article, "--outptu", "x"}),
            "error: no option --outptu; did you mean --output?; see freshet run --help\n");
  EXPECT_TRUE(contains(error({"run", article, "again"}), "one argument too many: again"));
  EXPECT_TRUE(contains(error({"rnu"}), "no command rnu; did you mean run?"));
  EXPECT_TRUE(contains(error({"check", "artcle"}), "did you mean article?"));
  EXPECT_TRUE(contains(error({"validate", "dam_break_frnt"}), "did you mean dam_break_front?"));
}

TEST(CommandLine, InterruptedRunsNameTheCommandThatResumesThem) {
  const TemporaryFolder folder;
  const std::string output = (folder / "my run").string();
  const auto r = freshet(long_run(output), {.signal = SIGINT, .signal_after = "particles"});
  EXPECT_EQ(r.code, 130) << r.err;
  EXPECT_TRUE(contains(r.out, "\nto resume: " FRESHET_PROGRAM " resume '" + output + "'\n"))
      << r.out;
}

TEST(CommandLine, WarningsAreJsonInAJsonLog) {
  const TemporaryFolder folder;
  const auto r = freshet({"run", "article_corrected", "--solver", "dfsph", "--set",
                          "particles.support_radius=0.05", "--set", "time.end=0.002", "--unset",
                          "checks", "--output", folder.path(), "--log", "json"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  std::size_t dropped = 0, others = 0;
  for (const std::string& line : lines_of(r.out)) {
    const Json event = Json::parse(line);
    if (event.at("event") != "warning" || event.at("kind") != "scene") continue;
    EXPECT_TRUE(event.at("place").is_string());
    ++(event.at("message").get<std::string>().starts_with("dropped: ") ? dropped : others);
  }
  EXPECT_EQ(dropped, 2u);
  EXPECT_GT(others, 0u);
}

}  // namespace
}  // namespace freshet::test

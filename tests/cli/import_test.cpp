// SPDX-License-Identifier: MIT
/// Scenes of other programs on the command line.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "cli/process.h"
#include "import/dualsphysics_cases.h"
#include "import/import_scenes.h"

namespace freshet::test {
namespace {

TEST(ImportCommand, WritesASceneAndSaysWhatItTakesInstead) {
  const ImportFolder folder(dam_with(R"("simulationMethod": 4)", R"("simulationMethod": 5)"));
  const std::string file = folder.file().string(), out = (folder / "new/dam.toml").string();
  const auto r = freshet({"import", "splishsplash", file, "-o", out});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.out, "wrote " + out + "\n");
  EXPECT_TRUE(contains(r.err, file + ":2:46: note: Configuration.simulationMethod: projective "
                                     "fluids have no counterpart; taken instead: dfsph\n"))
      << r.err;
  EXPECT_EQ(freshet({"check", out}).code, 0);
  const auto again = freshet({"import", "splishsplash", file, "--output", out});
  EXPECT_EQ(again.code, 2);
  EXPECT_EQ(again.err, out + ": error: exists already; choose another --output\n");
}

TEST(ImportCommand, AJsonSceneRunsToTheBitsOfItsConversion) {
  const ImportFolder folder;
  const std::string json = folder.file().string(), toml = (folder / "dam.toml").string();
  EXPECT_EQ(freshet({"import", "splishsplash", json, "-o", toml}).code, 0);
  std::vector<std::string> digests;
  for (const std::string& scene : {json, toml}) {
    const fs::path output = folder / (scene == json ? "a" : "b");
    const auto r = freshet({"run", scene, "--output", output.string(), "--quiet", "--threads", "1",
                            "--set", "time.end=0.02"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    digests.push_back(Json::parse(read_text(output / "report.json"))["state_sha256"]);
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_EQ(freshet({"resume", (folder / "a").string(), "--quiet", "--set", "time.end=0.03"}).code,
            0);
}

TEST(ImportCommand, CheckTakesAJsonScene) {
  const ImportFolder folder;
  const std::string json = folder.file().string();
  const auto good = freshet({"check", json});
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_TRUE(contains(good.out, ": a good scene")) << good.out;
  const auto bad = freshet({"check", json, "--set", "fluid[0].viscosity=-1"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_TRUE(contains(bad.err, "--set fluid[0].viscosity: error: ")) << bad.err;
  const auto other = freshet({"check", json, "--solver", "pbf"});
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(contains(other.err, "--solver pbf: error: changes scenes in TOML only")) << other.err;
}

TEST(ImportCommand, EventsOfARunHaveTheNotes) {
  const ImportFolder folder(dam_with(R"("simulationMethod": 4)", R"("simulationMethod": 5)"));
  const auto r = freshet({"run", folder.file().string(), "--output", (folder / "run").string(),
                          "--log", "json", "--set", "time.end=0.005"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, R"({"event":"note","place":")")) << r.out;
  EXPECT_TRUE(contains(r.out, R"("key":"Configuration.simulationMethod")")) << r.out;
}

TEST(ImportCommand, TakesCasesOfDualSPHysics) {
  const CaseFolder folder;
  const std::string xml = folder.file().string(), toml = (folder / "dam.toml").string();
  const auto r = freshet({"import", "dualsphysics", xml, "-o", toml});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.out, "wrote " + toml + "\n");
  EXPECT_EQ(freshet({"check", xml}).code, 0);
  EXPECT_EQ(freshet({"info", xml}).code, 0);
  std::vector<std::string> digests;
  for (const std::string& scene : {xml, toml}) {
    const fs::path output = folder / (scene == xml ? "a" : "b");
    const auto run =
        freshet({"run", scene, "--output", output.string(), "--quiet", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.err;
    digests.push_back(Json::parse(read_text(output / "report.json"))["state_sha256"]);
  }
  EXPECT_EQ(digests[0], digests[1]);
}

}  // namespace
}  // namespace freshet::test

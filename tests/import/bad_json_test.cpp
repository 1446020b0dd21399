// SPDX-License-Identifier: MIT
/// Scenes of SPlisHSPlasH that are wrong, and what the import says.
#include <gtest/gtest.h>

#include "import/import_scenes.h"

namespace freshet::test {
namespace {

struct BadJson {
  std::string json, message;
};

/// A configuration with one entry, which begins in column 20.
std::string config(const std::string& entry) { return R"({"Configuration": {)" + entry + "}}"; }
std::string block(const std::string& entries) { return R"({"FluidBlocks": [{)" + entries + "}]}"; }
std::string body(const std::string& entries) { return R"({"RigidBodies": [{)" + entries + "}]}"; }

const BadJson bad_json[] = {
#include "import/bad_json_cases.inc"
};

TEST(BadJsonScenes, AreRefusedWithPlaceCauseAndRemedy) {
  EXPECT_GE(std::size(bad_json), 30u);
  for (const BadJson& bad : bad_json)
    EXPECT_EQ(bad.message, ImportFolder(bad.json).refused()) << bad.json;
}

TEST(BadJsonScenes, AllErrorsComeAtOnce) {
  const std::string what =
      ImportFolder(config(R"("particleRadius": -1, "kernel": 9, "gravitation": 3)")).refused();
  EXPECT_EQ(2, std::count(what.begin(), what.end(), '\n')) << what;
}

TEST(BadJsonScenes, EveryBeginningOfASceneIsRefused) {
  for (std::size_t n = 0; n + 1 < dam_json.size(); n += 7)
    EXPECT_NE("", ImportFolder(dam_json.substr(0, n)).refused()) << n;
}

TEST(BadJsonScenes, DamagedScenesEitherConvertOrAreRefused) {
  const std::string bytes = "{}[]\",:0-e.\\ \x01\xff";
  std::size_t refused = 0;
  for (std::size_t n = 0; n < 1000; ++n) {
    std::string json = dam_json;
    json[(n * 7919) % json.size()] = bytes[n % bytes.size()];
    refused += !ImportFolder(json).refused().empty();
  }
  EXPECT_GT(refused, 500u);
}

}  // namespace
}  // namespace freshet::test

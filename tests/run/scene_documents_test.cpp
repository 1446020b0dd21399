// SPDX-License-Identifier: MIT
// The documents in the repository are those that the table of keys generates.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "freshet/scene.h"
#include "freshet/scene_documents.h"
#include "freshet/suggest.h"
#include "mesh/triangle_mesh.h"
#include "scene/model/body_shape.h"
#include "scene/model/expressions.h"

namespace freshet {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST(SceneDocuments, ReferenceIsUpToDate) {
  EXPECT_EQ(text_of(SOURCE_DIR "/docs/scene.md"), scene_reference())
      << "run freshet schema --markdown > docs/scene.md";
}

TEST(SceneDocuments, SchemaIsUpToDate) {
  EXPECT_EQ(text_of(SOURCE_DIR "/docs/scene.schema.json"), scene_schema())
      << "run freshet schema > docs/scene.schema.json";
}

TEST(SceneDocuments, SchemaHasRangesRequiredKeysAndNames) {
  const auto schema = nlohmann::json::parse(scene_schema());
  const auto& particles = schema["properties"]["particles"];
  EXPECT_EQ(0, particles["properties"]["spacing"]["exclusiveMinimum"]);
  EXPECT_EQ("spacing", particles["required"][0]);
  EXPECT_EQ(false, particles["additionalProperties"]);
  EXPECT_EQ(nlohmann::json({"paper", "article"}),
            schema["properties"]["solver"]["properties"]["scheme"]["enum"]);
}

/// Meshes need Assimp, free bodies Bullet, functions of place and time muParser.
bool this_build_takes(const std::string& scene) {
  const auto has = [&](const char* words) { return scene.find(words) != std::string::npos; };
  return (reads_meshes() || !has("shape = \"mesh\"")) &&
         (moves_free_bodies() || !has("motion = \"free\"")) &&
         (reads_expressions() || !(has("\nbody_force = [") || has("position = [\"")));
}

TEST(SceneDocuments, BundledScenesAreValid) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    if (!this_build_takes(text_of(entry.path()))) continue;
    const Scene scene = load_scene(entry.path());
    EXPECT_FALSE(scene.title.empty()) << entry.path();
    EXPECT_EQ('#', scene.source[0]) << entry.path() << " must begin with a comment";
  }
}

TEST(Suggest, FindsTheNearestWordOrNone) {
  EXPECT_EQ("spacing", nearest("spaceing", {"spacing", "seed", "mass"}));
  EXPECT_EQ("stiffness", nearest("stifness", {"stiffness", "scheme"}));
  EXPECT_EQ("end", nearest("edn", {"end", "step"}));
  EXPECT_EQ("", nearest("volume", {"spacing", "seed", "mass"}));
  EXPECT_EQ("rest_density", nearest("density", {"rest_density", "viscosity"}));
  EXPECT_EQ("", nearest("density", {"rest_density", "density_diffusion"}));
  EXPECT_EQ("", nearest("dens", {"rest_density", "viscosity"}));
}

}  // namespace
}  // namespace freshet

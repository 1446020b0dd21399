// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "import/import_scenes.h"

namespace freshet::test {
namespace {

void expect_vector(const Vector& expected, const Vector& actual) {
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(expected[k], actual[k], 1e-8) << k;
}

/// The messages of the notes about a key.
std::vector<std::string> notes_of(const ImportedScene& scene, const std::string& key) {
  std::vector<std::string> all;
  for (const ImportNote& note : scene.notes)
    if (note.key == key) all.push_back(note.message);
  return all;
}

TEST(SplishSplash, DamBreakHasItsTankItsParticlesAndItsMethod) {
  const ImportFolder folder;
  const Scene s = folder.scene();
  expect_vector({-0.5, 0, -0.25}, s.domain.min);
  expect_vector({0.5, 1, 0.25}, s.domain.max);
  EXPECT_DOUBLE_EQ(0.05, s.particles.spacing);
  EXPECT_DOUBLE_EQ(0.1, *s.particles.support_radius);
  ASSERT_EQ(1u, s.fluid.size());
  EXPECT_EQ(Shape::lattice, s.fluid[0].shape);
  expect_vector({-0.45, 0.05, -0.2}, s.fluid[0].from);
  EXPECT_EQ((Counts{9, 9, 9}), s.fluid[0].count);
  EXPECT_DOUBLE_EQ(900, s.fluid[0].rest_density);
  EXPECT_DOUBLE_EQ(9, s.fluid[0].viscosity);  // 0.01 m²/s times the density
  EXPECT_EQ("dfsph", std::string(s.method().name));
  EXPECT_DOUBLE_EQ(1e-4, *s.solver.density_tolerance);
  EXPECT_TRUE(s.wall.empty());
  EXPECT_EQ(Slip::free_slip, s.walls.slip);
  EXPECT_TRUE(s.time.adaptive);
  EXPECT_DOUBLE_EQ(0.005, *s.time.step_max);
  EXPECT_DOUBLE_EQ(0.05, s.time.end);
}

TEST(SplishSplash, EmptySceneHasDefaults) {
  const ImportFolder folder("{}");
  const ImportedScene scene = folder.import();
  EXPECT_TRUE(contains(scene.toml, "spacing = 0.05\n")) << scene.toml;
  EXPECT_TRUE(contains(scene.toml, "name = \"dfsph\"")) << scene.toml;
  EXPECT_TRUE(scene.notes.empty());
}

TEST(SplishSplash, EveryKeyIsReadOrListed) {
  const ImportFolder folder(dam_with(
      R"("stopAt": 0.05,)", R"("stopAt": 0.05, "imteStepSize": 1, "pause": true, "colour": 3,)"));
  const ImportedScene scene = folder.import();
  EXPECT_EQ((std::vector<std::string>{"unknown; has no effect; did you mean timeStepSize?"}),
            notes_of(scene, "Configuration.imteStepSize"));
  EXPECT_EQ(1u, notes_of(scene, "Configuration.pause").size());
  EXPECT_EQ((std::vector<std::string>{"unknown; has no effect"}),
            notes_of(scene, "Configuration.colour"));
  const auto note = std::find_if(scene.notes.begin(), scene.notes.end(), [](const ImportNote& n) {
    return n.key == "Configuration.imteStepSize";
  });
  EXPECT_EQ(folder.file().string() +
                ":2:85: note: Configuration.imteStepSize: unknown; has no "
                "effect; did you mean timeStepSize?",
            note->text());
  EXPECT_TRUE(contains(scene.toml, "# Configuration.colour: unknown; has no effect\n"));
  EXPECT_TRUE(contains(scene.toml, "# Only for its window and its files: Configuration.pause\n"));
}

TEST(SplishSplash, SetTwiceIsListed) {
  const ImportFolder folder(dam_with(R"("density0": 900,)", R"("density0": 1, "density0": 900,)"));
  EXPECT_EQ((std::vector<std::string>{"set twice; the last value is taken"}),
            notes_of(folder.import(), "Materials[0].density0"));
  EXPECT_DOUBLE_EQ(900, folder.scene().fluid[0].rest_density);
}

TEST(SplishSplash, MethodsBecomeSolvers) {
  const char* expected[] = {"wcsph", "pcisph", "pbf", "iisph", "dfsph", "dfsph", "iisph"};
  for (int k = 0; k < 7; ++k) {
    const ImportFolder folder(
        dam_with(R"("simulationMethod": 4)", fmt::format(R"("simulationMethod": {})", k)));
    EXPECT_EQ(expected[k], std::string(folder.scene().method().name)) << k;
    EXPECT_EQ(k > 4 ? 1u : 0u, notes_of(folder.import(), "Configuration.simulationMethod").size());
  }
}

TEST(SplishSplash, StiffnessBecomesTheSpeedOfSound) {
  const ImportFolder folder(dam_with(R"("simulationMethod": 4)",
                                     R"("simulationMethod": 0, "WCSPH": {"stiffness": 50000})"));
  EXPECT_NEAR(std::sqrt(350000 / 900.0), *folder.scene().solver.sound_speed, 1e-6);
  EXPECT_TRUE(notes_of(folder.import(), "Configuration.WCSPH.stiffness").empty());
}

TEST(SplishSplash, SoundThatIsSlowerThanTheFlowIsNotTaken) {
  const ImportFolder folder(dam_with(R"("simulationMethod": 4)",
                                     R"("simulationMethod": 0, "WCSPH": {"stiffness": 2000})"));
  EXPECT_FALSE(folder.scene().solver.sound_speed);  // 3.9 m/s; a fall through the tank: 4.4 m/s
  EXPECT_EQ(1u, notes_of(folder.import(), "Configuration.WCSPH.stiffness").size());
}

/// The dam break with another body.
std::string with_body(const std::string& body) {
  return dam_with(R"("mapInvert": true})", R"("mapInvert": true}, )" + body);
}

TEST(SplishSplash, SimpleMeshesBecomeShapes) {
  const ImportFolder folder(with_body(
      R"({"geometryFile": "prism.ply", "translation": [0.3, 0.4, 0], "scale": [0.1, 0.2, 0.1],
          "isDynamic": true, "density": 300, "id": 7},
         {"geometryFile": "box.ply", "translation": [0.2, 0, 0], "scale": [0.2, 0.3, 0.1],
          "rotationAxis": [0, 1, 0], "rotationAngle": 0.5}, 
         {"geometryFile": "cone.ply", "translation": [0.3, 0, 0], "scale": [0.1, 0.1, 0.1]})"));
  const Scene s = folder.scene();
  ASSERT_EQ(1u, s.body.size());
  EXPECT_EQ("body_7", s.body[0].name);
  EXPECT_EQ(Shape::cylinder, s.body[0].shape);
  EXPECT_EQ(BodyMotion::free, s.body[0].motion);
  EXPECT_DOUBLE_EQ(300, *s.body[0].density);
  EXPECT_NEAR(0.1, s.body[0].radius, 1e-6);
  EXPECT_NEAR(0.4, s.body[0].length, 1e-6);
  ASSERT_EQ(2u, s.wall.size());
  EXPECT_EQ(Shape::box, s.wall[0].shape);
  expect_vector({0.1, -0.15, -0.05}, s.wall[0].min);
  EXPECT_NEAR(0.5 * 180 / std::numbers::pi, s.wall[0].rotation[1], 1e-6);
  EXPECT_EQ(Shape::mesh, s.wall[1].shape);
  EXPECT_DOUBLE_EQ(0.1, s.wall[1].scale);
}

TEST(SplishSplash, RotationsAreTheSameAboutThreeAxes) {
  // The direction of the prism's axis, about which it is round.
  const ImportFolder folder(with_body(
      R"({"geometryFile": "prism.ply", "scale": [0.1, 0.2, 0.1], "translation": [0.2, 0.5, 0],
          "rotationAxis": [1, 1, 1], "rotationAngle": 2.0943951023931953})"));
  expect_vector({0, 0, 1}, folder.scene().wall[0].axis);  // a third of a turn: y becomes z
}

TEST(SplishSplash, InTwoDimensionsAMeshIsCut) {
  std::string json = with_body(
      R"({"geometryFile": "cone.ply", "scale": [0.2, 0.2, 0.2], "translation": [0.25, 0.5, 0]})");
  json.insert(json.find("\"particleRadius\""), "\"sim2D\": true, ");
  const ImportFolder folder(json);
  const Scene s = folder.scene();
  EXPECT_EQ(2, s.dimension());
  EXPECT_EQ((Counts{9, 9}), s.fluid[0].count);
  ASSERT_EQ(1u, s.wall.size());
  EXPECT_EQ(Shape::polygon, s.wall[0].shape);
  double low = 1e9, high = -1e9;
  for (const Vector& p : s.wall[0].points) {
    low = std::min(low, p[0]);
    high = std::max(high, p[0]);
  }
  EXPECT_NEAR(0.05, low, 0.01);
  EXPECT_NEAR(0.45, high, 0.01);
}

TEST(SplishSplash, WithoutATankTheSidesAreOpen) {
  std::string json = dam_with(R"([0, 0.5, 0])", R"([0, -0.5, 0])");
  json.replace(json.find(R"("isWall": true, "mapInvert": true)"), 33, R"("isWall": false)");
  const ImportFolder open(json);
  const Scene s = open.scene();
  EXPECT_EQ(WallMethod::open, *s.walls.method);
  EXPECT_EQ(1u, s.wall.size());
  EXPECT_LE(s.domain.min[1], -1);
}

TEST(SplishSplash, EmittersBecomeInlets) {
  std::string json = dam_json;
  json.insert(json.rfind('}'), R"(, "Emitters": [
    {"type": 1, "width": 6, "velocity": 2, "translation": [-0.5, 0.8, 0], "emitStartTime": 0.01},
    {"type": 0, "width": 4, "height": 3, "velocity": 1, "translation": [0.2, 0.8, 0],
     "rotationAxis": [0, 0, 1], "rotationAngle": -1.5707963267948966}])");
  const ImportFolder folder(json);
  const Scene s = folder.scene();
  ASSERT_EQ(2u, s.inlet.size());
  EXPECT_NEAR(0.15, *s.inlet[0].radius, 1e-9);
  EXPECT_DOUBLE_EQ(2, *s.inlet[0].speed);
  EXPECT_DOUBLE_EQ(0.01, s.inlet[0].start);
  EXPECT_GT(s.inlet[0].center[0], -0.5 + 0.15);  // moved into the tank
  EXPECT_EQ(1u, notes_of(folder.import(), "Emitters[0].translation").size());
  EXPECT_NEAR(0.2, *s.inlet[1].width, 1e-9);
  EXPECT_NEAR(0.15, *s.inlet[1].height, 1e-9);
  expect_vector({0, -1, 0}, s.inlet[1].direction);
  EXPECT_DOUBLE_EQ(900, *s.inlet[0].rest_density);
}

TEST(SplishSplash, AnEmitterEndsWithItsParticles) {
  std::string json =
      dam_with(R"("density0": 900)", R"("density0": 900, "maxEmitterParticles": 24)");
  json.insert(json.rfind('}'), R"(, "Emitters": [
    {"width": 4, "height": 3, "velocity": 10, "translation": [0, 0.8, 0]}])");
  const ImportFolder folder(json);
  EXPECT_NEAR(2 * 0.05 / 10, *folder.scene().inlet[0].stop, 1e-9);
  EXPECT_EQ(1u, notes_of(folder.import(), "Emitters[0]").size());
}

TEST(SplishSplash, ModelsOfPointsAreScaledRotatedAndTranslated) {
  std::string json = dam_json;
  json.insert(json.rfind('}'), R"(, "FluidModels": [
    {"particleFile": "points.csv", "scale": [2, 2, 2], "translation": [0.2, 0.5, 0],
     "rotationAxis": [0, 0, 1], "rotationAngle": 1.5707963267948966, "initialVelocity": [0, 1, 0]}])");
  const ImportFolder folder(json);
  write_text(folder / "points.csv", "x,y,z\n0,0,0\n0.05,0,0\n0.1,0,0\n");
  const Scene s = folder.scene();
  ASSERT_EQ(2u, s.fluid.size());
  EXPECT_EQ(Shape::points, s.fluid[1].shape);
  EXPECT_DOUBLE_EQ(2, s.fluid[1].scale);
  expect_vector({0, 0, 90}, s.fluid[1].rotation);
  expect_vector({0.2, 0.5, 0}, s.fluid[1].translation);
  expect_vector({0, 1, 0}, s.fluid[1].velocity);
}

TEST(SplishSplash, PointsAloneHaveTheMassThatTheyWereSampledFor) {
  std::string json = dam_json;
  const auto blocks = json.find(",\n  \"FluidBlocks\"");
  json.replace(blocks, json.rfind('}') - blocks, R"(, "FluidModels": [{"particleFile": "p.csv"}])");
  const ImportFolder folder(json);
  write_text(folder / "p.csv", "x,y,z\n0,0.3,0\n0.05,0.3,0\n0.1,0.3,0\n");
  const Scene s = folder.scene();
  EXPECT_NEAR(0.8 * std::pow(0.05, 3), std::pow(s.particles.spacing, 3), 1e-9);
  EXPECT_DOUBLE_EQ(0.1, *s.particles.support_radius);
  EXPECT_EQ(1u, notes_of(folder.import(), "Configuration.particleRadius").size());
}

TEST(SplishSplash, SeveralFluidsHaveTheirDensities) {
  std::string json = dam_with(R"("Materials": [)",
                              R"("Materials": [{"id": "oil", "density0": 700, "viscosityMethod": 6,
                        "Weiler et al. 2018": {"viscosity": 2, "viscosityBoundary": 2}}, )");
  json.insert(json.rfind(']'),
              R"(, {"id": "oil", "start": [0, 0, -0.25], "end": [0.5, 0.5, 0.25]})");
  const Scene s = ImportFolder(json).scene();
  ASSERT_EQ(2u, s.liquids().size());
  EXPECT_DOUBLE_EQ(700, s.fluid[1].rest_density);
  EXPECT_DOUBLE_EQ(1400, s.fluid[1].viscosity);
  EXPECT_EQ(ViscosityMethod::weiler2018, s.viscosity_method());
  EXPECT_EQ(Slip::no_slip, s.walls.slip);
  EXPECT_EQ(ColorBy::liquid, s.picture.color_by);
}

TEST(SplishSplash, AMotorTurnsItsBody) {
  std::string json = with_body(
      R"({"id": 1, "geometryFile": "box.ply", "scale": [0.3, 0.1, 0.1], "isDynamic": true,
          "translation": [0.3, 0.3, 0]})");
  json.insert(json.find("\"geometryFile\""), "\"id\": 0, ");
  const std::string motor =
      R"(, "TargetVelocityMotorHingeJoints": [{"bodyID1": 1, "bodyID2": 0,
         "position": [0.3, 0.3, 0], "axis": [0, 1, 0], )";
  std::string steady = json, sequence = json;
  steady.insert(steady.rfind('}'), motor + R"("target": -6}])");
  const Scene s = ImportFolder(steady).scene();
  ASSERT_EQ(1u, s.body.size());
  EXPECT_EQ(BodyMotion::moved, s.body[0].motion);
  EXPECT_EQ(0u, s.body[0].angle.find("343.77"));  // the target is that of the second body
  sequence.insert(sequence.rfind('}'),
                  motor + R"("targetSequence": [0, -2, 1, 4], "repeatSequence": 1}])");
  const Scene t = ImportFolder(sequence).scene();
  ASSERT_GT(t.body[0].key.size(), 10u);
  const Scene::Body::Key& end = t.body[0].key[20];
  EXPECT_NEAR(1, end.time, 1e-9);
  EXPECT_NEAR(-180 / std::numbers::pi, end.angle, 1e-6);  // the mean speed is -1 rad/s
}

TEST(SplishSplash, FieldsAndElasticityAreListed) {
  std::string json = dam_with(R"("density0": 900)", R"("density0": 900, "elasticityMethod": 3)");
  json.insert(json.rfind('}'), R"(, "AnimationFields": [{"particleField": "velocity"}])");
  const ImportedScene scene = ImportFolder(json).import();
  EXPECT_EQ(1u, notes_of(scene, "Materials[0].elasticityMethod").size());
  EXPECT_EQ(1u, notes_of(scene, "AnimationFields[0].particleField").size());
}

TEST(SplishSplash, FilesAreRelativeToTheNewScene) {
  const ImportFolder folder(with_body(R"({"geometryFile": "cone.ply"})"));
  const ImportedScene scene = import_splishsplash(folder.file(), folder.path() / "deep/er");
  EXPECT_TRUE(contains(scene.toml, "file = \"../../cone.ply\"")) << scene.toml;
}

}  // namespace
}  // namespace freshet::test

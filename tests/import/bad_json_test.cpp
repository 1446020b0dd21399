// SPDX-License-Identifier: MIT
/// Scenes of SPlisHSPlasH that are wrong, and what the import says.
#include <gtest/gtest.h>

#include <algorithm>

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
    {"",
     "scene.json:1:1: error: this file is not JSON: while parsing value - unexpected end of input; "
     "expected '[', '{', or a literal; the file ends too early; close its braces and brackets"},
    {"[1, 2]",
     "scene.json: error: the scene is not an object; a scene of SPlisHSPlasH begins with a brace: "
     "{\"Configuration\": {...}}"},
    {"{\"Configuration\": {}",
     "scene.json:1:21: error: this file is not JSON: while parsing object - unexpected end of "
     "input; expected '}'; the file ends too early; close its braces and brackets"},
    {R"({"Configuration": {},})",
     "scene.json:1:22: error: this file is not JSON: while parsing object key - unexpected '}'; "
     "expected string literal; remove the comma before the brace"},
    {R"({"Configuration" {}})",
     "scene.json:1:18: error: this file is not JSON: while parsing object separator - unexpected "
     "'{'; expected ':'; write \"KEY\": VALUE"},
    {R"({Configuration: {}})",
     "scene.json:1:2: error: this file is not JSON: while parsing object key - invalid literal; "
     "last read: '{C'; expected string literal; write keys in quotes: \"key\""},
    {R"({"Configuration": {} "Materials": []})",
     "scene.json:1:32: error: this file is not JSON: while parsing object - unexpected string "
     "literal; expected '}'; write a comma between two keys"},
    {R"({"FluidBlocks": [1,]})",
     "scene.json:1:20: error: this file is not JSON: while parsing value - unexpected ']'; "
     "expected '[', '{', or a literal; remove the comma before the bracket"},
    {R"({"FluidBlocks": [1 2]})",
     "scene.json:1:20: error: this file is not JSON: while parsing array - unexpected number "
     "literal; expected ']'; write a comma between two values"},
    {R"({"Configuration": {}} x)",
     "scene.json:1:23: error: this file is not JSON: while parsing value - invalid literal; last "
     "read: '\"Configuration\": {}} x'; expected end of input; remove what follows the last brace"},
    {R"({"a": True})",
     "scene.json:1:7: error: this file is not JSON: while parsing value - invalid literal; last "
     "read: '\"a\": T'; words need quotes, and true and false small letters; JSON has no comments"},
    {R"({"a": 01})",
     "scene.json:1:8: error: this file is not JSON: while parsing object - unexpected number "
     "literal; expected '}'; write a comma between two keys"},
    {R"({"a": "b)",
     "scene.json:1:9: error: this file is not JSON: while parsing value - invalid string: missing "
     "closing quote; last read: '\"b'; close the quotes on the same line"},
    {"{\"a\": \"\\m\"}",
     "scene.json:1:9: error: this file is not JSON: while parsing value - invalid string: "
     "forbidden character after backslash; last read: '\"\\m'; write \\\\ for a backslash, or / in "
     "paths"},
    {"// a scene\n{}",
     "scene.json:1:1: error: this file is not JSON: while parsing value - invalid literal; last "
     "read: '/'; words need quotes, and true and false small letters; JSON has no comments"},
    {"{\"a\": \"\xff\"}",
     "scene.json:1:8: error: this file is not JSON: while parsing value - invalid string: "
     "ill-formed UTF-8 byte; last read: '\"?'; save the file as UTF-8"},
    {R"({"a": 1e999})",
     "scene.json: error: a number is too large for JSON; write numbers below 1e308"},
    {std::string(70, '[') + std::string(70, ']'),
     "scene.json: error: lists and objects are nested more than 64 deep; a scene of SPlisHSPlasH "
     "needs 5"},
    {R"({"Configuration": 3})",
     "scene.json:1:2: error: Configuration is 3; it must be an object in braces {}"},
    {R"({"Materials": {}})",
     "scene.json:1:2: error: Materials is {}; it must be a list in brackets []"},
    {R"({"FluidBlocks": [3]})",
     "scene.json:1:18: error: FluidBlocks[0] is 3; it must be an object in braces {}"},
    {config(R"("particleRadius": 0)"),
     "scene.json:1:20: error: Configuration.particleRadius is 0; it must be a number > 0"},
    {config(R"("particleRadius": "big")"),
     "scene.json:1:20: error: Configuration.particleRadius is \"big\"; it must be a number > 0"},
    {config(R"("simulationMethod": 7)"),
     "scene.json:1:20: error: Configuration.simulationMethod is 7; it must be 0 (WCSPH), 1 "
     "(PCISPH), 2 (PBF), 3 (IISPH), 4 (DFSPH), 5 (Projective Fluids) or 6 (ICSPH)"},
    {config(R"("sim2D": "yes")"),
     "scene.json:1:20: error: Configuration.sim2D is \"yes\"; it must be true or false"},
    {config(R"("gravitation": [0, -9.81])"),
     "scene.json:1:20: error: Configuration.gravitation is [0,-9.81]; it must be three numbers, "
     "such as [0, 1, 0]"},
    {config(R"("cflMethod": 1.5)"),
     "scene.json:1:20: error: Configuration.cflMethod is 1.5; it must be 0 (fixed steps), 1 (CFL) "
     "or 2 (CFL and the number of iterations)"},
    {config(R"("WCSPH": {"stiffness": -1}, "simulationMethod": 0)"),
     "scene.json:1:30: error: Configuration.WCSPH.stiffness is -1; it must be a number ≥ 0"},
    {config(R"("DFSPH": {"maxError": 0})"),
     "scene.json:1:30: error: Configuration.DFSPH.maxError is 0; it must be a number > 0"},
    {block(R"("start": [0, 0, 0])"),
     "scene.json:1:19: error: FluidBlocks[0].start and end are needed; set both corners of the "
     "block"},
    {block(R"("start": [0, 0, 0], "end": [1, 1, 1], "id": 3)"),
     "scene.json:1:57: error: FluidBlocks[0].id is 3; it must be a string in quotes"},
    {body(R"("geometryFile": "none.obj")"),
     "scene.json:1:19: error: RigidBodies[0].geometryFile is \"none.obj\": no such mesh file; "
     "check the path"},
    {body(R"("geometryFile": "cone.ply", "scale": [1, 2, 1])"),
     "scene.json:1:47: error: RigidBodies[0].scale must be three equal numbers > 0 for this mesh; "
     "apply the scale to the file, for example in Blender"},
    {body(R"("geometryFile": "scene.json")"),
     "scene.json:1:19: error: RigidBodies[0].geometryFile is \"scene.json\": not a known format of "
     "meshes (*.stl, *.obj or *.ply); export it as one of them"},
    {body(R"("geometryFile": "box.ply", "isDynamic": true, "density": -5)"),
     "scene.json:1:65: error: RigidBodies[0].density is -5; it must be a number > 0"},
    {R"({"FluidModels": [{"scale": [1, 1, 1]}]})",
     "scene.json:1:18: error: FluidModels[0].particleFile is missing; name a file of points or a "
     "mesh"},
    {R"({"FluidModels": [{"particleFile": "none.bgeo"}]})",
     "scene.json:1:19: error: FluidModels[0].particleFile is \"none.bgeo\": no such point file; "
     "check the path"},
    {R"({"Emitters": [{"width": 0}]})",
     "scene.json:1:16: error: Emitters[0].width is 0; it must be an integer from 1 to 100000"},
    {R"({"Emitters": [{"velocity": 0}]})",
     "scene.json:1:16: error: Emitters[0].velocity is 0; it must be a number > 0"},
    {R"({"Emitters": [{"type": 2}]})",
     "scene.json:1:16: error: Emitters[0].type is 2; it must be 0 (box) or 1 (circle)"},
    {R"({"TargetVelocityMotorHingeJoints": [{"bodyID1": 1, "bodyID2": 0}]})",
     "scene.json:1:38: error: TargetVelocityMotorHingeJoints[0].bodyID1 is 1, and no body has this "
     "id; set RigidBodies[k].id\nscene.json:1:52: error: TargetVelocityMotorHingeJoints[0].bodyID2 "
     "is 0, and no body has this id; set RigidBodies[k].id"},
    {R"({"FluidBlocks": [{"start": [0, 0, 0], "end": [1, 1, 1]}], "Materials": [{"id": "Fluid", "density0": -1}]})",
     "scene.json:1:89: error: Materials[0].density0 is -1; it must be a number > 0"},
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

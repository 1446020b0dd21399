// SPDX-License-Identifier: MIT
/// The comparison of scenes that decides whether a checkpoint belongs to a scene.
#include "scene/keys/same_steps.h"

#include <gtest/gtest.h>

#include "freshet/error.h"

namespace freshet::test {
namespace {

std::string difference(const std::string& a, const std::string& b) {
  const std::string key = differing_key(a, "a.toml", b, "b.toml");
  EXPECT_EQ(key, differing_key(b, "b.toml", a, "a.toml"));
  return key;
}

TEST(DifferingKey, IsEmptyForScenesWithTheSameSteps) {
  EXPECT_EQ("", difference("[time]\nend = 1\nstep = 0.5\n", "time.step = 5e-1\ntime.end = 2.5\n"));
  EXPECT_EQ("", difference("fluid.viscosity = 1", "# as run\n[fluid]\nviscosity = 1.0\n"));
  EXPECT_EQ("", difference("", "title = \"a\"\n[output]\nframe_every = 3\n[walls]\n"));
  EXPECT_EQ("", difference("[surface]\n", "[surface]\ncell = 0.3\n"));
  EXPECT_EQ("", difference("", "[[camera]]\nx = 1\n[[camera]]\nx = 2\n[checks]\nspeed_max = 1\n"));
  EXPECT_EQ("", difference("fluid.file = \"a.csv\"\nsolver.backend = \"cpu\"\n",
                           "fluid.file = \"inputs/fluid_0_a.csv\"\n"));
  EXPECT_EQ("", difference("[[body]]\npath = \"a\"\n", "[[body]]\npath = \"b\"\n"));
}

TEST(DifferingKey, NamesTheKeyThatChangesSteps) {
  EXPECT_EQ("time.step", difference("time.step = 1", "time.step = 2"));
  EXPECT_EQ("fluid.viscosity", difference("fluid.viscosity = 1", "fluid.viscosity = 2"));
  EXPECT_EQ("fluid[1].viscosity", difference("[[fluid]]\n[[fluid]]\nviscosity = 1\n",
                                             "[[fluid]]\n[[fluid]]\nviscosity = 2\n"));
  EXPECT_EQ("wall", difference("[[wall]]\n", "[[wall]]\n[[wall]]\n"));
  EXPECT_EQ("body", difference("", "[[body]]\nname = \"b\"\n"));
  EXPECT_EQ("domain.max", difference("domain.max = [1, 2]", "domain.max = [1, 3]"));
  EXPECT_EQ("domain.max", difference("domain.max = [1, 2]", "domain.max = [1, 2, 3]"));
  EXPECT_EQ("solver.name", difference("solver.name = \"pbf\"", "solver.name = \"iisph\""));
  EXPECT_EQ("solver.name", difference("solver.name = \"pbf\"", "solver.name = 1"));
  EXPECT_EQ("walls.sampled", difference("walls.sampled = true", "walls.sampled = false"));
}

TEST(DifferingKey, RejectsTextThatIsNotToml) {
  for (const bool first : {true, false}) try {
      differing_key(first ? "[" : "a = 1", "a.toml", first ? "a = 1" : "[", "b.toml");
      ADD_FAILURE() << "no error";
    } catch (const Error& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with(first ? "a.toml:1:" : "b.toml:1:")) << e.what();
    }
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
/// Files of key frames, as other programs write them.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/error.h"
#include "scene/model/body_motion.h"

namespace freshet::test {
namespace {

class PathFile : public ::testing::Test {
 protected:
  std::vector<Scene::Body::Key> read(const std::string& text, int dimension = 2) {
    write_text(folder_ / "path.csv", text);
    return read_body_path(folder_ / "path.csv", dimension);
  }
  std::string error_of(const std::string& text, int dimension = 2) {
    try {
      read(text, dimension);
      return "read without an error";
    } catch (const Error& e) {
      return std::string(e.what()).substr(folder_.path().string().size() + 1);
    }
  }
  TemporaryFolder folder_;
};

TEST_F(PathFile, MayHaveOtherSeparatorsCapitalsUnitsAndComments) {
  for (const char* text : {"time,x,y\n0,0,0\n1,0.5,2\n",
                           "\xEF\xBB\xBF"
                           "Time;X;Y\r\n0;0;0\r\n1;0,5;2\r\n",
                           "t\tx\ty\n0\t0\t0\n1\t0.5\t2\n",
                           "# by a script\n\"time [s]\", \"x [m]\", \"y (m)\"\n0,0,0\n1,0.5,2\n",
                           "# time x y\n0 0 0\n1 0.5 2\n", "0,0,0\n1,0.5,2\n"}) {
    const auto keys = read(text);
    ASSERT_EQ(2u, keys.size()) << text;
    EXPECT_EQ(1, keys[1].time) << text;
    EXPECT_EQ((Vector{0.5, 2}), keys[1].translation) << text;
    EXPECT_EQ(0, keys[1].angle) << text;
  }
}

TEST_F(PathFile, WithoutNamesMayEndWithTheAngle) {
  EXPECT_EQ(30, read("0,0,0,0\n1,0.5,2,30\n")[1].angle);
  const auto keys = read("0,0,0,0\n1,0.5,2,30\n", 3);
  EXPECT_EQ((Vector{0.5, 2, 30}), keys[1].translation);
  EXPECT_EQ(0, keys[1].angle);
}

TEST_F(PathFile, OfOtherColumnsNeedsNames) {
  EXPECT_EQ(
      "path.csv:1: error: the first line has 2 numbers and no names; name the columns there, such "
      "as time,x,angle",
      error_of("0,0\n1,0.5\n"));
  EXPECT_EQ(
      "path.csv:1: error: the name of column 2 is unknown; the first line may name time, x, y and "
      "angle, as in \"time,x,y\"; remove the column or rename it",
      error_of("time,height\n0,0\n1,0.5\n"));
  EXPECT_EQ(
      "path.csv:3: error: the value in column 2 is not a finite number; write numbers like 0.5 or "
      "1e-3",
      error_of("time,x\n0,0\n1,half\n"));
}

}  // namespace
}  // namespace freshet::test

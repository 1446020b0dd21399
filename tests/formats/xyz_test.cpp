// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "formats/point_bytes.h"

namespace freshet::test {
namespace {

const std::vector<double> xyz_x{1, 2, 3, 4, 5, 6};

TEST(Xyz, ReadsElementsAndCoordinates) {
  for (const char* text : {"2\n\nAr 1 2 3\nAr 4 5 6\n", "2\na comment\n1 2 3\n4 5 6\n\n",
                           " 2 \r\n\r\nH\t1.0 +2 3e0\r\nO 4 5 6"}) {
    const PointCloud cloud = points_in(text, "a.xyz", 3);
    EXPECT_EQ(xyz_x, cloud.x) << text;
    EXPECT_TRUE(cloud.v.empty() && cloud.unused.empty()) << text;
  }
  EXPECT_EQ((std::vector<double>{1, 2}), points_in("1\n\nAr 1 2 0\n", "a.xyz", 2).x);
}

TEST(Xyz, NamesColumnsThatAreNotUsed) {
  const PointCloud cloud = points_in("1\n\nAr 1 2 3 0.5 text 7\n", "a.xyz", 3);
  EXPECT_EQ((std::vector<std::string>{"column 5", "column 6", "column 7"}), cloud.unused);
}

/// As OVITO and ASE write it.
TEST(Xyz, ReadsThePropertiesOfExtendedXyz) {
  const PointCloud cloud = points_in(
      "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=id:I:1:species:S:1:pos:R:3:velo:R:3:force:R:3 "
      "Time=0.5\n1 Ar 1 2 3 7 8 9 0 0 nan\n2 Ar 4 5 6 10 11 12 0 0 0\n",
      "a.xyz", 3);
  EXPECT_EQ(xyz_x, cloud.x);
  EXPECT_EQ((std::vector<double>{7, 8, 9, 10, 11, 12}), cloud.v);
  EXPECT_EQ((std::vector<std::string>{"species", "force", "id"}), cloud.unused);
}

TEST(Xyz, ReadsBareColumns) {
  EXPECT_EQ(xyz_x, points_in("1 2 3\n4 5 6\n", "a.xyz", 3).x);
  const PointCloud normals = points_in("# by MeshLab\n1 2 3 0 0 1\n4 5 6 0 0 1\n", "a.xyz", 3);
  EXPECT_EQ(xyz_x, normals.x);
  EXPECT_TRUE(normals.v.empty());
  EXPECT_EQ((std::vector<std::string>{"column 4", "column 5", "column 6"}), normals.unused);
  const PointCloud named = points_in("x y z vx vy vz\n1 2 3 7 8 9\n", "a.xyz", 3);
  EXPECT_EQ((std::vector<double>{7, 8, 9}), named.v);
}

TEST(Xyz, DamagedFilesGivePointsOrErrors) {
  const std::string text =
      "2\nProperties=species:S:1:pos:R:3:vel:R:3\nAr 1 2 3 4 5 6\nAr 1 2 3 4 5 6\n";
  damage(text, "a.xyz", text.size() - 2, 27);
}

TEST(Xyz, ReportsLineAndRemedy) {
  const auto error = [](const std::string& text) { return read_error(text, "a.xyz"); };
  EXPECT_EQ("a.xyz:3: error: line 1 announces 3 points, and the file has 1; it is cut off",
            error("3\n\nAr 1 2 3\n"));
  EXPECT_EQ(
      "a.xyz:2: error: line 1 announces 18446744073709551615 points, and the file has 0; it is cut "
      "off",
      error("18446744073709551615\n\nAr 1 2 3\n"));
  EXPECT_EQ("a.xyz:4: error: more lines than the 1 points of line 1; save a single frame",
            error("1\n\nAr 1 2 3\n1\n\nAr 1 2 3\n"));
  EXPECT_EQ("a.xyz:4: error: value 3 is not a number; write numbers like 0.5 or 1e-3",
            error("2\n\nAr 1 2 3\nAr 1 two 3\n"));
  EXPECT_EQ("a.xyz:4: error: 3 values instead of 4; write one per column",
            error("2\n\nAr 1 2 3\nAr 1 2\n"));
  EXPECT_EQ("a.xyz:3: error: a point has fewer than 3 coordinates; write an element and x, y, z",
            error("1\n\nAr 1 2\n"));
  EXPECT_EQ(
      "a.xyz:3: error: 4 unnamed columns of numbers; write Properties=species:S:1:pos:R:3 or other "
      "columns into line 2, or save it as *.csv",
      error("1\n\n18 1 2 3\n"));
  EXPECT_EQ(
      "a.xyz:2: error: Properties= is not a list of NAME:TYPE:COUNT of at most 1024 columns; save "
      "the file again",
      error("1\nProperties=pos:R\nAr 1 2 3\n"));
  EXPECT_TRUE(
      error("1\nProperties=a:R:1024:b:R:1\nAr 1 2 3\n").starts_with("a.xyz:2: error: Properties="));
  EXPECT_EQ(
      "a.xyz:4: error: a number is nan; positions and velocities must be finite, at most 1e15",
      error("2\n\nAr 1 2 3\nAr 1 nan 3\n"));
  EXPECT_EQ("a.xyz: error: the file has no points; name another file", error("0\n\n"));
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "cli/files.h"
#include "freshet/error.h"
#include "scene/sample/point_cloud.h"
#include "scene/sample/point_spacing.h"

namespace freshet::test {
namespace {

class PointFile : public ::testing::Test {
 protected:
  PointCloud read(const std::string& name, const std::string& text, int dimension = 3) {
    write_text(folder_ / name, text);
    return read_points(folder_ / name, dimension);
  }
  /// The error message of reading this text, without the folder.
  std::string refused(const std::string& name, const std::string& text, int dimension = 3) {
    try {
      read(name, text, dimension);
      return "read without an error";
    } catch (const Error& e) {
      const std::string what = e.what(), folder = folder_.path().string() + "/";
      return what.starts_with(folder) ? what.substr(folder.size()) : what;
    }
  }
  TemporaryFolder folder_;
};

template <class T> std::string bytes_of(T value, bool big) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big) std::reverse(bytes, bytes + sizeof value);
  return {bytes, sizeof value};
}

const std::string head =
    "element vertex 2\nproperty float x\nproperty double y\nproperty uchar red\n"
    "property float z\nproperty float vx\nproperty float vy\nproperty float vz\n"
    "element face 0\nproperty list uchar int vertex_indices\nend_header\n";

TEST_F(PointFile, ReadsAsciiPly) {
  const PointCloud cloud = read("a.ply", "ply\nformat ascii 1.0\ncomment made by hand\n" + head +
                                             "1 2 255 3 4 5 6\n1.5e0 +2 0 3 0 0 -1\n");
  EXPECT_EQ((std::vector<double>{1, 2, 3, 1.5, 2, 3}), cloud.x);
  EXPECT_EQ((std::vector<double>{4, 5, 6, 0, 0, -1}), cloud.v);
}

TEST_F(PointFile, ReadsBinaryPlyOfEitherByteOrder) {
  for (const bool big : {false, true}) {
    std::string text =
        std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + head;
    for (const float k : {0.0f, 10.0f})
      text += bytes_of(k + 1, big) + bytes_of(double(k) + 2, big) + "\xFF" + bytes_of(k + 3, big) +
              bytes_of(k + 4, big) + bytes_of(k + 5, big) + bytes_of(k + 6, big);
    const PointCloud cloud = read("b.ply", text);
    EXPECT_EQ((std::vector<double>{1, 2, 3, 11, 12, 13}), cloud.x);
    EXPECT_EQ((std::vector<double>{4, 5, 6, 14, 15, 16}), cloud.v);
    EXPECT_NE(std::string::npos, refused("c.ply", text.substr(0, text.size() - 1)).find("cut off"));
  }
}

TEST_F(PointFile, ReadsCsv) {
  const PointCloud cloud =
      read("a.csv", "\xEF\xBB\xBFvy, vx ,label,y,x\r\n4,3,drop,2,1\r\n\r\n8, 7,,6,5e0\r\n", 2);
  EXPECT_EQ((std::vector<double>{1, 2, 5, 6}), cloud.x);
  EXPECT_EQ((std::vector<double>{3, 4, 7, 8}), cloud.v);
  EXPECT_TRUE(read("b.csv", "x,y,z\n1,2,0\n", 2).v.empty());
}

TEST_F(PointFile, ReadsCsvOfParaView) {
  const PointCloud cloud = read("a.csv",
                                "\"velocity:0\",\"velocity:1\",\"velocity:2\",\"label\","
                                "\"Points:0\",\"Points:1\",\"Points_2\"\n"
                                "1,2,3,\"a, b\",4,5,6\n");
  EXPECT_EQ((std::vector<double>{4, 5, 6}), cloud.x);
  EXPECT_EQ((std::vector<double>{1, 2, 3}), cloud.v);
  EXPECT_EQ("b.csv:1: error: x is named twice; name every column once",
            refused("b.csv", "x,Points:0\n"));
  EXPECT_EQ(
      "c.csv:1: error: x is missing; a 2D scene needs x, y and optionally vx, vy; columns found: "
      "\"Points:3\", \"y\"",
      refused("c.csv", "Points:3,Points:1\n", 2));
}

// A mesh as Blender 3.4 exports it: normals and faces are ignored.
TEST_F(PointFile, ReadsPlyOfBlender) {
  const PointCloud cloud =
      read("a.ply",
           "ply\nformat ascii 1.0\ncomment Created by Blender 3.4.1 - www.blender.org\n"
           "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\n"
           "element face 1\nproperty list uchar uint vertex_indices\nend_header\n"
           "0.5 0 0 0 0 1\n0 0.5 0 0 0 1\n-0.5 0 0 0 0 1\n3 0 1 2\n");
  EXPECT_EQ((std::vector<double>{0.5, 0, 0, 0, 0.5, 0, -0.5, 0, 0}), cloud.x);
  EXPECT_TRUE(cloud.v.empty());
}

TEST_F(PointFile, ReportsPlaceAndRemedy) {
  EXPECT_EQ(
      "a.csv:3: error: value 2 is not a number; write numbers like 0.5 or 1e-3, with one "
      "separator between them",
      refused("a.csv", "x,y\n1,2\n1,two\n", 2));
  EXPECT_EQ("a.csv:2: error: 3 values instead of 2; write one per column",
            refused("a.csv", "x,y\n1,2,3\n", 2));
  EXPECT_EQ(
      "a.csv:1: error: z is missing; a 3D scene needs x, y, z and optionally vx, vy, vz; columns "
      "found: \"x\", \"y\"",
      refused("a.csv", "x,y\n1,2\n"));
  EXPECT_EQ(
      "a.csv:1: error: vy is missing, and another velocity is present; write all 2 or none; "
      "columns found: "
      "\"x\", \"y\", \"vx\"",
      refused("a.csv", "x,y,vx\n1,2,3\n", 2));
  EXPECT_EQ("a.csv:1: error: x is named twice; name every column once",
            refused("a.csv", "x,y,x\n1,2,3\n", 2));
  EXPECT_EQ(
      "a.csv:2: error: a number is nan; positions and velocities must be finite, at most 1e15",
      refused("a.csv", "x,y\n1,nan\n", 2));
  EXPECT_EQ("a.csv:2: error: z is 3, and the scene is in 2D; make it 0, or add z to domain.max",
            refused("a.csv", "x,y,z\n1,2,3\n", 2));
  EXPECT_EQ("a.csv: error: the file has no points; name another file",
            refused("a.csv", "x,y\n", 2));
  EXPECT_EQ(
      "a.txt: error: not a known format of points (*.csv, *.ply, *.vtk, *.vtp, *.vtu, *.xyz, "
      "*.bgeo "
      "or *.bhclassic); rename it to *.csv if a line names its columns, else to *.xyz",
      refused("a.txt", "x,y\n"));
  EXPECT_EQ("a.ply:1: error: not PLY: the first line is not \"ply\"; check the file",
            refused("a.ply", "x,y\n1,2\n"));
  EXPECT_EQ("a.ply:3: error: the first element must be vertex; put the vertices first",
            refused("a.ply", "ply\nformat ascii 1.0\nelement face 2\n"));
  EXPECT_EQ(
      "a.ply:4: error: y is missing; a 2D scene needs x, y and optionally vx, vy; columns found: "
      "\"x\"",
      refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n", 2)
          .replace(6, 1, "4"));
  EXPECT_EQ("a.ply:12: error: a value is missing or not a number; the header names 7 per line",
            refused("a.ply", "ply\nformat ascii 1.0\n" + head + "1 2 3 4 5 6 x\n1 2 3 4 5 6 7 8\n")
                .replace(6, 2, "12"));
  EXPECT_EQ(
      "a.ply: error: the header announces 9999999999 vertices, and the file is too short; it "
      "is cut off",
      refused("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 9999999999\nproperty float x\n"
              "property float y\nproperty float z\nend_header\n1 2 3\n"));
  EXPECT_EQ(
      "a.ply:4: error: the vertices have a list or a property of unknown type; save them without "
      "it",
      refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int x\n"));
  EXPECT_EQ("a.ply:2: error: the format is unknown; save it as ascii or binary_little_endian PLY",
            refused("a.ply", "ply\nformat text 1.0\n"));
}

TEST_F(PointFile, ReadsTheVelocitiesOfCommonPrograms) {
  for (const char* names :
       {"Vel:0,Vel:1,Vel:2", "u,v,w", "U:0,U:1,U:2", "Ux,Uy,Uz", "vel_x,vel_y,vel_z", "VX,VY,VZ",
        "Vel.x [m/s],Vel.y [m/s],Vel.z [m/s]", "velocity_x,velocity_y,velocity_z", "v_x,v_y,v_z"}) {
    const PointCloud cloud = read("a.csv", std::string("x,y,z,") + names + ",rho\n1,2,3,4,5,6,7\n");
    EXPECT_EQ((std::vector<double>{4, 5, 6}), cloud.v) << names;
    EXPECT_EQ(std::vector<std::string>{"rho"}, cloud.unused) << names;
  }
  for (const char* names : {"Points:0,Points:1,Points:2", "X,Y,Z", "x [m],y [m],z (m)",
                            "Pos.x [m],Pos.y [m],Pos.z [m]", "position_x,position_y,position_z"})
    EXPECT_EQ((std::vector<double>{1, 2, 3}), read("a.csv", std::string(names) + "\n1,2,3\n").x)
        << names;
}

// A column v alone can be a volume, and u beside vx another velocity.
TEST_F(PointFile, ReadsLettersAsAVelocityOnlyTogether) {
  const PointCloud alone = read("a.csv", "x,y,v\n1,2,3\n", 2);
  EXPECT_TRUE(alone.v.empty());
  EXPECT_EQ(std::vector<std::string>{"v"}, alone.unused);
  const PointCloud beside = read("b.csv", "x,y,vx,vy,u,v\n1,2,3,4,5,6\n", 2);
  EXPECT_EQ((std::vector<double>{3, 4}), beside.v);
  EXPECT_EQ((std::vector<std::string>{"u", "v"}), beside.unused);
}

TEST_F(PointFile, ReadsOtherSeparatorsAndComments) {
  const std::vector<double> x{1, 2.5, 3, 4};
  for (const char* text :
       {"x;y\n1;2.5\n3;4\n", "x;y\n1;2,5\n3;4\n", "x\ty\n1\t2.5\n3\t4\n", "x y\n 1   2.5\n3 4\n",
        "# by a script\nx,y\n1,2.5\n3,4\n", "# x y\n1 2.5\n# between\n3 4\n",
        "# made by a script\n# x,y\n1 2.5\n3 4\n"})
    EXPECT_EQ(x, read("a.csv", text, 2).x) << text;
  EXPECT_EQ(x, read("A.CSV", "x,y\n1,2.5\n3,4\n", 2).x);
  EXPECT_EQ(
      "b.csv:1: error: the first line has 2 numbers and no names; write a line of names such as "
      "x,y,z before it",
      refused("b.csv", "1,2.5\n3,4\n", 2));
  EXPECT_EQ(
      "c.csv:3: error: value 2 is not a number; write numbers like 0.5 or 1e-3, with one "
      "separator between them",
      refused("c.csv", "# comment\nx,y\n1,2:5\n", 2));
}

TEST_F(PointFile, MustExistAndBeAFile) {
  EXPECT_THROW(read_points(folder_ / "none.ply", 3), Error);
  EXPECT_THROW(read_points(folder_.path(), 3), Error);
  EXPECT_THROW(read_points("/dev/null", 3), Error);
}

TEST_F(PointFile, ARegionScalesThenRotatesThenTranslates) {
  write_text(folder_ / "a.csv", "x,y,z,vx,vy,vz\n1,2,3,4,5,6\n");
  Scene::Region region;
  region.shape = Shape::points;
  region.file = (folder_ / "a.csv").string();
  EXPECT_EQ((std::vector<double>{1, 2, 3}), region_points(region, 3).x);
  region.scale = 2;
  region.rotation = {0, 0, 90};
  region.translation = {10, 0, -1};
  const PointCloud cloud = region_points(region, 3);
  const double x[] = {6, 2, 5}, v[] = {-5, 4, 6};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(x[k], cloud.x[k], 1e-12);
    EXPECT_NEAR(v[k], cloud.v[k], 1e-12);
  }
}

TEST_F(PointFile, ARegionIn2DTurnsAboutZ) {
  write_text(folder_ / "a.csv", "x,y\n1,2\n3,4\n");
  Scene::Region region;
  region.file = (folder_ / "a.csv").string();
  region.rotation = {-90};
  region.translation = {0, 1};
  const double x[] = {2, 0, 4, -2};
  const PointCloud cloud = region_points(region, 2);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(x[k], cloud.x[k], 1e-12);
}

TEST(PointSpacing, IsTheMedianDistanceOfNearestNeighbors) {
  std::vector<double> x;
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 30; ++j) x.insert(x.end(), {0.1 * k, 0.1 * j, 0.5});
  EXPECT_NEAR(0.1, median_spacing(x, 3), 1e-12);
  x.insert(x.end(), {1e6, 0, 0});
  EXPECT_NEAR(0.1, median_spacing(x, 3), 1e-12);
  EXPECT_EQ(0, median_spacing({1, 2, 3}, 3));
  EXPECT_EQ(5, median_spacing({0, 0, 3, 4}, 2));
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "cli/files.h"
#include "freshet/error.h"
#include "scene/sample/point_cloud.h"

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
  EXPECT_EQ("c.csv:1: error: x is missing; a 2D scene needs x, y and optionally vx, vy",
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
      "a.csv:3: error: value 2 is no number; write numbers like 0.5 or 1e-3, with commas "
      "between them",
      refused("a.csv", "x,y\n1,2\n1,two\n", 2));
  EXPECT_EQ("a.csv:2: error: 3 values, and the first line names 2; give every point all",
            refused("a.csv", "x,y\n1,2,3\n", 2));
  EXPECT_EQ("a.csv:1: error: z is missing; a 3D scene needs x, y, z and optionally vx, vy, vz",
            refused("a.csv", "x,y\n1,2\n"));
  EXPECT_EQ("a.csv:1: error: vy is missing, and another velocity is present; write all 2 or none",
            refused("a.csv", "x,y,vx\n1,2,3\n", 2));
  EXPECT_EQ("a.csv:1: error: x is named twice; name every column once",
            refused("a.csv", "x,y,x\n1,2,3\n", 2));
  EXPECT_EQ(
      "a.csv:2: error: a number is nan; positions and velocities must be finite, at most 1e15",
      refused("a.csv", "x,y\n1,nan\n", 2));
  EXPECT_EQ("a.csv:2: error: z is 3, and the scene is in 2D; make it 0, or add z to domain.max",
            refused("a.csv", "x,y,z\n1,2,3\n", 2));
  EXPECT_EQ("a.csv: error: the file has no points; is it the right file?",
            refused("a.csv", "x,y\n", 2));
  EXPECT_EQ("a.txt: error: not *.ply, *.vtp or *.csv; convert it to one",
            refused("a.txt", "x,y\n"));
  EXPECT_EQ("a.ply:1: error: not PLY: the first line is not \"ply\"; check the file",
            refused("a.ply", "x,y\n1,2\n"));
  EXPECT_EQ("a.ply:3: error: another element stands before the vertices; put them first",
            refused("a.ply", "ply\nformat ascii 1.0\nelement face 2\n"));
  EXPECT_EQ(
      "a.ply:4: error: y is missing; a 2D scene needs x, y and optionally vx, vy",
      refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n", 2)
          .replace(6, 1, "4"));
  EXPECT_EQ("a.ply:12: error: not 7 numbers, which the header asks for; the file is damaged",
            refused("a.ply", "ply\nformat ascii 1.0\n" + head + "1 2 3 4 5 6 x\n1 2 3 4 5 6 7 8\n")
                .replace(6, 2, "12"));
  EXPECT_EQ(
      "a.ply: error: the header tells of 9999999999 vertices, and the file ends before; it "
      "is cut off",
      refused("a.ply",
              "ply\nformat ascii 1.0\nelement vertex 9999999999\nproperty float x\n"
              "property float y\nproperty float z\nend_header\n1 2 3\n"));
  EXPECT_EQ(
      "a.ply:4: error: a vertex has a list or a property of unknown type; save it without",
      refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int x\n"));
  EXPECT_EQ("a.ply:2: error: an unknown format; save it as ascii or binary_little_endian PLY",
            refused("a.ply", "ply\nformat text 1.0\n"));
}

TEST_F(PointFile, MustExistAndBeAFile) {
  EXPECT_THROW(read_points(folder_ / "none.ply", 3), Error);
  EXPECT_THROW(read_points(folder_.path(), 3), Error);
  EXPECT_THROW(read_points("/dev/null", 3), Error);
}

}  // namespace
}  // namespace freshet::test

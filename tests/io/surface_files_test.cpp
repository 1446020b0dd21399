// SPDX-License-Identifier: MIT
#include "io/surface_files.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "formats/point_formats.h"
#include "io/frame_files.h"
#include "mesh/triangle_mesh.h"

namespace freshet::test {
namespace {

using Point = SurfaceMesh::Point;

/// A tetrahedron that moves.
SurfaceMesh tetrahedron() {
  SurfaceMesh mesh;
  mesh.position = {{0, 0, 0}, {1.5f, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh.normal = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.velocity = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}
constexpr SurfaceTime moment{0.25, 40};

void expect_tetrahedron(const TriangleMesh& read) {
  const SurfaceMesh mesh = tetrahedron();
  ASSERT_EQ(read.points.size(), 4u);
  ASSERT_EQ(read.triangles.size(), 4u);
  double volume = 0;
  for (int t = 0; t < 4; ++t) {
    const auto [a, b, c] = read.corners(t);
    volume += dot(a, cross(b, c)) / 6;
  }
  EXPECT_NEAR(volume, volume_of(mesh), 1e-6);
}

TEST(SurfaceFiles, PlyIsReadByTheMeshReader) {
  const std::string bytes = encode_surface(SurfaceFormat::ply, tetrahedron(), moment);
  expect_tetrahedron(mesh_in(bytes, "surface.ply"));
  const Frame points = frame_in(bytes, "surface.ply");  // the vertices as particles
  EXPECT_EQ(points.time, 0.25);
  EXPECT_EQ(points.step, 40);
  EXPECT_EQ(points.x, (std::vector<float>{0, 0, 0, 1.5f, 0, 0, 0, 2, 0, 0, 0, 3}));
  EXPECT_EQ(points.v, (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST(SurfaceFiles, ObjIsReadByTheMeshReader) {
  const std::string bytes = encode_surface(SurfaceFormat::obj, tetrahedron(), moment);
  EXPECT_NE(bytes.find("f 2//2 3//3 4//4\n"), std::string::npos);
  if (!reads_meshes()) GTEST_SKIP() << "Assimp is not installed";
  TriangleMesh mesh = mesh_in(bytes, "surface.obj");
  mend_mesh(mesh);  // Assimp gives each triangle its own points
  expect_tetrahedron(mesh);
}

TEST(SurfaceFiles, VtpIsReadByThePointReader) {
  const std::string bytes = encode_surface(SurfaceFormat::vtp, tetrahedron(), moment);
  const Frame points = frame_in(bytes, "surface.vtp");
  EXPECT_EQ(points.time, 0.25);
  EXPECT_EQ(points.x.size(), 12u);
  EXPECT_EQ(points.v[11], 12);
  EXPECT_NE(bytes.find("NumberOfPolys=\"4\""), std::string::npos);
  // The last array is the ends of the triangles, before the closing tags.
  const std::size_t end = bytes.rfind("\n  </AppendedData>");
  std::int64_t ends[4];
  std::memcpy(ends, bytes.data() + end - sizeof ends, sizeof ends);
  EXPECT_EQ(ends[0], 3);
  EXPECT_EQ(ends[3], 12);
}

/// A *.glb file, taken apart as the specification of glTF 2.0 says.
struct Glb {
  nlohmann::json json;
  std::string binary;
  explicit Glb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(word(file, 4), 2u);
    EXPECT_EQ(word(file, 8), file.size());
    const std::size_t length = word(file, 12);
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(file.substr(16, 4), "JSON");
    json = nlohmann::json::parse(file.substr(20, length));
    if (20 + length == file.size()) return;
    EXPECT_EQ(word(file, 20 + length) % 4, 0u);
    EXPECT_EQ(file.substr(24 + length, 4), std::string("BIN\0", 4));
    binary = file.substr(28 + length);
    EXPECT_EQ(binary.size(), word(file, 20 + length));
    EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
  }
  static std::uint32_t word(const std::string& file, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, file.data() + at, sizeof value);
    return value;
  }
  template <class T> std::vector<T> values(std::size_t accessor) const {
    const auto& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<int>()];
    const std::size_t from = view["byteOffset"], bytes = view["byteLength"];
    EXPECT_EQ(from % 4, 0u);
    EXPECT_LE(from + bytes, binary.size());
    std::vector<T> all(bytes / sizeof(T));
    std::memcpy(all.data(), binary.data() + from, bytes);
    return all;
  }
};

TEST(SurfaceFiles, GlbHasTheArraysThatItsDocumentNames) {
  const SurfaceMesh mesh = tetrahedron();
  const Glb glb(encode_surface(SurfaceFormat::glb, mesh, moment));
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["asset"]["extras"]["time"], 0.25);
  const auto& primitive = glb.json["meshes"][0]["primitives"][0];
  const auto& attributes = primitive["attributes"];
  EXPECT_EQ(glb.values<Point>(attributes["POSITION"]), mesh.position);
  EXPECT_EQ(glb.values<Point>(attributes["NORMAL"]), mesh.normal);
  EXPECT_EQ(glb.values<Point>(attributes["_VELOCITY"]), mesh.velocity);
  EXPECT_EQ((glb.values<std::array<std::uint32_t, 3>>(primitive["indices"])), mesh.triangles);
  const auto& positions = glb.json["accessors"][attributes["POSITION"].get<int>()];
  EXPECT_EQ(positions["count"], 4);
  EXPECT_EQ(positions["min"], (nlohmann::json{0, 0, 0}));
  EXPECT_EQ(positions["max"], (nlohmann::json{1.5, 2, 3}));
  EXPECT_EQ(glb.json["accessors"][primitive["indices"].get<int>()]["count"], 12);
}

TEST(SurfaceFiles, AMeshWithoutTrianglesIsAValidFile) {
  const SurfaceMesh none;
  EXPECT_NE(encode_surface(SurfaceFormat::ply, none, moment).find("element vertex 0\n"),
            std::string::npos);
  EXPECT_EQ(encode_surface(SurfaceFormat::obj, none, moment), "# time 0.25 s, step 40\n");
  EXPECT_EQ(frame_in(encode_surface(SurfaceFormat::vtp, none, moment), "none.vtp").size(), 0u);
  const Glb glb(encode_surface(SurfaceFormat::glb, none, moment));
  EXPECT_EQ(glb.json["scenes"].size(), 1u);
  EXPECT_FALSE(glb.json.contains("meshes"));  // an accessor must have at least one value
  EXPECT_FALSE(glb.json.contains("accessors"));
}

}  // namespace
}  // namespace freshet::test

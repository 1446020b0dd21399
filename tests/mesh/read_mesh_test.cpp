// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "cli/files.h"
#include "freshet/error.h"
#include "mesh/mesh_distance.h"
#include "mesh/mesh_formats.h"
#include "mesh/meshes.h"

namespace freshet::test {
namespace {

class ReadMesh : public ::testing::Test {
 protected:
  /// The message about these bytes, "NAME[:LINE]: error: ...".
  static std::string refused(const std::string& name, const std::string& bytes) {
    try {
      mesh_in(bytes, name);
      return "read without an error";
    } catch (const Error& e) {
      return e.what();
    }
  }
  static std::string obj_refused(const std::string& text) {
    FilePlace place("a.obj");
    try {
      return plain_obj(text, place);
    } catch (const Error& e) {
      return e.what();
    }
  }
  static std::string stl_refused(const std::string& bytes) {
    FilePlace place("a.stl");
    try {
      check_stl(bytes, place);
      return "read without an error";
    } catch (const Error& e) {
      return e.what();
    }
  }

  template <class T> static std::string number(T value, bool big) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (big) std::reverse(bytes, bytes + sizeof value);
    return {bytes, sizeof value};
  }
  static std::string head(const std::string& format, int faces, const std::string& list) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
           "element face " +
           std::to_string(faces) + "\nproperty list " + list + " vertex_indices\nend_header\n";
  }
  /// A box of twelve triangles. `last` is the last corner of its last face.
  template <class Index> static std::string binary_box(const char* type, bool big, Index last = 5) {
    const TriangleMesh box = box_mesh({0, 0, 0}, {0.5, 1, 2});
    std::string bytes =
        head(big ? "binary_big_endian" : "binary_little_endian", 12, std::string("uchar ") + type);
    for (const Point& p : box.points)
      bytes += number(float(p.x), big) + number(float(p.y), big) + number(float(p.z), big);
    for (const auto& t : box.triangles) {
      const bool end = &t == &box.triangles.back();
      bytes += '\3' + number(Index(t[0]), big) + number(Index(t[1]), big) +
               number(end ? last : Index(t[2]), big);
    }
    return bytes;
  }
  static std::string ascii_box(int faces, const std::string& last_face) {
    const TriangleMesh box = box_mesh({0, 0, 0}, {0.5, 1, 2});
    std::ostringstream text;
    text << head("ascii", faces, "uchar int");
    for (const Point& p : box.points) text << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (std::size_t k = 0; k + 1 < std::size_t(faces); ++k) {
      const auto& t = box.triangles[k];
      text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    }
    text << last_face << '\n';
    return text.str();
  }
  static void expect_box(TriangleMesh mesh) {
    EXPECT_EQ(8u, mesh.points.size());
    EXPECT_EQ(12u, mesh.triangles.size());
    EXPECT_TRUE(mend_mesh(mesh).closed());
    const MeshDistance distance(mesh);
    EXPECT_EQ((std::array{0.0, 0.0, 0.0}),
              (std::array{distance.low().x, distance.low().y, distance.low().z}));
    EXPECT_EQ((std::array{0.5, 1.0, 2.0}),
              (std::array{distance.high().x, distance.high().y, distance.high().z}));
  }
};

TEST_F(ReadMesh, ReadsPlyOfAnyByteOrderAndInteger) {
  expect_box(mesh_in(ascii_box(12, "3 3 7 5"), "a.ply"));
  for (const bool big : {false, true}) {
    expect_box(mesh_in(binary_box<std::int8_t>("char", big), "a.ply"));
    expect_box(mesh_in(binary_box<std::uint8_t>("uint8", big), "a.ply"));
    expect_box(mesh_in(binary_box<std::int16_t>("short", big), "a.ply"));
    expect_box(mesh_in(binary_box<std::uint16_t>("uint16", big), "A.PLY"));
    expect_box(mesh_in(binary_box<std::int32_t>("int", big), "a.ply"));
    expect_box(mesh_in(binary_box<std::uint32_t>("uint", big), "a.ply"));
  }
}

TEST_F(ReadMesh, SplitsPolygonsOfPlyAndSkipsWhatIsNoMesh) {
  const TriangleMesh mesh = mesh_in(
      "ply\nformat ascii 1.0\ncomment by hand\nelement material 1\nproperty list uchar float k\n"
      "element vertex 6\nproperty double z\nproperty uchar red\nproperty double y\n"
      "property double x\nelement face 1\nproperty uchar flags\n"
      "property list int uint vertex_index\nproperty list uchar float texcoord\n"
      "element edge 1\nproperty int a\nend_header\n"
      "2 0.5 0.5\n"
      "9 255 9 9\n3 255 0 0\n3 255 0 1\n3 255 1 2\n3 255 2 1\n3 255 2 0\n"
      "7 5 1 2 3 4 5 2 0.5 0.5\n1\n",
      "a.ply");
  ASSERT_EQ(5u, mesh.points.size()) << "the first vertex has no face";
  EXPECT_EQ((std::vector<TriangleMesh::Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}), mesh.triangles);
  EXPECT_EQ(2, mesh.points[2].x);
  EXPECT_EQ(1, mesh.points[2].y);
  EXPECT_EQ(3, mesh.points[2].z);
}

TEST_F(ReadMesh, RejectsTruncatedPly) {
  const std::string whole = binary_box<std::int32_t>("int", false);
  const std::size_t header = whole.find("end_header");
  for (std::size_t n = 1; n < whole.size(); ++n) {
    const std::string message = refused("a.ply", whole.substr(0, n));
    EXPECT_TRUE(message.starts_with("a.ply") && (contains(message, "cut off") || n < header))
        << n << ": " << message;
  }
  const std::string text = ascii_box(12, "3 3 7 5");
  for (std::size_t n = 1; n + 2 < text.size(); ++n)
    EXPECT_NE("read without an error", refused("a.ply", text.substr(0, n))) << n;
}

TEST_F(ReadMesh, RejectsFacesOfPlyThatAreWrong) {
  EXPECT_EQ(
      "a.ply:29: error: face 11 has the vertex 1000000000, and there are 8 vertices, from 0 on; "
      "export the mesh again",
      refused("a.ply", ascii_box(12, "3 3 7 1000000000")));
  EXPECT_EQ(
      "a.ply:29: error: face 11 has the vertex -1, and there are 8 vertices, from 0 on; export the "
      "mesh again",
      refused("a.ply", ascii_box(12, "3 3 7 -1")));
  EXPECT_TRUE(contains(refused("a.ply", ascii_box(12, "3 3 7 8")), "has the vertex 8"));
  EXPECT_TRUE(contains(refused("a.ply", ascii_box(12, "3 3 7 1.5")), "has the vertex 1.5"));
  EXPECT_TRUE(contains(refused("a.ply", ascii_box(12, "3 3 7 nan")), "has the vertex nan"));
  EXPECT_EQ("a.ply:29: error: face 11 has 0 corners; the minimum is 3, export the mesh again",
            refused("a.ply", ascii_box(12, "0")));
  EXPECT_EQ("a.ply:29: error: face 11 has 2 corners; the minimum is 3, export the mesh again",
            refused("a.ply", ascii_box(12, "2 0 1")));
  EXPECT_TRUE(contains(refused("a.ply", ascii_box(12, "-3 0 1 2")), "a list of -3 entries"));
  EXPECT_TRUE(
      contains(refused("a.ply", ascii_box(12, "4000000000 0 1 2")), "its line is too short"));
  EXPECT_EQ(
      "a.ply: error: face 11 has the vertex -2147483648, and there are 8 vertices, from 0 on; "
      "export the mesh again",
      refused("a.ply", binary_box<std::int32_t>("int", false, INT32_MIN)));
}

TEST_F(ReadMesh, RejectsPlyThatIsNoMesh) {
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string box = ascii_box(12, "3 3 7 5");
  EXPECT_TRUE(contains(refused("a.ply", with(box, "0.5 0 0", "nan 0 0")),
                       "vertex 1 has the coordinate nan; coordinates are finite"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "0.5 0 0", "1e300 0 0")), "at most 1e+15"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "face 12", "face 0")), "the mesh has no faces"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "face 12", "edge 12")), "no element \"face\""));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "float z", "float w")), "vertices have no z"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "vertex_indices", "other")), "vertex_indices"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "face 12", "face 999999999")), "cut off"));
  EXPECT_TRUE(
      contains(refused("a.ply", with(box, "element face", "element vertex")), "\"vertex\" twice"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "uchar int", "float int")), "unknown type"));
  EXPECT_TRUE(contains(refused("a.ply", with(box, "uchar int", "uchar word")), "unknown type"));
  EXPECT_TRUE(contains(  // binary rows without bytes, as many as a counter holds
      refused("a.ply",
              "ply\nformat binary_little_endian 1.0\nelement nothing 18446744073709551615\n" +
                  head("", 12, "uchar int").substr(15)),
      "cut off"));
}

TEST_F(ReadMesh, WritesObjWithoutEverythingButVerticesAndFaces) {
  EXPECT_EQ("v 0 0 0\nv 1 0 0 2\nv 1.5e0 1 0\nf 1 2 3\nf 1 2 3\nf 3 2 1\n",
            obj_refused("# made by hand\nmtllib /dev/zero\r\no box\nv 0 0 0\nv 1 0 0 2\r\nvt 0 0\n"
                        "v 1.5e0 1 0 1 0 0\nvn 0 0 1\nusemtl red\ng a\ns off\nf 1/1/1 2//1 3/1\n"
                        "f -3 \\\n-2 \\\r\n-1\nl 1 2\np 1\nf 3 2 1"));
}

TEST_F(ReadMesh, RejectsObjThatIsWrong) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  EXPECT_EQ(
      "a.obj:4: error: a face has the vertex 4, and there are 3 vertices, from 1 on; export the "
      "mesh again",
      obj_refused(three + "f 1 2 4\nf 1 2 3\n"));
  EXPECT_TRUE(contains(obj_refused(three + "f 1 2 0\n"), "the vertex 0,"));
  EXPECT_TRUE(contains(obj_refused(three + "f 1 2 -4\n"), "the vertex -4,"));
  EXPECT_TRUE(contains(obj_refused(three + "f 1 2 99999999999999999999\n"), "write whole numbers"));
  EXPECT_TRUE(contains(obj_refused(three + "f 1 2 x\n"), "the vertex \"x\"; write whole numbers"));
  EXPECT_EQ("a.obj:5: error: a face has 2 corners; the minimum is 3, export the mesh again",
            obj_refused(three + "f 1 2 3\nf 1 2\n"));
  std::string polygon = "f";
  for (std::size_t k = 0; k < most_corners; ++k) polygon += " 1";
  EXPECT_TRUE(contains(obj_refused(three + polygon + "\n"), "f 1 1 1"));
  EXPECT_EQ("a.obj:4: error: a face has more than 10000 corners; split it into triangles",
            obj_refused(three + polygon + " 1\n"));
  EXPECT_TRUE(contains(obj_refused("v 0 0\n"), "fewer than 3 coordinates"));
  EXPECT_TRUE(contains(obj_refused("v 0 0 nan\n"), "the coordinate \"nan\""));
  EXPECT_TRUE(contains(obj_refused("v 0 0 1e16\n"), "the coordinate \"1e16\""));
  EXPECT_TRUE(contains(obj_refused("v 0 0 1 0\n"), "the weight 0"));
  EXPECT_EQ("a.obj: error: the mesh has no faces; export it again", obj_refused(three + "l 1 2\n"));
  EXPECT_TRUE(contains(obj_refused("\\\n\\\n"), "no face"));
}

TEST_F(ReadMesh, ChecksStlBeforeItIsRead) {
  const auto binary = [](std::uint32_t facets, std::size_t bytes) {
    std::string all(84 + bytes, '\0');
    std::memcpy(all.data() + 80, &facets, sizeof facets);
    return all;
  };
  EXPECT_EQ("read without an error", stl_refused(binary(2, 100)));
  EXPECT_EQ(
      "a.stl: error: binary STL with 2 triangles has 184 bytes, and this "
      "file has 183; it is cut off or damaged",
      stl_refused(binary(2, 99)));
  EXPECT_TRUE(contains(stl_refused(binary(4294967295u, 50)), "with 4294967295 triangles"));
  EXPECT_TRUE(contains(stl_refused(binary(0, 0)), "the mesh has no triangles"));
  EXPECT_TRUE(contains(stl_refused("no mesh"), "does not begin with \"solid\""));
  const std::string ascii = stl_of(box_mesh({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ("read without an error", stl_refused(ascii));
  EXPECT_TRUE(contains(stl_refused(ascii.substr(0, ascii.size() / 2 - 9)), "a.stl: error: "));
  EXPECT_TRUE(contains(stl_refused(ascii.substr(0, ascii.find("facet", 200))), "endsolid"));
  EXPECT_TRUE(contains(stl_refused("solid facet\nendsolid facet\n"), "the mesh has no facets"));
  EXPECT_TRUE(contains(stl_refused("solid\nfacet\nvertex 0 0 0\nvertex 0 0 1\nendfacet\n"),
                       "facet 0 must have 3 vertices"));
  EXPECT_TRUE(contains(stl_refused("solid\nfacet\nvertex 0 0 x\n"), "the coordinate \"x\""));
  EXPECT_TRUE(contains(stl_refused(std::string("solid\nfacet\0", 12)), "zero byte"));
}

TEST_F(ReadMesh, ReadsStlAndObjByAssimp) {
  if (!reads_meshes()) GTEST_SKIP() << "built without Assimp";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 2 5\n";
  EXPECT_EQ(3u, mesh_in(obj, "a.obj").triangles.size()) << "a quadrilateral is two triangles";
  TriangleMesh box = mesh_in(stl_of(box_mesh({0, 0, 0}, {0.5, 1, 2})), "A.STL");
  EXPECT_EQ(12u, box.triangles.size());
  EXPECT_TRUE(mend_mesh(box).closed());
  expect_box(box);
}

TEST_F(ReadMesh, OpensNoMaterialFile) {
  if (!reads_meshes()) GTEST_SKIP() << "built without Assimp";
  const TemporaryFolder folder;
  ASSERT_EQ(0, std::system(("mkfifo " + (folder / "a.mtl").string()).c_str()));
  write_text(folder / "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\nf 1 2 3\n");
  EXPECT_EQ(1u, read_mesh(folder / "a.obj").triangles.size());  // a reader of the FIFO would hang
}

TEST_F(ReadMesh, RejectsOtherFiles) {
  EXPECT_TRUE(contains(refused("a.txt", "v 0 0 0\n"), "(*.stl, *.obj or *.ply)"));
  const TemporaryFolder folder;
  EXPECT_THROW(read_mesh(folder / "none.stl"), Error);
  EXPECT_THROW(read_mesh(folder.path()), Error);
}

}  // namespace
}  // namespace freshet::test

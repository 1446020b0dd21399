// SPDX-License-Identifier: MIT
#include "surface/cube_table.h"

#include <gtest/gtest.h>

#include <map>

namespace freshet::test {
namespace {

bool wet(int inside, int corner) { return (inside >> corner & 1) != 0; }
int far_corner(int edge) { return edge_corner(edge) | 1 << edge / 4; }
bool is_cut(int inside, int edge) {
  return wet(inside, edge_corner(edge)) != wet(inside, far_corner(edge));
}

/// Whether two edges lie in one face of the cube.
bool share_a_face(int a, int b) {
  for (int axis = 0; axis < 3; ++axis) {
    int ones = 0;
    for (const int corner : {edge_corner(a), far_corner(a), edge_corner(b), far_corner(b)})
      ones += corner >> axis & 1;
    if (ones == 0 || ones == 4) return true;
  }
  return false;
}

TEST(CubeTable, EdgesJoinNeighboringCorners) {
  std::set<std::pair<int, int>> all;
  for (int e = 0; e < 12; ++e) {
    EXPECT_EQ(edge_corner(e) >> e / 4 & 1, 0);
    all.insert({edge_corner(e), far_corner(e)});
  }
  EXPECT_EQ(all.size(), 12u);
}

TEST(CubeTable, TrianglesUseEveryCutAndNoOther) {
  for (int inside = 0; inside < 256; ++inside) {
    std::set<int> used, cut;
    const CubeTriangles& cube = cube_table()[std::size_t(inside)];
    for (int k = 0; k < cube.count; ++k)
      for (const int e : cube.edges[std::size_t(k)]) used.insert(e);
    for (int e = 0; e < 12; ++e)
      if (is_cut(inside, e)) cut.insert(e);
    EXPECT_EQ(used, cut) << inside;
  }
}

/// Within a cube an edge of a triangle is met by another triangle, or lies on a face: then the two
/// cuts belong to one line on that face.
TEST(CubeTable, SurfaceEndsOnFacesOnly) {
  for (int inside = 0; inside < 256; ++inside) {
    std::map<std::pair<int, int>, int> count;
    const CubeTriangles& cube = cube_table()[std::size_t(inside)];
    for (int k = 0; k < cube.count; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        ++count[{cube.edges[std::size_t(k)][c], cube.edges[std::size_t(k)][(c + 1) % 3]}];
    for (const auto& [edge, times] : count) {
      EXPECT_EQ(times, 1) << inside;
      const bool inner = count.contains({edge.second, edge.first});
      EXPECT_NE(inner, share_a_face(edge.first, edge.second)) << inside;
    }
  }
}

TEST(CubeTable, TrianglesFaceOutOfTheFluid) {
  const CubeTriangles& cube = cube_table()[1];  // corner 0 is inside
  ASSERT_EQ(cube.count, 1);
  const auto [a, b, c] = cube.edges[0];  // axes in the order x, y, z, in some rotation
  EXPECT_EQ((b / 4 - a / 4 + 3) % 3, 1);
  EXPECT_EQ((c / 4 - b / 4 + 3) % 3, 1);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>

namespace freshet {

/// The triangles in a cube by its corners inside the fluid [marching cubes, Lorensen and Cline
/// 1987].
///
/// Corner c of a cube is at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge e runs along axis e/4 from the
/// e%4-th corner that has 0 there. The surface cuts the edges whose ends differ.
///
/// Meshes are closed and manifold for any values:
/// - On a face with two diagonal corners inside, the fluid of both is joined. The rule depends on
///   the face only, so the cubes on both sides agree.
/// - No triangle has an inner edge between two cuts of one face, where that of the cube behind the
///   face could coincide with it.
struct CubeTriangles {
  static constexpr int most = 5;
  int count = 0;
  std::array<std::array<std::int8_t, 3>, most> edges{};  ///< counterclockwise seen from outside
};

/// Entry `inside`: its bit c is set if corner c is inside.
const std::array<CubeTriangles, 256>& cube_table();

/// The first corner of an edge.
constexpr int edge_corner(int edge) {
  const int axis = edge / 4, k = edge % 4, below = k & ((1 << axis) - 1);
  return (k - below) << 1 | below;
}

}  // namespace freshet

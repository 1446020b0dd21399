// SPDX-License-Identifier: MIT
#include "surface/cube_table.h"

#include <vector>

namespace freshet {
namespace {

constexpr int edges = 12, faces = 6;

int edge_between(int a, int b) {
  for (int e = 0; e < edges; ++e) {
    const int first = edge_corner(e), second = first | 1 << e / 4;
    if ((first == a && second == b) || (first == b && second == a)) return e;
  }
  return -1;
}

/// The corners of a face, counterclockwise seen from outside the cube.
std::array<int, 4> corners_of(int face) {
  const int axis = face / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
  if (face % 2 == 1) return {1 << axis, 1 << axis | u, 1 << axis | u | v, 1 << axis | v};
  return {0, v, u | v, u};
}

bool share_a_face(int edge, int other) {
  const int ends[] = {edge_corner(edge), edge_corner(edge) | 1 << edge / 4, edge_corner(other),
                      edge_corner(other) | 1 << other / 4};
  for (int axis = 0; axis < 3; ++axis) {
    int ones = 0;
    for (const int end : ends) ones += end >> axis & 1;
    if (ones == 0 || ones == 4) return true;
  }
  return false;
}

/// The cut that follows each cut along the surface in the cube; -1 for edges without a cut. A line
/// on a face runs from where the fluid ends to where it begins again, counterclockwise around the
/// face: it encloses corners outside the fluid.
std::array<int, edges> next_cuts(int inside) {
  std::array<int, edges> next;
  next.fill(-1);
  const auto wet = [inside](int corner) { return (inside >> corner & 1) != 0; };
  for (int face = 0; face < faces; ++face) {
    const auto around = corners_of(face);
    const auto corner = [&](int k) { return around[std::size_t(k % 4)]; };
    for (int k = 0; k < 4; ++k) {
      if (!wet(corner(k)) || wet(corner(k + 1))) continue;
      int end = k + 1;
      while (!wet(corner(end + 1))) ++end;
      next[std::size_t(edge_between(corner(k), corner(k + 1)))] =
          edge_between(corner(end), corner(end + 1));
    }
  }
  return next;
}

using Loop = std::vector<int>;

std::vector<Loop> loops_of(int inside) {
  const auto next = next_cuts(inside);
  std::array<bool, edges> done{};
  std::vector<Loop> loops;
  for (int start = 0; start < edges; ++start) {
    if (next[std::size_t(start)] < 0 || done[std::size_t(start)]) continue;
    Loop loop;
    for (int e = start; !done[std::size_t(e)]; e = next[std::size_t(e)]) {
      done[std::size_t(e)] = true;
      loop.push_back(e);
    }
    loops.push_back(loop);
  }
  return loops;
}

/// Splits the part of a loop from `first` to `last` into triangles without an inner edge on a face.
/// False if there is no such split.
bool split(const Loop& loop, std::size_t first, std::size_t last, CubeTriangles& out) {
  const auto allowed = [&](std::size_t a, std::size_t b) {
    return b == a + 1 || (a == 0 && b + 1 == loop.size()) || !share_a_face(loop[a], loop[b]);
  };
  if (last == first + 1) return true;
  for (std::size_t apex = first + 1; apex < last; ++apex) {
    if (!allowed(first, apex) || !allowed(apex, last)) continue;
    const int before = out.count;
    if (out.count < CubeTriangles::most) {
      out.edges[std::size_t(out.count++)] = {std::int8_t(loop[first]), std::int8_t(loop[last]),
                                             std::int8_t(loop[apex])};
      if (split(loop, first, apex, out) && split(loop, apex, last, out)) return true;
    }
    out.count = before;
  }
  return false;
}

std::array<CubeTriangles, 256> make_table() {
  std::array<CubeTriangles, 256> table;
  for (int inside = 0; inside < 256; ++inside)
    for (const Loop& loop : loops_of(inside))
      split(loop, 0, loop.size() - 1, table[std::size_t(inside)]);
  return table;
}

}  // namespace

const std::array<CubeTriangles, 256>& cube_table() {
  static const std::array<CubeTriangles, 256> table = make_table();
  return table;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "scene/model/loaded_mesh.h"

namespace freshet {

/// The cells of a box that are near the triangles of a mesh: a test before a slow one.
class NearCells {
 public:
  using Point = TriangleMesh::Point;

  /// The box is from `low` to `high`, and two cells more. `near` is a cell's width, unless there
  /// would be too many cells [m].
  NearCells(std::size_t dimension, Point low, Point high, const TriangleMesh& mesh, double near);
  /// Whether x may be closer to a triangle than `near`. Always false outside the box.
  bool has(Point x) const;

 private:
  void mark(const std::array<Point, 3>& corners);

  std::size_t dimension_;
  Point low_{};
  double cell_;
  std::array<std::int64_t, 3> count_{1, 1, 1};
  std::vector<std::uint8_t> marked_;
};

}  // namespace freshet

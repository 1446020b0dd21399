// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "scene/model/loaded_mesh.h"

namespace freshet {

/// Which of many balls may hold a point: a grid over the domain, whose cells list the balls that
/// reach into them. What is outside the domain counts to the cells at its ends.
class BodyCells {
 public:
  using Point = TriangleMesh::Point;

  /// `width` of a cell [m], at least.
  BodyCells(const Scene& scene, double width);
  void clear();
  void add(int ball, Point center, double radius);
  const std::vector<int>& at(Point x) const;

 private:
  std::int64_t place(double along, std::size_t axis) const;
  std::int64_t in_grid(std::int64_t place, std::size_t axis) const;

  std::size_t dimension_;
  std::array<double, 3> low_{}, per_length_{};  // cells per metre
  std::array<std::int64_t, 3> count_{1, 1, 1};
  std::array<bool, 3> periodic_{};
  std::vector<std::vector<int>> cells_;
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "mesh/triangle_mesh.h"

namespace freshet {

/// The share of the sphere around x that a triangle covers, positive where x is behind it
/// [Van Oosterom and Strackee 1983].
double solid_angle(const std::array<Vec<3, double>, 3>& triangle, Vec<3, double> x);

/// How far a point is from a mesh, and whether it is inside: by a tree of boxes around triangles.
///
/// Inside is where the winding number is above one half, which small holes and overlaps of shells
/// do not upset [Jacobson, Kavan and Sorkine-Hornung 2013]; what is far off counts as a dipole
/// [Barill et al. 2018].
class MeshDistance {
 public:
  using Point = TriangleMesh::Point;

  /// A mended mesh with a triangle.
  explicit MeshDistance(TriangleMesh mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  Point low() const { return nodes_[0].low; }
  Point high() const { return nodes_[0].high; }
  double area() const { return nodes_[0].area; }

  struct Nearest {
    double distance;
    Point point;
    int triangle;
  };
  Nearest nearest(Point x) const;
  double winding_number(Point x) const;
  bool is_inside(Point x) const;
  /// To the surface [m]; negative inside.
  double signed_distance(Point x) const;
  /// How far the first triangle is that a ray meets beyond `least`, in units of its direction.
  std::optional<double> first_hit(Point from, Point direction, double least) const;

 private:
  /// Triangles first .. first + count of `order_` if count > 0; else the nodes after it and at
  /// `second`.
  struct Node {
    Point low, high;
    Point center, area_normal;  ///< of the dipole
    double radius, area;
    int first, count, second;
  };
  int build(int first, int count);
  Node node_around(int first, int count) const;
  void nearest(int node, Point x, Nearest& best) const;
  double winding(int node, Point x) const;

  TriangleMesh mesh_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace freshet

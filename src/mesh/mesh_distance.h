// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "mesh/triangle_mesh.h"

namespace freshet {

/// The fraction of the unit sphere around x that a triangle covers, positive if x is behind the
/// triangle [Van Oosterom and Strackee 1983].
double solid_angle(const std::array<Vec<3, double>, 3>& triangle, Vec<3, double> x);

/// Distance to a mesh and inside test, by a tree of boxes around triangles.
///
/// A point is inside if its winding number is above one half. This test is robust to small holes
/// and overlapping shells [Jacobson, Kavan and Sorkine-Hornung 2013]. Distant nodes count as
/// dipoles [Barill et al. 2018].
class MeshDistance {
 public:
  using Point = TriangleMesh::Point;

  /// `mesh` must be mended and have at least one triangle.
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
  /// The distance from the surface [m]; negative inside.
  double signed_distance(Point x) const;
  /// The distance at which a ray first meets a triangle beyond `least`, in units of `direction`.
  std::optional<double> first_hit(Point from, Point direction, double least) const;

  struct Crossing {
    double along;  ///< fraction of the way, 0 to 1
    int triangle;
  };
  /// Where a straight way first passes a triangle, or one from outside only. The edges of triangles
  /// count, so that nothing slips through where two of them meet. A way that starts on a triangle
  /// does not cross it.
  std::optional<Crossing> first_crossing(Point from, Point to, bool two_sided = true) const;

 private:
  /// A leaf has the triangles first to first + count - 1 of `order_`. An inner node has count 0;
  /// its children are the next node and the node `second`.
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

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <memory>
#include <string>

#include "core/vec.h"
#include "scene/model/expressions.h"

namespace freshet {

/// The letters of the coordinates that a free surface depends on.
inline const char* surface_variables(int dimension) { return dimension == 3 ? "xz" : "x"; }

/// A free surface y = f(x), in 3D y = f(x, z), of a scene (Scene::Fluid::surface). The function
/// must be valid.
class FreeSurface {
 public:
  FreeSurface(const std::string& function, int dimension, double spacing);

  /// Its height at the column of x [m]; -infinity where the function has no finite value.
  template <int D> double height(Vec<D, double> x) const { return height_at(x.x, depth_of(x)); }
  /// The distance of x from the surface [m], positive below it. It is that from the tangent plane
  /// at the column of x.
  template <int D> double distance(Vec<D, double> x) const {
    const Vec<3, double> up = upward(x.x, depth_of(x));
    return (height(x) - x.y) * up.y;
  }
  /// The unit normal at the column of x; it points into the fluid.
  template <int D> Vec<D, double> normal(Vec<D, double> x) const {
    Vec<3, double> up = upward(x.x, depth_of(x));
    Vec<D, double> down{};
    for (int k = 0; k < D; ++k) component(down, k) = -component(up, k);
    return down;
  }

 private:
  template <int D> static double depth_of(Vec<D, double> x) {
    return D == 3 ? component(x, D - 1) : 0;
  }
  double height_at(double x, double z) const;
  Vec<3, double> upward(double x, double z) const;  ///< the unit normal out of the fluid

  std::shared_ptr<Expressions> function_;
  int dimension_;
  double step_;  ///< of differences [m]
};

/// Calls visit(x, width) for the centre of each column, `width` wide, that divides a box; y is 0.
/// Columns are at most `widest` wide along each horizontal axis.
template <int D, class F>
void each_column(Vec<D, double> low, Vec<D, double> high, double widest, F visit) {
  Vec<D, double> width{};
  int count[3] = {1, 1, 1};
  for (int k = 0; k < D; ++k) {
    if (k == 1) continue;
    const double length = component(high, k) - component(low, k);
    count[k] = std::max(1, int(std::min(length / widest + 1, 1e6)));
    component(width, k) = length / count[k];
  }
  for (int n = 0; n < (D == 3 ? count[D - 1] : 1); ++n)
    for (int m = 0; m < count[0]; ++m) {
      Vec<D, double> x{};
      if (D == 3) component(x, D - 1) = component(low, D - 1) + (n + 0.5) * component(width, D - 1);
      x.x = low.x + (m + 0.5) * width.x;
      visit(x, width);
    }
}

}  // namespace freshet

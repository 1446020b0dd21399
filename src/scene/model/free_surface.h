// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

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
  template <int D> double height(Vec<D, double> x) const {
    return at(x.x, depth_of(x), false).height;
  }
  /// The distance of x from the surface [m], positive below it. It is that from the tangent plane
  /// at the column of x.
  template <int D> double distance(Vec<D, double> x) const {
    const Column& column = at(x.x, depth_of(x), true);
    return (column.height - x.y) * column.up.y;
  }
  /// The unit normal at the column of x; it points into the fluid.
  template <int D> Vec<D, double> normal(Vec<D, double> x) const {
    Vec<3, double> up = at(x.x, depth_of(x), true).up;
    Vec<D, double> down{};
    for (int k = 0; k < D; ++k) component(down, k) = -component(up, k);
    return down;
  }

 private:
  template <int D> static double depth_of(Vec<D, double> x) {
    return D == 3 ? component(x, D - 1) : 0;
  }
  struct Column {
    double x = NAN, z = NAN, height = 0;
    Vec<3, double> up{};  ///< the unit normal out of the fluid; up.y is 0 if it is not known yet
  };
  double height_at(double x, double z) const;
  Vec<3, double> upward(double x, double z) const;
  /// The column at x and z, with its normal if that is asked for. The columns of a lattice are
  /// asked for often, and a function is slow.
  const Column& at(double x, double z, bool with_normal) const;

  std::shared_ptr<Expressions> function_;
  std::shared_ptr<std::vector<Column>> known_;  ///< by a hash; a later column replaces an earlier
  int dimension_;
  double step_;  ///< of differences [m]
};

/// Calls visit(x, width) for the centre of each column, `width` wide, that divides a box; y is 0.
/// Columns are at most `widest` wide along each horizontal axis, unless there were too many.
template <int D, class F>
void each_column(Vec<D, double> low, Vec<D, double> high, double widest, F visit) {
  Vec<D, double> width{};
  int count[3] = {1, 1, 1};
  for (int k = 0; k < D; ++k) {
    if (k == 1) continue;
    const double length = component(high, k) - component(low, k);
    count[k] = std::max(1, int(std::min(std::ceil(length / widest - 1e-9), D == 3 ? 2e3 : 1e6)));
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

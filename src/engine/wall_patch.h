// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"
#include "freshet/particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A patch of a wall for sums over boundary particles.
template <int D> struct PatchOnWall {
  Vec<D, double> center, axis[D];
  double half[D];
  /// cell: width of a boundary particle's part of the wall [m]; reach: maximum distance of boundary
  /// particles from the patch [m]
  double cell, reach;

  PatchOnWall(const WallPatch& patch, double sample_cell, double support)
      : center(vector(patch.center)), cell(sample_cell), reach(support) {
    for (int d = 0; d < D; ++d) {
      axis[d] = vector(patch.axes[std::size_t(d)]);
      half[d] = patch.half[std::size_t(d)];
    }
  }
  double area() const {
    double all = 1;
    for (int d = 0; d < D; ++d) all *= half[d] > 0 ? 2 * half[d] : 1;
    return all;
  }
  /// The fraction, 0 to 1, of the cell of a boundary particle at x that the patch covers.
  FRESHET_HD double share(Vec<D, double> x) const {
    double all = 1;
    for (int d = 0; d < D; ++d) {
      const double r = dot(x - center, axis[d]), away = r < 0 ? -r : r;
      if (half[d] > 0) all *= covered(away, half[d]);
      else if (away > reach) return 0;
    }
    return all;
  }

 private:
  static Vec<D, double> vector(const Vector& a) {
    if constexpr (D == 3) return {a[0], a[1], a[2]};
    else return {a[0], a[1]};
  }
  FRESHET_HD double covered(double away, double half_length) const {
    const double end = min(half_length, away + cell / 2),
                 start = max(-half_length, away - cell / 2);
    return end > start ? (end - start) / cell : 0;
  }
};

/// The part of the force on boundary particle k along an axis that acts on a patch [m/s^2].
template <int D> struct ForceOnPatch {
  PatchOnWall<D> patch;
  Vec<D, double> axis;
  Field<Vec<D>> x, force;
  FRESHET_HD double operator()(int k) const {
    const double share = patch.share(to_double<D>(x[k]));
    return share > 0 ? share * dot(to_double<D>(force[k]), axis) : 0;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

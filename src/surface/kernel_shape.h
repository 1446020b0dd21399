// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "core/vec.h"

namespace freshet {

/// A symmetric matrix.
struct Symmetric3 {
  float xx, yy, zz, xy, xz, yz;
  Vec<3, float> operator*(Vec<3, float> d) const {
    return {xx * d.x + xy * d.y + xz * d.z, xy * d.x + yy * d.y + yz * d.z,
            xz * d.x + yz * d.y + zz * d.z};
  }
};
inline constexpr Symmetric3 identity3{1, 1, 1, 0, 0, 0};

/// The kernel of a particle: that of a sphere, stretched along axes of its own.
struct KernelShape {
  Symmetric3 shrink = identity3;  ///< maps a distance to that in a round kernel of the same value
  float reach = 1;                ///< the longest axis, of the round kernel's
};

/// The eigenvalues of a symmetric matrix and its unit eigenvectors, by Jacobi rotations [Golub and
/// Van Loan 2013, 8.5]. The number of rotations is fixed, so the bits depend on the matrix only.
struct Eigen3 {
  std::array<double, 3> value;
  std::array<Vec<3, double>, 3> vector;

  explicit Eigen3(const Symmetric3& m) {
    double a[3][3] = {{double(m.xx), double(m.xy), double(m.xz)},
                      {double(m.xy), double(m.yy), double(m.yz)},
                      {double(m.xz), double(m.yz), double(m.zz)}};
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    constexpr int sweeps = 6;  // convergence is quadratic
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (int p = 0; p < 2; ++p)
        for (int q = p + 1; q < 3; ++q) rotate(a, v, p, q);
    for (std::size_t k = 0; k < 3; ++k) {
      value[k] = a[k][k];
      vector[k] = {v[0][k], v[1][k], v[2][k]};
    }
  }

 private:
  /// Makes a[p][q] zero.
  static void rotate(double (&a)[3][3], double (&v)[3][3], int p, int q) {
    if (a[p][q] == 0) return;
    const double half = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (half >= 0 ? 1 : -1) / (std::abs(half) + std::sqrt(half * half + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < 3; ++k) {
      const double x = a[k][p], y = a[k][q];
      a[k][p] = c * x - s * y;
      a[k][q] = s * x + c * y;
    }
    for (int k = 0; k < 3; ++k) {
      const double x = a[p][k], y = a[q][k];
      a[p][k] = c * x - s * y;
      a[q][k] = s * x + c * y;
      const double vx = v[k][p], vy = v[k][q];
      v[k][p] = c * vx - s * vy;
      v[k][q] = s * vx + c * vy;
    }
  }
};

}  // namespace freshet

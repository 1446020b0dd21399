// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The sums of a renormalized density gradient.
template <int D, class R> struct RenormalizedSums {
  Vec<D, R> gradient{};  ///< sum_j (rho_j - rho_i) V_j grad W_ij
  Vec<D, R> row[D]{};    ///< sum_j x_ji (x) V_j grad W_ij, the identity in a full neighbourhood
  FRESHET_HD RenormalizedSums& operator+=(const RenormalizedSums& o) {
    gradient += o.gradient;
    for (int k = 0; k < D; ++k) row[k] += o.row[k];
    return *this;
  }

  /// The solution s of gradient = sum_k s_k row_k, that is L_i applied to the gradient. With too
  /// few neighbours (determinant <= 0.05) the matrix is nearly singular: then the gradient is
  /// returned without renormalization.
  FRESHET_HD Vec<D, R> renormalized() const {
    const Vec<D, R>*a = row, b = gradient;
    constexpr R least = R(0.05f);
    if constexpr (D == 2) {
      const R det = a[0].x * a[1].y - a[0].y * a[1].x;
      if (!(det > least)) return b;
      return {(b.x * a[1].y - b.y * a[1].x) / det, (a[0].x * b.y - a[0].y * b.x) / det};
    } else {
      const Vec<3, R> c0 = cross(a[1], a[2]), c1 = cross(a[2], a[0]), c2 = cross(a[0], a[1]);
      const R det = dot(a[0], c0);
      if (!(det > least)) return b;
      return {dot(b, c0) / det, dot(b, c1) / det, dot(b, c2) / det};
    }
  }

 private:
  FRESHET_HD static Vec<3, R> cross(const Vec<3, R>& a, const Vec<3, R>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// <grad rho>_i = L_i sum_j (rho_j - rho_i) grad W_ij V_j,
/// L_i = (sum_j x_ji (x) grad W_ij V_j)^-1  [Antuono et al. 2010, eq. 7; Randles and Libersky 1996]
///
/// It is exact for a linear density, also at a free surface.
///
///   m [kg/m^(3-D)];  reads rho [kg/m^3] (> 0);  the gradient in kg/m^4
template <int D, template <int> class Kernel> struct DensityGradient {
  Kernel<D> W;
  Real m;
  Field<Real> rho;
  template <class R> struct At { R rho; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {rho[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD RenormalizedSums<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                               const At<R>& j) const {
    const Vec<D, R> VdW = (m / j.rho) * W.gradient(ij);
    RenormalizedSums<D, R> sum;
    sum.gradient = (j.rho - i.rho) * VdW;
    sum.row[0] = -ij.x.x * VdW;
    sum.row[1] = -ij.x.y * VdW;
    if constexpr (D == 3) sum.row[2] = -ij.x.z * VdW;
    return sum;
  }
};
template <int D, template <int> class K, class... A>
DensityGradient(K<D>, A...) -> DensityGradient<D, K>;

/// delta h c0 sum_j V_j psi_ij · grad W_ij,
/// psi_ij = 2 (rho_j - rho_i) x_ji/|x_ij|^2 - <grad rho>_i - <grad rho>_j  [Antuono 2010, eq. 10]
///
///   m [kg/m^(3-D)], delta_h_c = delta h c0 [m^2/s] with h half the support, eps_h2 0.01 h^2 [m^2]
///   reads rho [kg/m^3] (> 0) and <grad rho>;  the sum in kg/(m^3 s)
template <int D, template <int> class Kernel> struct Antuono2010Diffusion {
  Kernel<D> W;
  Real m, delta_h_c, eps_h2;
  Field<Real> rho;
  Field<Vec<D>> gradient;
  template <class R> struct At {
    R rho;
    Vec<D, R> gradient;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {rho[i], gradient[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    const R slope = Real(0.5f) * dot(i.gradient + j.gradient, ij.x);
    const R F = dot(ij.x, W.gradient(ij)) / (ij.r2 + eps_h2);
    return -2 * delta_h_c * m * (j.rho - i.rho + slope) * F / j.rho;
  }
};
template <int D, template <int> class K, class... A>
Antuono2010Diffusion(K<D>, A...) -> Antuono2010Diffusion<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

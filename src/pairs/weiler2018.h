// SPDX-License-Identifier: MIT
/// The diagonal blocks of the equations of a physically consistent implicit viscosity solver for
/// SPH fluids [Weiler, Koschier, Brand, Bender 2018]. Monaghan2005Viscosity computes the product
/// with the full matrix.
#pragma once
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A symmetric D x D matrix: its diagonal, and the elements xy (2D) or yz, xz, xy (3D).
template <int D, class R> struct Symmetric;
template <class R> struct Symmetric<2, R> {
  Vec<2, R> diagonal{};
  R off{};
  FRESHET_HD Symmetric& operator+=(const Symmetric& o) {
    diagonal += o.diagonal;
    off += o.off;
    return *this;
  }
  FRESHET_HD Vec<2, R> operator*(Vec<2, R> a) const {
    return {diagonal.x * a.x + off * a.y, off * a.x + diagonal.y * a.y};
  }
};
template <class R> struct Symmetric<3, R> {
  Vec<3, R> diagonal{}, off{};
  FRESHET_HD Symmetric& operator+=(const Symmetric& o) {
    diagonal += o.diagonal;
    off += o.off;
    return *this;
  }
  FRESHET_HD Vec<3, R> operator*(Vec<3, R> a) const {
    return {diagonal.x * a.x + off.z * a.y + off.y * a.z,
            off.z * a.x + diagonal.y * a.y + off.x * a.z,
            off.y * a.x + off.x * a.y + diagonal.z * a.z};
  }
};

/// The matrix s a a^T.
template <class R> FRESHET_HD Symmetric<2, R> outer(R s, Vec<2, R> a) {
  return {{s * a.x * a.x, s * a.y * a.y}, s * a.x * a.y};
}
template <class R> FRESHET_HD Symmetric<3, R> outer(R s, Vec<3, R> a) {
  return {{s * a.x * a.x, s * a.y * a.y, s * a.z * a.z},
          {s * a.y * a.z, s * a.x * a.z, s * a.x * a.y}};
}

/// (1 + s M)^-1 for a positive semidefinite M and s >= 0.
inline Symmetric<2, Real> inverse_of_one_and(Real s, const Symmetric<2, Real>& M) {
  const Real a = 1 + s * M.diagonal.x, c = 1 + s * M.diagonal.y, b = s * M.off;
  const Real det = a * c - b * b;
  return {{c / det, a / det}, -b / det};
}
inline Symmetric<3, Real> inverse_of_one_and(Real s, const Symmetric<3, Real>& M) {
  const Real a = 1 + s * M.diagonal.x, b = 1 + s * M.diagonal.y, c = 1 + s * M.diagonal.z;
  const Real yz = s * M.off.x, xz = s * M.off.y, xy = s * M.off.z;
  const Real A = b * c - yz * yz, B = a * c - xz * xz, C = a * b - xy * xy;
  const Real YZ = xy * xz - a * yz, XZ = xy * yz - b * xz, XY = xz * yz - c * xy;
  const Real det = a * A + xy * XY + xz * XZ;
  return {{A / det, B / det, C / det}, {YZ / det, XZ / det, XY / det}};
}

/// The factor of a gradient along x_ij: grad W = slope x_ij.
template <int D, class R> FRESHET_HD R slope_of(const Pair<D, R>& ij, Vec<D, R> gradient) {
  return dot(gradient, ij.x) / max(ij.r2, R(Real(1e-30f)));
}

/// M_i = -sum_j 2 m mu_ij/(rho_i rho_j) (D + 2) grad W_ij x_ij^T/(|x_ij|^2 + eps)  [eq. 15]
///
///   m [kg/m^(3-D)], mu [Pa s], eps_h2 1e-4 h^2 [m^2];  reads rho [kg/m^3] (> 0);  the sum in 1/s
template <int D, template <int> class Kernel> struct Weiler2018Block {
  Kernel<D> W;
  Real m, eps_h2;
  PerLiquid mu;
  Field<Real> rho;
  template <class R> struct At { R mu, inv_rho; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {mu[i], 1 / rho[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Symmetric<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                        const At<R>& j) const {
    const R weight = -2 * m * shared_viscosity(i.mu, j.mu) * i.inv_rho * j.inv_rho * Real(D + 2);
    return outer(weight * slope_of(ij, W.gradient(ij)) / (ij.r2 + eps_h2), ij.x);
  }
};
template <int D, template <int> class K, class... A>
Weiler2018Block(K<D>, A...) -> Weiler2018Block<D, K>;

/// M_i += -sum_k 2 psi_k friction_k mu_i/rho_i^2 (D + 2) grad W_ik x_ik^T/(|x_ik|^2 + eps)
///
/// The block of Monaghan2005Akinci: boundary particles at rest.
///
///   psi [kg/m^(3-D)], friction 1 for no slip, 0 for free slip, mu [Pa s], eps_h2 1e-4 h^2 [m^2]
template <int D, template <int> class Kernel> struct Weiler2018AkinciBlock {
  Kernel<D> W;
  Real eps_h2;
  PerLiquid mu;
  Field<Real> rho, psi, friction;
  template <class R> struct At { R mu_rho2; };
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int i) const { return {mu[i] / square(rho[i])}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k] * friction[k]}; }
  template <class R>
  FRESHET_HD Symmetric<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                        const Neighbor<R>& k) const {
    const R weight = Real(-2 * (D + 2)) * k.psi * i.mu_rho2;
    return outer(weight * slope_of(ik, W.gradient(ik)) / (ik.r2 + eps_h2), ik.x);
  }
};
template <int D, template <int> class K, class... A>
Weiler2018AkinciBlock(K<D>, A...) -> Weiler2018AkinciBlock<D, K>;

/// M_i += -sum_k 2 m friction_k mu_i/(rho_i rho0) (D + 2) grad W_ik x_ik^T/(|x_ik|^2 + eps)
///
/// The block of Monaghan2005Adami: layers of walls at rest.
///
///   m [kg/m^(3-D)], rho0 [kg/m^3], friction 1 for no slip, 0 for free slip, mu [Pa s]
template <int D, template <int> class Kernel> struct Weiler2018AdamiBlock {
  Kernel<D> W;
  Real m, rho0, eps_h2;
  PerLiquid mu;
  Field<Real> rho, friction;
  template <class R> struct At { R mu_rho; };
  template <class R> struct Neighbor { R friction; };
  FRESHET_HD At<Real> at(int i) const { return {mu[i] / rho[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {friction[k]}; }
  template <class R>
  FRESHET_HD Symmetric<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                        const Neighbor<R>& k) const {
    const R weight = Real(-2 * (D + 2)) * k.friction * m / rho0 * i.mu_rho;
    return outer(weight * slope_of(ik, W.gradient(ik)) / (ik.r2 + eps_h2), ik.x);
  }
};
template <int D, template <int> class K, class... A>
Weiler2018AdamiBlock(K<D>, A...) -> Weiler2018AdamiBlock<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

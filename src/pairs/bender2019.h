// SPDX-License-Identifier: MIT
/// Pair terms of the foam where water swirls, after the potential of vorticity differences of
/// turbulent micropolar SPH fluids with foam [Bender, Koschier, Kugelstadt, Weiler 2019]. Their
/// fluid has angular velocities as a field; here they are fitted to the velocities around each
/// particle, so that every solver has them.
#pragma once
#include "pairs/ihmsen2012.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Weighted second moments of the neighbours' places around i [m^2], and their angular momentum per
/// mass [m^2/s], which has one component in 2D.
template <int D, class R> struct Bender2019Moments {
  Vec<D, R> squares{}, products{}, momentum{};
  FRESHET_HD Bender2019Moments& operator+=(const Bender2019Moments& o) {
    squares += o.squares;
    products += o.products;
    momentum += o.momentum;
    return *this;
  }
};

/// sum_j w_ij (xx, yy, zz), sum_j w_ij (yz, zx, xy), sum_j w_ij x_ij × v_ij, w = 1 - r/h.
/// Reads v [m/s].
template <int D> struct Bender2019Spin {
  Real h;
  Field<Vec<D>> v;
  template <class R> struct At { Vec<D, R> v; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Bender2019Moments<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                                const At<R>& j) const {
    const R w = ihmsen2012_weight(ij, h);
    const Vec<D, R> x = ij.x, v = i.v - j.v;
    if constexpr (D == 3)
      return {w * Vec<3, R>{x.x * x.x, x.y * x.y, x.z * x.z},
              w * Vec<3, R>{x.y * x.z, x.z * x.x, x.x * x.y}, w * cross(x, v)};
    else return {w * Vec<2, R>{x.x * x.x, x.y * x.y}, {}, {w * (x.x * v.y - x.y * v.x), R(0)}};
  }
};

/// The angular velocity [1/s] of the rigid rotation that fits the moments best: the momentum over
/// the inertia. In 2D it is the first component. A thousandth of the trace is added to the inertia,
/// which is singular where all neighbours lie on a line.
template <int D> FRESHET_HD Vec<D> bender2019_spin(const Bender2019Moments<D, Real>& m) {
  const Vec<D> q = m.squares, l = m.momentum;
  if constexpr (D == 2) {
    const Real inertia = q.x + q.y;
    return {inertia > 0 ? l.x / inertia : 0, 0};
  } else {
    const Vec<D> p = m.products;
    const Real trace = q.x + q.y + q.z;
    if (!(trace > 0)) return {};
    const Real all = Real(1.001f) * trace;
    const Vec<D> a{all - q.x, -p.z, -p.y}, b{-p.z, all - q.y, -p.x}, c{-p.y, -p.x, all - q.z};
    const Vec<D> bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    return (l.x * bc + l.y * ca + l.z * ab) / dot(a, bc);
  }
}

/// Turbulence  sum_j h |omega_i - omega_j| w_ij  [m/s] of the vorticities omega, twice the angular
/// velocities `spin` [1/s].
template <int D> struct Bender2019Turbulence {
  Real h;
  Field<Vec<D>> spin;
  template <class R> struct At { Vec<D, R> spin; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {spin[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Ihmsen2012Mean<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const At<R>& j) const {
    const R w = ihmsen2012_weight(ij, h);
    return {w, w * (R(2 * h) * sqrt(norm2(i.spin - j.spin)))};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

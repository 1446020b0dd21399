// SPDX-License-Identifier: MIT
/// Pair term of the generalized drag force for particle-based simulations [Gissler, Band, Peer,
/// Ihmsen, Teschner 2017]: the part of a particle that is exposed to the air.
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// neighbors: the number of neighbours without the particle itself. hidden: the maximum cosine
/// between the direction to a neighbour and the velocity relative to the air, clamped to 0 from
/// below. 1 is fully hidden.
template <int D, class R> struct Gissler2017Exposure {
  R neighbors{}, hidden{};
  FRESHET_HD Gissler2017Exposure& operator+=(const Gissler2017Exposure& o) {
    neighbors = neighbors + o.neighbors;
    hidden = max(hidden, o.hidden);
    return *this;
  }
};

/// max_j of -u_i · x_ij/|x_ij| with u_i = (v_i - wind)/|v_i - wind|, and the count  [eqs. 12, 15]
///
///   h  support radius [m];  wind [m/s];  reads v [m/s]
template <int D> struct Gissler2017Neighbor {
  Real h;
  Vec<D> wind;
  Field<Vec<D>> v;
  template <class R> struct At { Vec<D, R> u; };
  template <class R> using Neighbor = Nothing<R>;
  FRESHET_HD At<Real> at(int i) const {
    const Vec<D> u = v[i] - wind;
    return {u / max(norm(u), Real(1e-20f))};
  }
  FRESHET_HD Neighbor<Real> neighbor(int) const { return {}; }
  template <class R>
  FRESHET_HD Gissler2017Exposure<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                                  Neighbor<R>) const {
    const R near = select(ij.r < R(h), R(1), R(0)), other = select(ij.r > R(0), near, R(0));
    const R cosine = dot(i.u, ij.x) / max(ij.r, R(Real(1e-20f)));
    return {other, max(other * (Real(-1) * cosine), R(0))};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

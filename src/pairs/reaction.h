// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The acceleration in what a term sums.
template <int D, class R> FRESHET_HD Vec<D, R> acceleration(const Vec<D, R>& sum) { return sum; }

/// The other side of a wall's term: what particles i do to sample k, per mass of a particle.
template <int D, class TermT> struct Reaction {
  TermT term;
  template <class R> using At = typename TermT::template Neighbor<R>;
  template <class R> using Neighbor = typename TermT::template At<R>;
  FRESHET_HD At<Real> at(int k) const { return term.neighbor(k); }
  FRESHET_HD Neighbor<Real> neighbor(int i) const { return term.at(i); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ki, const At<R>& k,
                                  const Neighbor<R>& i) const {
    return R(-1) * acceleration(term(Pair<D, R>(R(-1) * ki.x), i, k));
  }
};

/// Keeps such a sum [m/s^2].
template <int D> struct StoreForce {
  Field<Vec<D>> force;
  FRESHET_HD void operator()(int k, const Vec<D>& sum) const { force[k] = sum; }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

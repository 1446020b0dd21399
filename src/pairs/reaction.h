// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The acceleration in the sum of a pair term [m/s^2].
template <int D, class R> FRESHET_HD Vec<D, R> acceleration(const Vec<D, R>& sum) { return sum; }

/// The reaction of a wall's pair term: the force of the fluid particles i on boundary particle k,
/// over the mass of a fluid particle [m/s^2].
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

/// A finish that stores the sum of a Reaction [m/s^2].
template <int D> struct StoreForce {
  Field<Vec<D>> force;
  FRESHET_HD void operator()(int k, const Vec<D>& sum) const { force[k] = sum; }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

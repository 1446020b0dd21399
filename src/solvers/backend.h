// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>

#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

struct AnyTerm {  ///< the least that a pair term has
  template <class R> struct At { R a; };
  template <class R> struct Neighbor { R b; };
  At<Real> at(int) const;
  Neighbor<Real> neighbor(int) const;
  template <class P, class R> R operator()(const P&, At<R>, Neighbor<R>) const;
};
struct AnyFinish {
  void operator()(int, Real) const;
};
struct AnyVisit {
  void operator()(int) const;
};
struct AnyMap {
  Real operator()(int) const;
};

/// The verbs that a solver is written in. The name that each call carries labels the timing table.
/// A pass sees every field as it was before the pass.
template <class B, int D>
concept Backend = requires(B b, Particles<D> p, Particles<D> wall, Real h, AnyTerm term,
                           AnyFinish finish, AnyVisit visit, AnyMap map) {
  /// For every i of p the particles j of each set with |x_ij| < h, i itself among them, and copies
  /// of j. Makes the copies of p anew, and may sort the fields of p (the first time of all sets).
  b.find_neighbors("", h, p, wall);
  /// The same for targets that stand still, over a set whose neighbours have been found: by where
  /// its particles were then.
  b.list_neighbors("", h, wall, p);
  /// finish(i, sum_j term(pair, at(i), neighbor(j))), set by set, cell by cell, by id in a cell;
  /// copies after all others.
  b.sum_pairs("", p, over(p, term), finish);
  b.sum_pairs("", p, over(p, term), over(wall, term), finish);
  /// visit(i) for every particle.
  b.for_each("", p, visit);
  /// Copies of particles (periodic images, ghosts, halos) learn new values of these fields.
  b.share("", p, p.x, p.v);
  /// max_i map(i), and sum_i map(i): independent of threads, sums by fixed point.
  { b.max("", p, map) } -> std::convertible_to<double>;
  { b.sum("", p, map) } -> std::convertible_to<double>;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

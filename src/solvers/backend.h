// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>

#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

struct AnyTerm {  ///< the members that every pair term has
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

/// The verbs of a backend, in which solvers are written. The name in each call is its line in the
/// timing table. A pass sees every field as it was before the pass.
template <class B, int D>
concept Backend = requires(B b, Particles<D> p, Particles<D> wall, Real h, AnyTerm term,
                           AnyFinish finish, AnyVisit visit, AnyMap map) {
  /// Finds, for every particle i of p, the particles j and copies of each set with |x_ij| < h [m],
  /// including i itself; with p.skin some farther ones too, for which terms are zero. It may create
  /// the copies of p again, and sort p and sets that move; the first call may sort all sets.
  b.find_neighbors("", h, p, wall);
  /// Finds the neighbours of other targets in a set p that find_neighbors has searched. It uses the
  /// positions of p at that search.
  b.list_neighbors("", h, wall, p);
  /// Calls finish(i, sum_j term(pair, at(i), neighbor(j))). The order of j is by set, by cell, by
  /// id in a cell; copies are last. Sums of terms by only_where() are computed where they are
  /// needed.
  b.sum_pairs("", p, over(p, term), finish);
  b.sum_pairs("", p, over(p, term), over(wall, term), finish);
  /// Calls visit(i) for every particle.
  b.for_each("", p, visit);
  /// Updates these fields at the copies of particles (periodic images, ghosts, halos).
  b.share("", p, p.x, p.v);
  /// max_i map(i) and sum_i map(i). They do not depend on the number of threads: sums are in fixed
  /// point.
  { b.max("", p, map) } -> std::convertible_to<double>;
  { b.sum("", p, map) } -> std::convertible_to<double>;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

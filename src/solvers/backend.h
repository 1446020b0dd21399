// SPDX-License-Identifier: MIT
#pragma once
#include <concepts>

#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

struct AnyTerm {  ///< the least that a pair term has
  template <class R> struct At { R a; };
  At<Real> at(int) const;
  template <class P, class R> R operator()(const P&, At<R>, At<R>) const;
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
concept Backend = requires(B b, Particles<D> p, Real h, AnyTerm term, AnyFinish finish,
                           AnyVisit visit, AnyMap map) {
  /// For every i the neighbours j with |x_ij| < h, i itself among them.
  b.find_neighbors("", h, p);
  /// finish(i, sum_j term(pair, at(i), at(j))) over the neighbours, in the backend's fixed order.
  b.sum_pairs("", p, term, finish);
  /// visit(i) for every particle.
  b.for_each("", p, visit);
  /// Copies of particles (periodic images, ghosts, halos) learn new values of these fields.
  b.share("", p.x, p.v);
  /// sum_i map(i) and max_i map(i), independent of threads.
  { b.sum("", p, map) } -> std::convertible_to<double>;
  { b.max("", p, map) } -> std::convertible_to<double>;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

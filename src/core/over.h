// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <tuple>
#include <utility>

#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A pair term and the set of particles j that it sums over.
template <int D, class TermT> struct Over {
  using Term = TermT;
  Particles<D> set;
  Term term;
  int only_copies_of =
      -1;  ///< index of a rule (boundary/copy_rule.h): sums over its copies only; -1: over all j
  template <class R>
  using Sum = decltype(std::declval<Term>()(std::declval<Pair<D, R>>(),
                                            std::declval<typename Term::template At<R>>(),
                                            std::declval<typename Term::template Neighbor<R>>()));
};
template <int D, class Term> Over<D, Term> over(const Particles<D>& set, const Term& term) {
  return {set, term};
}
template <int D, class Term>
Over<D, Term> over_copies(int rule, const Particles<D>& set, const Term& term) {
  return {set, term, rule};
}

/// A term whose sum is needed at the particles with where(i) only. A backend may compute the sums
/// of other particles or not: `finish` must not use them.
template <class Term, class Where> struct OnlyWhere : Term {
  Where where;
  FRESHET_HD bool wants(int i) const { return where(i); }
};
template <class Term, class Where>
OnlyWhere<Term, Where> only_where(const Where& where, const Term& term) {
  return {term, where};
}

/// Calls f(last, others...). A verb takes its sources first and its finish last.
template <class F, class... A> void with_last_first(const F& f, const A&... a) {
  constexpr std::size_t last = sizeof...(A) - 1;
  const auto all = std::tie(a...);
  [&]<std::size_t... k>(std::index_sequence<k...>) { f(std::get<last>(all), std::get<k>(all)...); }
  (std::make_index_sequence<last>());
}

}  // namespace FRESHET_ISA
}  // namespace freshet

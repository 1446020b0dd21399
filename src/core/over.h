// SPDX-License-Identifier: MIT
#pragma once
#include <utility>

#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A pair term and the set of particles j that it sums over.
template <int D, class TermT> struct Over {
  using Term = TermT;
  Particles<D> set;
  Term term;
  template <class R>
  using Sum = decltype(std::declval<Term>()(std::declval<Pair<D, R>>(),
                                            std::declval<typename Term::template At<R>>(),
                                            std::declval<typename Term::template Neighbor<R>>()));
};
template <int D, class Term> Over<D, Term> over(const Particles<D>& set, const Term& term) {
  return {set, term};
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "backend/group_sums.h"
#include "backend/reference/reference_sets.h"
#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The reference for tests of every other backend: scalar, one thread, neighbours in a fixed order.
/// Particles stay in the order of their ids.
template <int D> class ReferenceBackend : public ReferenceSets<D> {
 public:
  using ReferenceSets<D>::ReferenceSets;

  template <class... Args>
  void sum_pairs(const char* name, const Particles<D>& targets, const Args&... sources_finish) {
    with_last_first([&](const auto& finish,
                        const auto&... sources) { sum_over(name, targets, finish, sources...); },
                    sources_finish...);
  }

  template <class Visit>
  void for_each(const char* name, const Particles<D>& p, const Visit& visit) {
    const auto timer = timings_.time(name, p.n);
    for (int i = 0; i < p.n; ++i) visit(i);
  }

  template <class Map> double max(const char* name, const Particles<D>& p, const Map& map) {
    const auto timer = timings_.time(name, p.n);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < p.n; ++i) most = std::max(most, double(map(i)));
    return most;
  }

  template <class Map> double sum(const char* name, const Particles<D>& p, const Map& map) {
    if (p.n == 0) return 0;
    const FixedPoint fixed(max(name, p, [&](int i) { return std::abs(double(map(i))); }), p.n);
    std::int64_t total = 0;
    for (int i = 0; i < p.n; ++i) total += fixed.whole(map(i));
    return fixed.value(total);
  }

  /// sums[g] = the sum of map(i).value over the particles with map(i).group == g, in fixed point.
  template <class Map, class Sum>
  void sum_groups(const char* name, const Particles<D>& p, int groups, const Map& map, Sum* sums) {
    const auto timer = timings_.time(name, p.n);
    group_sums_.add(p.n, groups, map, sums);
  }

 private:
  using ReferenceSets<D>::copies_, ReferenceSets<D>::lists_, ReferenceSets<D>::timings_;

  template <class Finish, class First, class... More>
  void sum_over(const char* name, const Particles<D>& targets, const Finish& finish,
                const First& first, const More&... more) {
    const auto timer = timings_.time(name, targets.n);
    using Sum = typename First::template Sum<Real>;
    Sum* sums = scratch<Sum>(sum_memory_, std::size_t(targets.n));
    std::fill_n(sums, targets.n, Sum{});
    add(targets, first, sums);
    (add(targets, more, sums), ...);
    for (int i = 0; i < targets.n; ++i) finish(i, sums[i]);  // after all sums, which see old fields
  }

  template <class Term, class Sum>
  void add(const Particles<D>& targets, const Over<D, Term>& sources, Sum* sums) {
    using Neighbor = typename Term::template Neighbor<Real>;
    if (targets.n == 0 || sources.set.n == 0) return;  // they have no lists
    const auto& lists = lists_.at({targets.set, sources.set.set});
    const int n = sources.set.n + sources.set.copies;
    Neighbor* neighbor = scratch<Neighbor>(neighbor_memory_, std::size_t(n));
    for (int j = 0; j < n; ++j) neighbor[j] = sources.term.neighbor(j);
    for (int i = 0; i < targets.n; ++i) {
      if constexpr (requires { sources.term.wants(0); })
        if (!sources.term.wants(i)) continue;
      const auto at_i = sources.term.at(i);
      Sum sum = sums[i];
      for (const int j : lists[i]) {
        if (!counts(sources, j)) continue;
        sum += sources.term(Pair<D, Real>(targets.x[i] - sources.set.x[j]), at_i, neighbor[j]);
      }
      sums[i] = sum;
    }
  }

  template <class Term> bool counts(const Over<D, Term>& over, int j) const {
    if (over.only_copies_of < 0) return true;
    const int k = j - over.set.n;
    return k >= 0 && copies_[std::size_t(over.set.set)].due_to(k, over.only_copies_of);
  }

  template <class T> static T* scratch(std::vector<std::byte>& memory, std::size_t n) {
    if (memory.size() < n * sizeof(T)) memory.resize(n * sizeof(T));
    return reinterpret_cast<T*>(memory.data());
  }

  std::vector<std::byte> neighbor_memory_, sum_memory_;
  GroupSums group_sums_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
